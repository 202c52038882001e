// SPDX-License-Identifier: MIT
#include <cmath>

#include "compare/continuum_sampler.hpp"
#include "compare/md_sampler.hpp"
#include "compare/scenes.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

scene::Scene small_scene() {
    return compare::parse_scene(R"(
[scene]
name = "small"
[plate]
acceleration = 3.0
frequency = 0.095
[particles]
number = 246
restitution = 0.9
[box]
x = 5.0
y = 5.0
[sample]
phases = 20
settle = 1
average = 4
[continuum]
spacing = 0.5
lid = 40.0
)",
                                "small.toml");
}

/// Particles strewn over the heights that bins cover, and two above the lid.
md::Snapshot snapshot(const scene::Scene& scene, std::int64_t cycle, std::int64_t phase) {
    synthetic::Normal normal(static_cast<std::uint64_t>(100 * cycle + phase + 1));
    const double time = static_cast<double>(phase) / static_cast<double>(scene.sample.phases) * scene.motion.period();
    md::Snapshot s{.cycle = cycle, .time_in_cycle = time, .position = {}, .velocity = {}};
    for (std::int64_t i = 0; i < scene.number_of_particles; ++i) {
        const double above = i < 2 ? scene.continuum.lid + 10.0 : 0.5 + std::abs(8.0 * normal());
        s.position.push_back({1.0, 1.0, scene.motion.position(time) + std::min(above, 100.0)});
        s.velocity.push_back({normal(), normal(), -4.0 + normal()});
    }
    return s;
}

double mass(const fields::Profile& profile, double area) {
    double sum = 0.0;
    for (const double n : profile.density) sum += n * profile.bins.width * area;
    return sum;
}

}  // namespace

TEST_CASE("the MD sampler counts every particle below the lid once, and all of them in the centre of mass") {
    const scene::Scene scene = small_scene();
    compare::MdSampler sampler(scene);
    double sum = 0.0;
    for (std::int64_t cycle = 1; cycle < 5; ++cycle) {
        const md::Snapshot s = snapshot(scene, cycle, 7);
        sampler.sample(s, {cycle, 7});
        for (const auto& x : s.position) sum += x[2];
    }
    const double area = scene.box.x * scene.box.y;
    const auto particles = static_cast<double>(scene.number_of_particles);
    // Round-off of some hundred additions.
    CHECK(mass(sampler.moments().profile(7, scene.motion), area) == Approx(particles - 2.0).epsilon(1e-12));
    CHECK(sampler.moments().mean_centre_of_mass(7).first == Approx(sum / (4.0 * particles)).epsilon(1e-12));
}

TEST_CASE("particles are binned by their height above the plate, wherever it is") {
    const scene::Scene scene = small_scene();
    for (const std::int64_t phase : {0, 7, 13}) {
        compare::MdSampler sampler(scene);
        const double plate = scene.motion.position(static_cast<double>(phase) / 20.0 * scene.motion.period());
        sampler.sample({.cycle = 1,
                        .time_in_cycle = 0.0,
                        .position = {{1.0, 1.0, plate + 3.3}, {2.0, 2.0, plate + 3.4}},
                        .velocity = {{0.0, 0.0, 2.0}, {0.0, 0.0, 4.0}}},
                       {1, phase});
        const fields::Profile profile = sampler.moments().profile(phase, scene.motion);
        CHECK(profile.density[6] == Approx(2.0 / (25.0 * 0.5)));  // [3.0, 3.5) over 5 x 5
        CHECK(profile.velocity[6] == Approx(3.0));
        CHECK(profile.temperature_z[6] == Approx(2.0));  // of one degree of freedom
    }
}

TEST_CASE("cycles of settling and after averaging leave no trace in the sums") {
    const scene::Scene scene = small_scene();
    compare::MdSampler sampler(scene);
    sampler.sample(snapshot(scene, 0, 3), {0, 3});
    sampler.sample(snapshot(scene, 5, 3), {5, 3});
    CHECK(std::isnan(mass(sampler.moments().profile(3, scene.motion), 1.0)));
    CHECK(std::isnan(sampler.moments().mean_centre_of_mass(3).first));
}

TEST_CASE("an MD sampler restored from a checkpoint goes on with the same bits") {
    const scene::Scene scene = small_scene();
    compare::MdSampler whole(scene), first(scene), second(scene);
    whole.sample(snapshot(scene, 1, 2), {1, 2});
    first.sample(snapshot(scene, 1, 2), {1, 2});
    files::CheckpointWriter out;
    first.save(out);
    const support::TemporaryFolder folder;
    out.commit(folder / "sampler.checkpoint");
    second.restore(files::CheckpointReader(folder / "sampler.checkpoint"));
    whole.sample(snapshot(scene, 2, 2), {2, 2});
    second.sample(snapshot(scene, 2, 2), {2, 2});
    files::CheckpointWriter a, b;
    whole.save(a);
    second.save(b);
    CHECK(a.hash() == b.hash());
}

TEST_CASE("the continuum sampler keeps the solver's mass, and its centre of mass moves with the floor") {
    const scene::Scene scene = small_scene();
    continuum::Solver solver(scene);
    compare::ContinuumSampler plain(scene), lifted(scene, 0.5);
    for (std::int64_t phase = 0; phase < 20; phase += 5) {
        solver.advance_to_instant(1, phase);
        plain.sample(solver, {1, phase});
        lifted.sample(solver, {1, phase});
        const fields::Profile profile = plain.moments().profile(phase, scene.motion);
        INFO("phase " << phase);
        CHECK(mass(profile, 1.0) == Approx(solver.mass()).epsilon(1e-12));  // round-off
        const auto column = solver.column(0, 0);
        double moment = 0.0, total = 0.0;
        for (std::size_t k = 0; k < column.density.size(); ++k) {
            moment += column.density[k] * (static_cast<double>(k) + 0.5) * solver.spacing_z();
            total += column.density[k];
        }
        const double expected = moment / total + profile.plate_height;
        CHECK(plain.moments().mean_centre_of_mass(phase).first == Approx(expected).epsilon(1e-12));
        CHECK(lifted.moments().mean_centre_of_mass(phase).first == Approx(expected + 0.5).epsilon(1e-12));
    }
}

TEST_CASE("bins that do not fit the cells see a linear profile as it is") {
    // Bins of 0.5 over cells of 0.4: their middles shift by up to 0.05 where cells are taken as constant.
    scene::Scene scene = small_scene();
    scene.continuum.spacing = 0.4;
    continuum::Solver solver(scene);
    solver.advance_to_instant(1, 14);
    compare::ContinuumSampler sampler(scene);
    sampler.sample(solver, {1, 14});
    const fields::Profile profile = sampler.moments().profile(14, scene.motion);
    const auto column = solver.column(0, 0);
    CHECK(mass(profile, 1.0) == Approx(solver.mass()).epsilon(1e-12));  // round-off
    double squares = 0.0, squares_of_constant = 0.0;
    for (std::int64_t i = 1; i < 30; ++i) {
        const double z = profile.bins.centre(i) / 0.4 - 0.5;
        const auto k = static_cast<std::size_t>(z);
        const double share = z - static_cast<double>(k);
        const double between = (1.0 - share) * column.density[k] + share * column.density[k + 1];
        // What constant cells give: each fills its share of the bin.
        double constant = 0.0;
        for (std::size_t c = 0; c < column.density.size(); ++c) {
            const double lower = 0.4 * static_cast<double>(c);
            const double overlap =
                std::min(lower + 0.4, profile.bins.edge(i + 1)) - std::max(lower, profile.bins.edge(i));
            constant += std::max(overlap, 0.0) / 0.5 * column.density[c];
        }
        squares += std::pow(profile.density[static_cast<std::size_t>(i)] - between, 2);
        squares_of_constant += std::pow(constant - between, 2);
    }
    // Truncation: curvature over a bin is left, the shift of its middle is gone.
    CHECK(std::sqrt(squares) < 0.6 * std::sqrt(squares_of_constant));
}

TEST_CASE("a continuum sampled into bins as wide as its cells shows its own fields") {
    const scene::Scene scene = small_scene();  // bins and cells of 0.5
    continuum::Solver solver(scene);
    compare::ContinuumSampler sampler(scene);
    solver.advance_to_instant(1, 4);
    sampler.sample(solver, {1, 4});
    const fields::Profile profile = sampler.moments().profile(4, scene.motion);
    const auto column = solver.column(0, 0);
    for (std::size_t k = 0; k < column.density.size(); k += 7) {
        INFO("cell " << k);
        // Round-off: T is a difference of second moment and squared mean, whose size is u^2.
        const double u = column.velocity_z[k] + profile.plate_velocity;
        CHECK(profile.density[k] == Approx(column.density[k]).epsilon(1e-12));
        CHECK(profile.velocity[k] == Approx(u).margin(1e-12 * (1.0 + std::abs(u))));
        CHECK(profile.temperature[k] == Approx(column.temperature[k]).margin(1e-13 * (1.0 + u * u)));
    }
}
