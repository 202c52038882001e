// SPDX-License-Identifier: MIT
#include "run/md_gas.hpp"

#include <cmath>
#include <limits>

#include "files/atomic_write.hpp"
#include "files/provenance.hpp"
#include "md/h5md.hpp"
#include "run/md_frame.hpp"

namespace shaken::run {

namespace {

struct Sampled {
    md::Ledger ledger;
    md::Counters counters;
    double temperature, fourth_moment, displacement;
};

const Recording<Sampled> recording({
    {"temperature", "g sigma", [](const Sampled& s) { return s.temperature; }},
    {"fourth_cumulant", "1",
     [](const Sampled& s) { return s.fourth_moment / (15.0 * s.temperature * s.temperature) - 1.0; }},
    {"kinetic_energy", "m g sigma", [](const Sampled& s) { return s.ledger.kinetic; }},
    {"rotational_energy", "m g sigma", [](const Sampled& s) { return s.ledger.rotational; }},
    {"collision_loss", "m g sigma", [](const Sampled& s) { return s.ledger.collision_loss; }},
    {"momentum_x", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.momentum[0]; }},
    {"momentum_y", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.momentum[1]; }},
    {"momentum_z", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.momentum[2]; }},
    {"virial", "m g sigma", [](const Sampled& s) { return s.ledger.virial; }},
    {"pair_collisions", "1", [](const Sampled& s) { return static_cast<double>(s.counters.pair_collisions); }},
    {"mean_square_displacement", "sigma^2", [](const Sampled& s) { return s.displacement; }},
});

}  // namespace

MdGasRecord::MdGasRecord(const scene::Scene& scene)
    : scene_(scene), schedule_(scene), window_(diffusion_window(scene)) {}

double MdGasRecord::displacement(const md::Snapshot& snapshot, std::int64_t sample) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const std::int64_t since = sample - schedule_.settling_samples();
    if (window_ == 0 || since < 0) return unknown;
    if (since % window_ == 1 || window_ == 1 || moved_.empty()) moved_.assign(snapshot.position.size(), {});
    if (since > 0)
        for (std::size_t i = 0; i < moved_.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const double step = snapshot.position[i][k] - last_[i][k];
                moved_[i][k] += step - scene_.box.x * std::nearbyint(step / scene_.box.x);
            }
    last_ = snapshot.position;
    const auto count = static_cast<double>(moved_.size());
    double mean = 0.0;
    for (const auto& m : moved_) mean += (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) / count;
    return mean;
}

void MdGasRecord::sample(const md::Simulation& simulation, const scene::Instant& at, const Emit& emit) {
    const md::Snapshot snapshot = simulation.snapshot();
    const auto count = static_cast<double>(snapshot.velocity.size());
    double second = 0.0, fourth = 0.0;
    for (const auto& v : snapshot.velocity) {
        const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        second += square / count;
        fourth += square * square / count;
    }
    const std::int64_t sample = schedule_.sample(at);
    recording.emit(sample, schedule_.time(at),
                   {simulation.ledger(), simulation.counters(), second / 3.0, fourth, displacement(snapshot, sample)},
                   emit);
    if (schedule_.is_frame(at)) emit(Stream::frame, packed(snapshot));
}

void MdGasRecord::save(files::CheckpointWriter& out) const {
    out.put("last", last_);
    out.put("moved", moved_);
}

void MdGasRecord::restore(const files::CheckpointReader& in) {
    last_ = in.take<std::array<double, 3>>("last");
    moved_ = in.take<std::array<double, 3>>("moved");
}

void MdGasRecord::write(const Output& output) const {
    const md::Box box{scene_.box.x, scene_.box.y, scene_.box.ceiling, true, std::nullopt};
    md::H5mdWriter writer(output.aside(), box, {output.scene_text, scene_.md.seed, output.parent});
    const auto append = [&](std::span<const double> record) {
        const md::Snapshot frame = unpacked(record);
        writer.append(frame, frame.cycle, static_cast<double>(frame.cycle) * scene_.uniform.interval);
    };
    write_streams(writer.file(), output, {recording.names(), append});
    write_spent(writer.file(), output.spent);
    writer.close();
    std::filesystem::rename(output.aside(), output.path);
    files::write_atomically(output.path.parent_path() / "summary.json", gas_summary(gas_results(scene_, output.path)));
}

std::vector<Measured> gas_results(const scene::Scene& scene, const std::filesystem::path& file) {
    return gas_results(scene, fields::TimeSeries::read(files::Hdf5File(file, files::Open::read),
                                                       {"temperature", "fourth_cumulant", "virial", "pair_collisions",
                                                        "mean_square_displacement"}));
}

}  // namespace shaken::run
