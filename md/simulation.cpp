// SPDX-License-Identifier: MIT
#include "md/simulation.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <utility>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "md/engine.hpp"
#include "md/errors.hpp"
#include "md/initial_file.hpp"
#include "md/initial_state.hpp"

namespace shaken::md {

namespace {

std::optional<scene::PlateMotion> plate_of(const scene::Scene& scene) {
    return scene.kind == scene::Kind::layer ? std::optional(scene.motion) : std::nullopt;
}

Box box_of(const scene::Scene& scene) {
    return {scene.box.x, scene.box.y, scene.box.ceiling, scene.kind == scene::Kind::uniform, plate_of(scene)};
}

/// One seed from the two that a scene names: [initial] and [md] (the mixing step of SplitMix64, Steele and others
/// 2014).
std::uint64_t seed_of(const scene::Scene& scene) {
    std::uint64_t z = scene.md.seed + 0x9e3779b97f4a7c15 * std::rotl(scene.initial.seed, 32);
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

/// The random layer or gas, or the state in the file that the scene names.
Snapshot start_of(const scene::Scene& scene) {
    if (scene.initial.file.empty())
        return make_initial_state(
            {scene.number_of_particles, scene.initial.volume_fraction, scene.initial.temperature, seed_of(scene)},
            box_of(scene));
    return read_start(scene);
}

void refuse_overlaps(const Snapshot& start, const Box& box) {
    if (start.position.empty() || start.position.size() != start.velocity.size())
        throw CannotSetUp("md: a start needs at least one particle, and as many velocities as positions");
    constexpr double round_off = 1e-9;  // a start may have been written in another unit or precision and read back
    const Audit found = audit(start, box);
    if (found.largest_overlap > round_off)
        throw CannotSetUp(fmt::format("md: particles {} and {} of the start overlap by {:.3g} sigma", found.first,
                                      found.second, found.largest_overlap));
    if (found.deepest_in_plate > round_off || found.deepest_in_ceiling > round_off)
        throw CannotSetUp(fmt::format("md: a particle of the start lies {:.3g} sigma inside the plate or the ceiling",
                                      std::max(found.deepest_in_plate, found.deepest_in_ceiling)));
}

/// Of a scene's particles or of a uniform system: what they say of contacts, in the engine's words.
template <class Particles>
Setup contacts_of(const Particles& p) {
    Setup setup;
    setup.restitution = p.restitution;
    using scene::CollapseRemedy, scene::FrictionLaw;
    if (p.friction.law == FrictionLaw::walton) setup.friction = {p.friction.beta0, p.friction.mu, 1.0 / sphere_inertia};
    if (p.friction.law == FrictionLaw::walton_without_spin) setup.friction = {p.friction.beta0, p.friction.mu, 0.0};
    if (p.collapse == CollapseRemedy::elastic_below) setup.elastic.slow = p.collapse_speed;
    if (p.collapse == CollapseRemedy::contact_time) setup.elastic.soon = p.collapse_time;
    return setup;
}

std::unique_ptr<Engine> make_scene_engine(const scene::Scene& scene, Snapshot start, const Options& options) {
    const Box box = box_of(scene);
    start.cycle = 0;
    refuse_overlaps(start, box);
    Setup setup = contacts_of(scene.particles);
    setup.box = box;
    setup.period = scene.motion.period();
    setup.start = std::move(start);
    setup.options = options;
    return make_engine(setup);
}

/// Making a start takes more memory than the engine keeps, in pieces that the C library would hold on to for the run.
void give_back_freed_memory() {
#if defined(__GLIBC__)
    ::malloc_trim(0);
#endif
}

}  // namespace

Simulation::Simulation(const scene::Scene& scene, const Options& options)
    : Simulation(scene, start_of(scene), options) {
    give_back_freed_memory();
}

Simulation::Simulation(const scene::Scene& scene, const Snapshot& start, const Options& options)
    : engine_(make_scene_engine(scene, start, options)) {
    give_back_freed_memory();
}

Simulation::Simulation(const UniformSystem& system, const Options& options) {
    const double length = system.box_length();
    const Box box{length, length, length, true, std::nullopt};
    Snapshot start =
        make_initial_state({system.particles, system.volume_fraction, system.temperature, system.seed}, box);
    refuse_overlaps(start, box);
    Setup setup = contacts_of(system);
    setup.box = box;
    setup.period = system.period;
    setup.start = std::move(start);
    setup.options = options;
    engine_ = make_engine(setup);
    setup.start = {};
    give_back_freed_memory();
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::advance_to(std::int64_t cycle, double time_in_cycle, std::int64_t most_predictions) {
    return engine_->advance_to(cycle, time_in_cycle, most_predictions);
}
void Simulation::advance_collisions(std::int64_t pair_collisions) { engine_->advance_collisions(pair_collisions); }
ContactEvent Simulation::advance_contact() { return engine_->advance_contact(); }
std::int64_t Simulation::cycle() const { return engine_->cycle(); }
double Simulation::time_in_cycle() const { return engine_->time_in_cycle(); }
double Simulation::plate_period() const { return engine_->period(); }
std::int64_t Simulation::particles() const { return engine_->particles(); }
Snapshot Simulation::snapshot() const { return engine_->snapshot(); }
Ledger Simulation::ledger() const { return engine_->ledger(); }
Counters Simulation::counters() const { return engine_->counters(); }
Audit Simulation::audit() const { return md::audit(engine_->snapshot(), engine_->box()); }
std::int64_t Simulation::memory() const { return engine_->memory(); }
void Simulation::save(files::CheckpointWriter& out) const { engine_->save(out); }
void Simulation::restore(const files::CheckpointReader& in) { engine_->restore(in); }

std::uint64_t Simulation::state_hash() const {
    files::CheckpointWriter state;
    engine_->save(state);
    return state.hash();
}

}  // namespace shaken::md
