// SPDX-License-Identifier: MIT
#include "md/initial_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/checkpoint.hpp"
#include "files/errors.hpp"
#include "files/hdf5.hpp"
#include "md/errors.hpp"
#include "md/h5md.hpp"
#include "md/moving_frame.hpp"
#include "md/neighbour_lists.hpp"
#include "md/particle.hpp"
#include "scene/errors.hpp"
#include "scene/schedule.hpp"

namespace shaken::md {

namespace {

/// A state with what the scene must agree with.
struct Stored {
    Snapshot state;
    std::array<double, 3> box{};
    double phase = 0.0;
};

/// Phases apart by whole cycles are the same.
double distance(double one, double other) { return std::abs(std::remainder(one - other, 1.0)); }
constexpr double same_phase = 1e-9;  // round-off of a time divided by a period

[[noreturn]] void refuse_phase(const scene::Initial& initial, double nearest) {
    throw scene::SceneError({}, fmt::format("initial.phase = {}: {} holds no state there; the nearest is at {:.6g}",
                                            initial.phase, initial.file, nearest));
}

Stored read_checkpoint(const scene::Initial& initial) {
    const files::CheckpointReader in(initial.file);
    if (const std::string engine = in.take_text("engine"); engine != "md")
        throw files::Damaged(fmt::format("{}: is a checkpoint of {}, not of md", initial.file, engine));
    const auto system = in.take<double>("md.system");
    if (system.size() < 4) throw files::Damaged(initial.file + ": no box and period");
    Stored stored;
    stored.box = {system[0], system[1], system[2]};
    stored.state.time_in_cycle = in.take_one<double>("md.now");
    stored.phase = stored.state.time_in_cycle / system[3];
    const auto frame = in.take_one<MovingFrame>("md.frame");
    const double now = stored.state.time_in_cycle;
    const Periodic x(system[0]), y(system[1]);
    const Periodic z = frame.gravity == 0.0 ? Periodic(system[2]) : Periodic();
    const auto particles = in.take<Particle>("md.particles");
    stored.state.position.resize(particles.size());
    stored.state.velocity.resize(particles.size());
    for (Particle p : particles) {
        if (p.id >= particles.size()) throw files::Damaged(initial.file + ": a particle has no number");
        p.move_to(now);
        stored.state.position[p.id] = {x.wrapped(p.x), y.wrapped(p.y), z.wrapped(p.z) + frame.displacement(now)};
        stored.state.velocity[p.id] = {p.velocity_x, p.velocity_y, p.velocity_z + frame.velocity(now)};
    }
    if (in.has("md.spins")) stored.state.spin = in.take<std::array<double, 3>>("md.spins");
    return stored;
}

Stored read_trajectory(const scene::Initial& initial) {
    H5mdFrames read = read_h5md(initial.file);
    if (read.frames.empty()) throw files::Damaged(initial.file + ": no frame");
    std::size_t chosen = read.frames.size() - 1;
    double phase = initial.phase;
    if (!read.phase.empty()) {
        for (std::size_t i = read.phase.size(); i-- > 0;)
            if (distance(read.phase[i], initial.phase) < distance(read.phase[chosen], initial.phase)) chosen = i;
        phase = read.phase[chosen];
    }
    return {std::move(read.frames[chosen]), read.box, phase};
}

}  // namespace

Snapshot read_start(const scene::Scene& scene) {
    const scene::Initial& initial = scene.initial;
    Stored stored = files::Hdf5File::is_readable(initial.file) ? read_trajectory(initial) : read_checkpoint(initial);
    const std::size_t found = stored.state.position.size();
    if (found != static_cast<std::size_t>(scene.number_of_particles))
        throw CannotSetUp(fmt::format("md: initial.file {} holds {} particles, the scene has {}", initial.file, found,
                                      scene.number_of_particles));
    constexpr double round_off = 1e-9;
    const bool known = stored.box[0] > 0.0;  // a trajectory of another program may say nothing of its box
    if (known && (std::abs(stored.box[0] - scene.box.x) > round_off * scene.box.x ||
                  std::abs(stored.box[1] - scene.box.y) > round_off * scene.box.y))
        throw CannotSetUp(fmt::format("md: initial.file {} is of a box of {} x {}, the scene's is {} x {}",
                                      initial.file, stored.box[0], stored.box[1], scene.box.x, scene.box.y));
    stored.state.cycle = 0;
    stored.state.time_in_cycle = 0.0;
    if (scene.kind != scene::Kind::layer) return std::move(stored.state);
    if (distance(stored.phase, initial.phase) > same_phase) refuse_phase(initial, stored.phase);
    stored.state.time_in_cycle = scene::Schedule(scene).time_in_cycle(scene::start_of(scene));
    return std::move(stored.state);
}

}  // namespace shaken::md
