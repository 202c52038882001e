// SPDX-License-Identifier: MIT
// Plates at the ends of what a scene may ask for: so slow that a cycle outlasts the run, and falling faster than
// gravity under a ball that does not rebound.
#include <algorithm>
#include <cmath>
#include <vector>

#include "md/event_loop.hpp"
#include "small_systems.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

double energy(const md::Simulation& simulation) {
    const md::Snapshot state = simulation.snapshot();
    double sum = 0.0;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        const auto& v = state.velocity[i];
        sum += 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + state.position[i][2];
    }
    return sum;
}

/// Largest heights over the plate in each flight that rises above one diameter.
std::vector<double> flights(md::Simulation& simulation, const scene::PlateMotion& plate, std::int64_t cycles) {
    std::vector<double> highest;
    bool aloft = false;
    constexpr int instants = 4000;  // a cycle
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle)
        for (int k = 0; k < instants; ++k) {
            const double t = plate.period() * k / instants;
            simulation.advance_to(cycle, t);
            const double gap = simulation.snapshot().position[0][2] - 0.5 - plate.position(t);
            if (gap > 1.0) {
                if (!aloft) highest.push_back(gap);
                highest.back() = std::max(highest.back(), gap);
            }
            aloft = gap > 1.0;
        }
    return highest;
}

}  // namespace

TEST_CASE("an elastic gas over a plate at rest keeps its energy, however long the plate's cycle") {
    scene::Scene scene = small::layer(10, scene::RestitutionConstant{1.0});
    scene.box = {20.0, 20.0, 10000.0};
    scene.initial.volume_fraction = 0.02;
    scene.motion = scene::PlateMotion::from_acceleration(0.0, GENERATE(0.1, 1e-3, 1e-5));
    md::Simulation simulation(scene);
    const double before = energy(simulation), period = scene.motion.period();
    constexpr double time = 2000.0;
    const double cycles = std::floor(time / period);
    simulation.advance_to(static_cast<std::int64_t>(cycles), time - cycles * period);
    INFO("frequency " << scene.motion.frequency << ", relative drift " << energy(simulation) / before - 1.0);
    REQUIRE(simulation.counters().plate_collisions > 1000);
    // Round-off of some thousand contacts, each a few units in the last place of its energy.
    CHECK(energy(simulation) == Approx(before).epsilon(1e-12));
}

TEST_CASE("a ball without rebound leaves a plate that falls faster than gravity at once") {
    scene::Scene scene = small::layer(1, scene::RestitutionConstant{0.0});
    scene.box = {4.0, 4.0, 900.0};
    scene.motion = scene::PlateMotion::from_acceleration(3.4, 0.1);
    md::Simulation simulation(scene);
    std::vector<double> highest = flights(simulation, scene.motion, 12);
    // The ball falls onto the plate somewhere in the first cycle; from then on its flights follow from the plate's
    // motion alone, and the one that starts from riding is the highest.
    const auto ridden = std::max_element(highest.begin(), highest.end());
    REQUIRE(std::distance(ridden, highest.end()) >= 4);
    // Worked out from the plate's motion. Hops of 1e-4 while it rides and the instants looked at leave 1e-3.
    CHECK(ridden[0] == Approx(23.1950).margin(1e-3));
    CHECK(ridden[1] == Approx(23.0013).margin(1e-3));
    CHECK(ridden[2] == Approx(23.0623).margin(1e-3));
    CHECK(ridden[3] == Approx(23.0443).margin(1e-3));
    CHECK(highest.back() == Approx(23.0485).margin(1e-3));
}

TEST_CASE("a run stops where it is asked to, however rarely its particles meet") {
    scene::Scene scene = small::layer(200, scene::RestitutionConstant{1.0});
    scene.box = {400.0, 400.0, 1e6};
    scene.initial.volume_fraction = 2e-4;
    scene.initial.temperature = 1e6;
    scene.motion = scene::PlateMotion::from_acceleration(0.0, 1e-5);
    md::Simulation simulation(scene);
    constexpr std::int64_t predictions = 10000;  // of 200 particles: fifty epochs at most
    CHECK_FALSE(simulation.advance_to(1, 0.0, predictions));
    CHECK(simulation.cycle() == 0);
    CHECK(simulation.time_in_cycle() <= predictions / 200 * md::longest_epoch);
    const md::Counters met = simulation.counters();
    CHECK(met.pair_collisions + met.plate_collisions + met.ceiling_collisions < predictions / 10);
}

TEST_CASE("a ball that rides on the plate hops 5000 (1 + plate's acceleration) times a unit of time") {
    // Where the plate pushes hardest: 1 + Gamma cos(2 pi f t) is within 0.1 % of 1 + Gamma.
    const double acceleration = GENERATE(0.0, 0.5, 0.9);
    scene::Scene scene = small::layer(1, scene::RestitutionConstant{0.0});
    scene.motion = scene::PlateMotion::from_acceleration(acceleration, 0.1);
    md::Simulation simulation(scene);
    const double half = 0.04;
    simulation.advance_to(2, scene.motion.period() - half);
    const std::int64_t before = simulation.counters().plate_collisions;
    simulation.advance_to(3, half);
    const std::int64_t hops = simulation.counters().plate_collisions - before;
    // One hop that begins or ends outside, and that thousandth.
    CHECK(static_cast<double>(hops) == Approx(2.0 * half * 5000.0 * (1.0 + acceleration)).epsilon(2e-3).margin(1.5));
}

TEST_CASE("particles are put in order of space within a long cycle too") {
    scene::Scene scene = small::layer(50);
    scene.motion = scene::PlateMotion::from_acceleration(0.0, 1e-4);
    scene.particles.restitution = scene::RestitutionConstant{1.0};
    md::Options options;
    options.contacts_between_sorts = 1.0;
    md::Simulation simulation(scene, options);
    const support::TemporaryFolder folder;
    const auto contacts_at_sort = [&] {
        files::CheckpointWriter out;
        simulation.save(out);
        out.commit(folder.path() / "state");
        return files::CheckpointReader(folder.path() / "state").take_one<std::int64_t>("md.contacts_at_sort");
    };
    simulation.advance_to(0, 20.0);
    const std::int64_t first = contacts_at_sort();
    simulation.advance_to(0, 100.0);
    CHECK(contacts_at_sort() > first);
}
