// SPDX-License-Identifier: MIT
#include "app/uniform_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "app/md_run.hpp"
#include "app/uniform_blocks.hpp"
#include "fields/memory.hpp"
#include "files/atomic_write.hpp"
#include "files/provenance.hpp"
#include "md/h5md.hpp"
#include "md/hard_sphere_theory.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

namespace theory = md::theory;

/// What is recorded at every sample instant, in the order of UniformRun::advance_and_sample.
const std::vector<std::string> columns{
    "temperature", "fourth_cumulant", "kinetic_energy", "rotational_energy", "collision_loss",          "momentum_x",
    "momentum_y",  "momentum_z",      "virial",         "pair_collisions",   "mean_square_displacement"};

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The constant restitution of smooth spheres, where the scene has one.
std::optional<double> constant_restitution(const scene::Scene& scene) {
    const auto* constant = std::get_if<scene::RestitutionConstant>(&scene.particles.restitution);
    const bool plain = scene.particles.friction.law == scene::FrictionLaw::none &&
                       scene.particles.collapse == scene::CollapseRemedy::none;
    return constant && plain ? std::optional(constant->e0) : std::nullopt;
}

/// Twice the intervals in which velocities are forgotten: by twenty collisions of a particle, and by the slowest shear
/// wave of the box, whose decay carries the tail of the velocity correlation (Alder and Wainwright 1970), to exp(-3).
/// In the second half displacements grow by 6 D t. 0 where the gas has no steady state, or moves too far between
/// samples to be followed through the box.
std::int64_t diffusion_window(const scene::Scene& scene) {
    if (constant_restitution(scene) != 1.0) return 0;
    const double root = std::sqrt(scene.initial.temperature);
    constexpr double fastest = 6.0;  // in sqrt(T): one particle in 10^7 is faster
    if (fastest * root * scene.uniform.interval > 0.5 * scene.box.x) return 0;
    const double phi = scene.initial.volume_fraction, wave_number = 2.0 * std::numbers::pi / scene.box.x;
    const double kinematic_viscosity = theory::viscosity(phi) / (6.0 * phi / std::numbers::pi);
    const double forgets =
        std::max(20.0 / theory::collision_rate(phi), 3.0 / (kinematic_viscosity * wave_number * wave_number)) / root;
    return 2 * std::max<std::int64_t>(1, std::llround(std::ceil(forgets / scene.uniform.interval)));
}

Measured mean_of(std::string name, std::span<const double> samples, std::optional<double> reference,
                 std::string source) {
    const fields::MeanWithMemory found = fields::mean_with_memory(samples);
    const double independent = static_cast<double>(samples.size()) / (2.0 * found.memory);
    return {std::move(name), found.mean, found.error, independent, !found.is_long_enough, reference, std::move(source)};
}

/// The growth of T^(-7/8) in the second half of the time over that in the first, from the growth in each interval.
Measured later_growth(const std::vector<double>& late) {
    const auto half = late.size() / 2;
    const Measured early = mean_of("", std::span(late).first(half), std::nullopt, "");
    const Measured later = mean_of("", std::span(late).subspan(half), std::nullopt, "");
    const double ratio = later.value / early.value;
    return {"growth of T^(-7/8), second half / first",
            ratio,
            std::abs(ratio) * std::hypot(early.error / early.value, later.error / later.value),
            std::min(early.independent, later.independent),
            early.is_too_short || later.is_too_short,
            1.0,
            "T ~ t^(-8/7), the limit of T far below v0^2"};
}

}  // namespace

UniformRun::UniformRun(const scene::Scene& scene)
    : scene_(scene),
      schedule_(scene),
      simulation_(scene, md_options_of(scene)),
      series_(columns),
      window_(diffusion_window(scene)) {}

void UniformRun::follow(const md::Snapshot& snapshot) {
    const std::int64_t since = next_ - schedule_.settling_samples();
    if (since < 0) return;
    if (since % window_ == 1 || window_ == 1 || moved_.empty()) moved_.assign(snapshot.position.size(), {});
    if (since > 0)
        for (std::size_t i = 0; i < moved_.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const double step = snapshot.position[i][k] - last_[i][k];
                moved_[i][k] += step - scene_.box.x * std::nearbyint(step / scene_.box.x);
            }
    last_ = snapshot.position;
}

bool UniformRun::advance_and_sample(const AskedToStop& asked_to_stop) {
    while (!simulation_.advance_to(next_, 0.0, predictions_between_looks))
        if (asked_to_stop()) return false;
    const md::Snapshot snapshot = simulation_.snapshot();
    const auto count = static_cast<double>(snapshot.velocity.size());
    double second = 0.0, fourth = 0.0;
    for (const auto& v : snapshot.velocity) {
        const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        second += square / count;
        fourth += square * square / count;
    }
    const double temperature = second / 3.0;
    double displacement = unknown;
    if (window_ > 0) {
        follow(snapshot);
        if (!moved_.empty()) {
            displacement = 0.0;
            for (const auto& m : moved_) displacement += (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) / count;
        }
    }
    const md::Ledger l = simulation_.ledger();
    series_.add(next_, schedule_.time(schedule_.instant(next_)),
                std::array{temperature, fourth / (15.0 * temperature * temperature) - 1.0, l.kinetic, l.rotational,
                           l.collision_loss, l.momentum[0], l.momentum[1], l.momentum[2], l.virial,
                           static_cast<double>(simulation_.counters().pair_collisions), displacement});
    if (schedule_.is_frame(schedule_.instant(next_))) frames_.push_back(snapshot);
    ++next_;
    return true;
}

std::vector<Measured> UniformRun::results() const {
    const auto first = static_cast<std::size_t>(schedule_.settling_samples());
    if (series_.rows() < first + 2) return {};
    const auto count = static_cast<double>(scene_.number_of_particles);
    const double phi = scene_.initial.volume_fraction;
    const auto at = [&](std::size_t row, const char* column) { return series_.value(row, column); };
    const UniformBlocks blocks = uniform_blocks(series_, first, count);
    const std::optional<double> e = constant_restitution(scene_);
    std::vector<Measured> all;
    const Measured a2 = mean_of("fourth cumulant a2", blocks.cumulant, std::nullopt, "");
    const std::string klm = "Kolafa, Labik and Malijevsky 2004";
    const std::string of_few = " for N particles (Lebowitz and Percus 1961)";
    const std::string inelastic = e == 1.0 ? "" : ", to first order in the measured a2";
    all.push_back(mean_of("compressibility Z = p/(nT)", blocks.compressibility,
                          e ? std::optional(theory::compressibility(phi, *e, count)) : std::nullopt,
                          (e == 1.0 ? klm : klm + " times (1 + e)/2") + of_few));
    if (e == 1.0)
        all.push_back(mean_of("compressibility Z = p/(nT)", blocks.compressibility,
                              theory::compressibility_carnahan_starling(phi, count),
                              "Carnahan and Starling 1969" + of_few));
    all.push_back(
        mean_of("collision rate / sqrt(T)", blocks.rate,
                e ? std::optional(theory::collision_rate(phi, e == 1.0 ? 0.0 : a2.value, count)) : std::nullopt,
                "Enskog with chi of " + klm + of_few + inelastic));
    all.push_back(a2);
    if (e) {
        all.back().reference = e == 1.0 ? -2.0 / (3.0 * count - 1.0) : theory::cooling_cumulant(*e);
        all.back().source =
            e == 1.0 ? "Maxwell, of N particles with one energy" : "van Noije and Ernst 1998, first order";
    }
    if (e && *e < 1.0)
        all.push_back(mean_of("growth of 1/sqrt(T)", blocks.cooling, theory::cooling_rate(phi, *e, a2.value, count),
                              "Haff 1983 with chi of " + klm + of_few + inelastic));
    if (std::holds_alternative<scene::RestitutionVelocity>(scene_.particles.restitution)) {
        const auto power = [&](std::size_t row) { return std::pow(at(row, "temperature"), -0.875); };
        std::vector<double> late;
        for (std::size_t row = first + 1; row < series_.rows(); ++row)
            late.push_back((power(row) - power(row - 1)) / scene_.uniform.interval);
        if (late.size() > 1) all.push_back(later_growth(late));
    }
    if (window_ > 0) {
        std::vector<double> diffusion;
        const auto w = static_cast<std::size_t>(window_);
        for (std::size_t end = first + w; end < series_.rows(); end += w) {
            const double grown = at(end, "mean_square_displacement") - at(end - w / 2, "mean_square_displacement");
            const double root = std::sqrt(at(end, "temperature"));
            diffusion.push_back(grown / (6.0 * static_cast<double>(w / 2) * scene_.uniform.interval * root));
        }
        if (!diffusion.empty())
            all.push_back(mean_of("self-diffusion / sqrt(T)", diffusion, theory::self_diffusion(phi, scene_.box.x),
                                  "Erpenbeck and Wood 1991 in a cube of this side (Yeh and Hummer 2004)"));
    }
    // The theory of the fluid ends where it freezes; of the crystal the pressure is known.
    if (phi > theory::freezing) {
        for (Measured& m : all)
            if (m.name != a2.name) m.reference.reset();
        if (e == 1.0 && phi >= theory::melting) {
            all.front().reference = theory::compressibility_crystal(phi);
            all.front().source = "Speedy 1998, infinite face-centred cubic crystal";
        }
    }
    return all;
}

void UniformRun::save(files::CheckpointWriter& out, const Spent& spent) const {
    out.put_text("scene", scene::print_scene(scene_));
    out.put_text("engine", name());
    out.put("next_sample", next_);
    out.put("spent", spent);
    simulation_.save(out);
    series_.save(out, "series/");
    out.put("last", last_);
    out.put("moved", moved_);
    out.put("frames/count", static_cast<std::int64_t>(frames_.size()));
    for (std::size_t i = 0; i < frames_.size(); ++i) save_frame(out, i, frames_[i]);
}

void UniformRun::restore(const files::CheckpointReader& in) {
    next_ = in.take_one<std::int64_t>("next_sample");
    simulation_.restore(in);
    series_.restore(in, "series/");
    last_ = in.take<std::array<double, 3>>("last");
    moved_ = in.take<std::array<double, 3>>("moved");
    frames_.resize(static_cast<std::size_t>(in.take_one<std::int64_t>("frames/count")));
    for (std::size_t i = 0; i < frames_.size(); ++i) frames_[i] = restore_frame(in, i);
}

void UniformRun::write(const std::filesystem::path& path, const Spent& spent, const std::string& parent) const {
    const std::filesystem::path aside = path.string() + ".part";
    const md::Box box{scene_.box.x, scene_.box.y, scene_.box.ceiling, true, std::nullopt};
    md::H5mdWriter writer(aside, box, {scene::print_scene(scene_), scene_.md.seed, parent});
    for (const md::Snapshot& frame : frames_)
        writer.append(frame, frame.cycle, static_cast<double>(frame.cycle) * scene_.uniform.interval);
    files::Hdf5File& file = writer.file();
    series_.write(file);
    file.make_group("/run");
    file.attribute("/run", "wall_seconds", spent.wall);
    file.attribute("/run", "cpu_seconds", spent.cpu);
    writer.close();
    std::filesystem::rename(aside, path);

    nlohmann::ordered_json summary = nlohmann::ordered_json::array();
    for (const Measured& m : results()) {
        nlohmann::ordered_json entry{{"name", m.name},
                                     {"measured", m.value},
                                     {"standard_error", m.error},
                                     {"independent_samples", m.independent},
                                     {"too_short", m.is_too_short}};
        if (m.reference) {
            entry["reference"] = *m.reference;
            entry["source"] = m.source;
        }
        summary.push_back(entry);
    }
    files::write_atomically(path.parent_path() / "summary.json", summary.dump(2) + "\n");
}

}  // namespace shaken::app
