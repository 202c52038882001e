// SPDX-License-Identifier: MIT
#include "run/md_layer.hpp"

#include <cmath>

#include "files/provenance.hpp"
#include "md/h5md.hpp"
#include "run/emit.hpp"
#include "run/md_frame.hpp"

namespace shaken::run {

namespace {

struct Sampled {
    md::Ledger ledger;
    md::Counters counters;
    double height;  // of the centre of mass, lab frame
};

double number(std::int64_t count) { return static_cast<double>(count); }

const Recording<Sampled> recording({
    {"centre_of_mass", "sigma", [](const Sampled& s) { return s.height; }},
    {"kinetic_energy", "m g sigma", [](const Sampled& s) { return s.ledger.kinetic; }},
    {"rotational_energy", "m g sigma", [](const Sampled& s) { return s.ledger.rotational; }},
    {"potential_energy", "m g sigma", [](const Sampled& s) { return s.ledger.potential; }},
    {"plate_work", "m g sigma", [](const Sampled& s) { return s.ledger.plate_work; }},
    {"ceiling_work", "m g sigma", [](const Sampled& s) { return s.ledger.ceiling_work; }},
    {"collision_loss", "m g sigma", [](const Sampled& s) { return s.ledger.collision_loss; }},
    {"plate_loss", "m g sigma", [](const Sampled& s) { return s.ledger.plate_loss; }},
    {"ceiling_loss", "m g sigma", [](const Sampled& s) { return s.ledger.ceiling_loss; }},
    {"momentum_x", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.momentum[0]; }},
    {"momentum_y", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.momentum[1]; }},
    {"momentum_z", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.momentum[2]; }},
    {"plate_impulse", "m sqrt(g sigma)", [](const Sampled& s) { return s.ledger.plate_impulse; }},
    {"pair_collisions", "1", [](const Sampled& s) { return number(s.counters.pair_collisions); }},
    {"plate_collisions", "1", [](const Sampled& s) { return number(s.counters.plate_collisions); }},
    {"ceiling_collisions", "1", [](const Sampled& s) { return number(s.counters.ceiling_collisions); }},
});

}  // namespace

MdLayerRecord::MdLayerRecord(const scene::Scene& scene)
    : scene_(scene), schedule_(scene), sampler_(scene, fields::Heights::passed_on) {}

void MdLayerRecord::sample(const md::Simulation& simulation, const scene::Instant& at, const Emit& emit) {
    const md::Snapshot snapshot = simulation.snapshot();
    sampler_.sample(snapshot, at);
    emit_maps(sampler_, emit);
    emit_height(schedule_, at, sampler_.moments().latest_centre_of_mass(), emit);
    double height = 0.0;
    for (const auto& position : snapshot.position) height += position[2];
    recording.emit(schedule_.sample(at), schedule_.time(at),
                   {simulation.ledger(), simulation.counters(), height / number(simulation.particles())}, emit);
    if (schedule_.is_frame(at)) emit(Stream::frame, packed(snapshot));
}

void MdLayerRecord::write(const Output& output) const {
    const md::Box box{scene_.box.x, scene_.box.y, scene_.box.ceiling, false, scene_.motion};
    md::H5mdWriter writer(output.aside(), box, {output.scene_text, scene_.md.seed, output.parent});
    std::vector<double> phases;
    const auto append = [&](std::span<const double> record) {
        const md::Snapshot frame = unpacked(record);
        const double period = scene_.motion.period();
        phases.push_back(frame.time_in_cycle / period);
        const double step = (number(frame.cycle) + phases.back()) * number(schedule_.phases());
        writer.append(frame, std::llround(step), number(frame.cycle) * period + frame.time_in_cycle);
    };
    write_streams(writer.file(), output, {recording.names(), append, schedule_, sampler_.maps().grid()});
    writer.file().write("/particles/all/phase", phases);
    sampler_.moments().write(writer.file(), "/profiles");
    write_spent(writer.file(), output.spent);
    writer.close();
    std::filesystem::rename(output.aside(), output.path);
}

}  // namespace shaken::run
