// SPDX-License-Identifier: MIT
// The two engines in the words of a run: to be made for a scene, to be led to a sample instant, to be asked for work.
#pragma once

#include <cstdint>
#include <string>

#include "continuum/resolve.hpp"
#include "continuum/solver.hpp"
#include "md/simulation.hpp"
#include "run/stream.hpp"
#include "scene/schedule.hpp"

namespace shaken::run {

/// An MD run looks for a wish to stop so often between sample instants, some tenth of a second; counted by the engine's
/// work, for there may be few contacts between grains, or none.
inline constexpr std::int64_t predictions_between_looks = 300'000;

/// The knobs of the method, from [md].
inline md::Options md_options_of(const scene::Scene& scene) {
    return {scene.md.shell, static_cast<int>(scene.md.frames_per_cycle), scene.md.contacts_between_sorts};
}

template <class Engine>
struct EngineTraits;

template <>
struct EngineTraits<md::Simulation> {
    static constexpr const char* name = "md";
    static constexpr const char* work_unit = "collisions/s";
    static scene::Scene resolved(const scene::Scene& scene) { return scene; }
    static md::Simulation made(const scene::Scene& scene) { return md::Simulation(scene, md_options_of(scene)); }
    static double work(const md::Simulation& simulation) {
        return static_cast<double>(simulation.counters().pair_collisions);
    }
    /// False where it stopped short of the instant, from where it goes on when called again.
    static bool reach(md::Simulation& simulation, std::int64_t cycle, double time_in_cycle, const AskedToStop& stop) {
        while (!simulation.advance_to(cycle, time_in_cycle, predictions_between_looks))
            if (stop()) return false;
        return true;
    }
    static bool reach(md::Simulation& simulation, const scene::Schedule& schedule, const scene::Instant& at,
                      const AskedToStop& stop) {
        return reach(simulation, at.cycle, schedule.time_in_cycle(at), stop);
    }
    /// From the last sample instant to the end of the last cycle, so that a run ends in the same state however finely
    /// it is sampled. A gas was sampled there.
    static bool reach_end(md::Simulation& simulation, const scene::Schedule& schedule, const AskedToStop& stop) {
        if (schedule.samples() > schedule.cycles() * schedule.phases()) return true;
        return reach(simulation, schedule.cycles(), 0.0, stop);
    }
};

template <>
struct EngineTraits<continuum::Solver> {
    static constexpr const char* name = "continuum";
    static constexpr const char* work_unit = "steps/s";
    static scene::Scene resolved(const scene::Scene& scene) { return continuum::resolve(scene); }
    static continuum::Solver made(const scene::Scene& scene) { return continuum::Solver(scene); }
    static double work(const continuum::Solver& solver) { return static_cast<double>(solver.steps()); }
    static bool reach(continuum::Solver& solver, const scene::Schedule&, const scene::Instant& at, const AskedToStop&) {
        solver.advance_to_instant(at.cycle, at.phase_index);
        return true;
    }
    static bool reach_end(continuum::Solver&, const scene::Schedule&, const AskedToStop&) { return true; }
};

}  // namespace shaken::run
