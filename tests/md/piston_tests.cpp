// SPDX-License-Identifier: MIT
// A fast plate as a piston: behind the shock it drives into a cold elastic gas the gas moves with the piston and has
// the temperature V^2/3, at any density, because half of what the piston does becomes heat.
#include <cmath>
#include <vector>

#include "md/initial_state.hpp"
#include "small_systems.hpp"
#include "statistics.hpp"
#include "tests/support/catch.hpp"

namespace {

struct Behind {
    double temperature, velocity;
};

/// Gas of this volume fraction above the plate, which rises so far at speeds within 0.2 % of V, so fast that
/// gravity does nothing; then what is between `from` and `reach` above the plate.
Behind shocked(double volume_fraction, double rise, double from, double reach, std::uint64_t seed) {
    constexpr double speed = 1000.0, side = 16.0, column = 50.0;
    // 2 percent of a cycle around its quarter, where the plate is fastest.
    constexpr double share = 0.02;
    const double period = rise / speed / share, amplitude = speed * period / (2.0 * M_PI);
    scene::Scene scene;
    scene.box = {side, side, amplitude + 200.0};
    scene.motion = {amplitude, 1.0 / period};
    scene.particles.restitution = scene::RestitutionConstant{1.0};
    scene.number_of_particles = std::llround(volume_fraction * side * side * column * 6.0 / M_PI);

    const double start_time = (0.25 - 0.5 * share) * period;
    md::Box box{side, side, column + 1.0, false, scene.motion};
    md::Snapshot start = md::make_initial_state({scene.number_of_particles, volume_fraction, 1.0, seed}, box);
    for (auto& r : start.position) r[2] += scene.motion.position(start_time);
    start.time_in_cycle = start_time;
    md::Simulation simulation(scene, start);
    const double end_time = (0.25 + 0.5 * share) * period;
    simulation.advance_to(0, end_time);

    const md::Snapshot now = simulation.snapshot();
    const double plate = scene.motion.position(end_time);
    double count = 0.0, sum = 0.0, square = 0.0;
    for (std::size_t i = 0; i < now.position.size(); ++i) {
        const double height = now.position[i][2] - plate;
        if (height < from || height > reach) continue;
        const auto& v = now.velocity[i];
        count += 1.0;
        sum += v[2];
        square += v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    }
    const double mean = sum / count;
    return {(square / count - mean * mean) / 3.0 / (speed * speed), mean / speed};
}

}  // namespace

TEST_CASE("behind a piston in a cold gas the temperature is a third of its speed squared, at any density") {
    struct Case {
        double volume_fraction, rise, from, reach;
    };
    // Fronts are ahead of the plate by (D/V - 1) times its rise, 16 and 22 sigma by then; the reach stays behind them.
    // What lies next to the plate was there while the shock formed, and is hotter: at 0.3 by 8 % at the plate, 3 % at 7
    // sigma, 1 % at 15.
    const Case c = GENERATE(Case{0.1, 20.0, 4.0, 13.0}, Case{0.3, 10.0, 14.0, 21.0});
    std::vector<double> temperature, velocity;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Behind b = shocked(c.volume_fraction, c.rise, c.from, c.reach, seed);
        temperature.push_back(3.0 * b.temperature);
        velocity.push_back(b.velocity);
    }
    // Standard errors of independent starts: the sound that the uneven gas makes behind the shock is part of them.
    const Estimate t = mean_of(temperature), u = mean_of(velocity);
    INFO("volume fraction " << c.volume_fraction << ": 3 T/V^2 = " << t.value << " +- " << t.error
                            << ", u/V = " << u.value << " +- " << u.error);
    CHECK(t.error < 0.012);
    CHECK(u.error < 0.006);
    CHECK(std::abs(t.value - 1.0) < 3.0 * t.error);
    CHECK(std::abs(u.value - 1.0) < 3.0 * u.error);
}
