// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cases.hpp"
#include "continuum/closures/closures.hpp"
#include "continuum/step/diffusion_solve.hpp"
#include "continuum/step/heat_of_density.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

}  // namespace

TEST_CASE("the two-ended elimination solves its equations, however stiff they are") {
    std::mt19937_64 engine(5);
    for (const std::size_t n : {2u, 3u, 4u, 17u, 64u, 401u}) {
        std::vector<double> capacity(n), coupling(n + 1), right(n);
        for (double& c : capacity) c = std::pow(10.0, -10.0 + 10.0 * uniform(engine));
        for (double& w : coupling) w = std::pow(10.0, -4.0 + 8.0 * uniform(engine));
        if (n % 2 == 1) coupling.front() = coupling.back() = 0.0;
        for (std::size_t i = 0; i < n; ++i) right[i] = capacity[i] * (2.0 * uniform(engine) - 1.0);
        std::vector<double> x = right, ratio(n);
        solve_diffusion(static_cast<std::int64_t>(n), capacity.data(), {coupling.data(), coupling.data()}, x.data(),
                        ratio.data());
        INFO(n << " cells");
        double total = coupling[0] * x[0] + coupling[n] * x[n - 1], given = 0.0, size = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double below = i > 0 ? x[i - 1] : 0.0, above = i + 1 < n ? x[i + 1] : 0.0;
            const double balance = capacity[i] * x[i] + coupling[i] * (x[i] - below) + coupling[i + 1] * (x[i] - above);
            // Round-off: eps times the terms that cancel, the couplings are up to 1e4.
            CHECK(balance == Approx(right[i]).margin(1e-14 * (coupling[i] + coupling[i + 1] + 1.0)));
            total += capacity[i] * x[i];
            given += right[i];
            size += std::abs(right[i]);
        }
        // What is conserved is kept far better than each balance: nothing is lost inside, eps times n terms.
        CHECK(total == Approx(given).margin(1e-12 * size));
    }
}

TEST_CASE("what passes faces up and down at different rates is solved, kept and stays positive") {
    std::mt19937_64 engine(8);
    for (const std::size_t n : {2u, 3u, 16u, 33u}) {
        std::vector<double> capacity(n), up(n + 1), down(n + 1), right(n), ratio(n), first(n), last(n);
        for (double& c : capacity) c = 0.1 + uniform(engine);
        for (std::size_t f = 0; f <= n; ++f) {
            up[f] = 10.0 * uniform(engine);
            down[f] = f % 3 == 0 ? 0.0 : 10.0 * uniform(engine);
        }
        for (double& r : right) r = uniform(engine);
        const bool ring = n > 3;
        up[n] = ring ? up[0] : 0.0;
        down[n] = down[0];
        std::vector<double> x = right;
        const auto count = static_cast<std::int64_t>(n);
        if (ring)
            solve_periodic_diffusion(count, capacity.data(), {up.data(), down.data()}, x.data(), ratio.data(),
                                     first.data(), last.data());
        else
            solve_diffusion(count, capacity.data(), {up.data(), down.data()}, x.data(), ratio.data());
        double kept = 0.0, given = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double below = i > 0 ? x[i - 1] : (ring ? x[n - 1] : 0.0);
            const double above = i + 1 < n ? x[i + 1] : (ring ? x[0] : 0.0);
            const double balance = (capacity[i] + down[i] + up[i + 1]) * x[i] - up[i] * below - down[i + 1] * above;
            CHECK(balance == Approx(right[i]).margin(1e-13));  // round-off of couplings up to 10
            CHECK(x[i] > 0.0);
            kept += capacity[i] * x[i];
            given += right[i];
        }
        CHECK(kept == Approx(given).epsilon(1e-12));  // no face loses anything: round-off
    }
}

TEST_CASE("the couplings of a face carry its heat, are never negative, and turn with the column") {
    std::mt19937_64 engine(9);
    for (int trial = 0; trial < 200; ++trial) {
        const auto any = [&](double decades) { return std::pow(10.0, decades * (uniform(engine) - 0.5)); };
        const HeatCell below{any(8.0), any(4.0), any(4.0)}, above{any(8.0), any(4.0), any(4.0)};
        const double conduction = any(4.0), scale = any(2.0);
        const HeatCouplings at = heat_couplings(below, above, conduction, scale);
        CHECK(at.up >= 0.0);
        CHECK(at.down >= 0.0);
        const auto part = [&](const HeatCell& cell) {
            return scale * cell.density * cell.density_conductivity * std::pow(cell.temperature, 1.5);
        };
        const double jump = (below.density - above.density) / (0.5 * (below.density + above.density));
        const double flux = conduction * (below.temperature - above.temperature) + jump * (part(below) + part(above));
        const double up = at.up * below.temperature, down = at.down * above.temperature;
        CHECK(up - down == Approx(flux).margin(1e-14 * (up + down)));  // round-off of the two that cancel
        const HeatCouplings turned = heat_couplings(above, below, conduction, scale);
        CHECK(turned.up == at.down);
        CHECK(turned.down == at.up);
    }
}

TEST_CASE("heat that a steep density drives into cold thin gas leaves every temperature positive, whatever the step") {
    Setup setup = cases::tube(64, 64.0, End::wall, End::wall, [](double z) {
        return cases::Point{z < 32.0 ? 0.3 : 1e-7, 0.0, z < 32.0 ? 1.0 : 1e-3};
    });
    setup.choices.transport.name = "navier_stokes";
    setup.choices.closure.name = "garzo_dufty";
    setup.restitution = 0.6;
    setup.sink = scene::RestitutionConstant{0.6};
    Evolution evolution(setup);
    const double before = evolution.ledger().energy;
    for (int k = 0; k < 40; ++k) {
        evolution.step(0.0, evolution.longest_step());
        const std::vector<double> t = cases::inside(evolution, evolution.flow().temperature);
        CHECK(*std::min_element(t.begin(), t.end()) > 0.0);
    }
    const Ledger l = evolution.ledger();
    CHECK(l.energy + l.collisional_loss - l.floor_gain - l.dual_energy_gain ==
          Approx(before).epsilon(1e-12));  // round-off
}

TEST_CASE("the elimination of a ring solves its equations") {
    std::mt19937_64 engine(7);
    for (const std::size_t n : {16u, 33u}) {
        std::vector<double> capacity(n), coupling(n + 1), right(n), ratio(n), first(n), last(n);
        for (double& c : capacity) c = 0.1 + uniform(engine);
        for (double& w : coupling) w = 10.0 * uniform(engine);
        for (double& r : right) r = uniform(engine);
        coupling.back() = coupling.front();
        std::vector<double> x = right;
        solve_periodic_diffusion(static_cast<std::int64_t>(n), capacity.data(), {coupling.data(), coupling.data()},
                                 x.data(), ratio.data(), first.data(), last.data());
        for (std::size_t i = 0; i < n; ++i) {
            const double below = x[(i + n - 1) % n], above = x[(i + 1) % n];
            const double balance = capacity[i] * x[i] + coupling[i] * (x[i] - below) + coupling[i + 1] * (x[i] - above);
            CHECK(balance == Approx(right[i]).margin(1e-13));  // round-off of couplings up to 10
        }
    }
}

TEST_CASE("the elimination of the mirrored column gives the mirrored bits") {
    std::mt19937_64 engine(6);
    for (const std::size_t n : {16u, 33u}) {
        std::vector<double> capacity(n), coupling(n + 1), x(n), ratio(n);
        for (double& c : capacity) c = uniform(engine);
        for (double& w : coupling) w = 100.0 * uniform(engine);
        for (double& v : x) v = uniform(engine);
        const auto turned = [](std::vector<double> v) { return std::vector<double>(v.rbegin(), v.rend()); };
        std::vector<double> mirror_capacity = turned(capacity), mirror_coupling = turned(coupling), y = turned(x);
        const auto count = static_cast<std::int64_t>(n);
        solve_diffusion(count, capacity.data(), {coupling.data(), coupling.data()}, x.data(), ratio.data());
        solve_diffusion(count, mirror_capacity.data(), {mirror_coupling.data(), mirror_coupling.data()}, y.data(),
                        ratio.data());
        CHECK(turned(y) == x);
    }
}

TEST_CASE("viscosity turns motion into heat and loses no energy") {
    // Shear between free-slip walls at rest: u_x = cos(pi z / L) decays by mu, everything else by what follows.
    Setup setup = cases::tube(64, 16.0, End::wall, End::wall, [](double) { return cases::Point{0.1, 0.0, 1.0}; });
    setup.choices.transport.name = "navier_stokes";
    for (std::int64_t i = 0; i < 64; ++i)
        setup.flow.velocity_x[static_cast<std::size_t>(setup.grid.first(0) + i)] =
            0.1 * std::cos(std::numbers::pi * setup.grid.centre(i) / 16.0);
    Evolution evolution(setup);
    const double energy = evolution.ledger().energy;
    cases::advance(evolution, 20.0);
    const Ledger after = evolution.ledger();
    CHECK(after.energy == Approx(energy).epsilon(1e-12));  // round-off over 500 steps
    double motion = 0.0;
    for (double u : cases::inside(evolution, evolution.flow().velocity_x)) motion = std::max(motion, std::abs(u));
    const Transport t = JenkinsRichman::transport<Goldshtein>(0.1 / sphere_volume, 1.0, 1.0);
    const double expected =
        0.1 * std::exp(-t.shear_viscosity / (0.1 / sphere_volume) * std::pow(std::numbers::pi / 16.0, 2) * 20.0);
    // Truncation: (k dz)^2/12 of the rate = 2e-4, dt of the implicit step 3e-4, and the heating of T by 1e-3: 1 % in
    // all of a decay by e^-0.9.
    CHECK(motion == Approx(expected).epsilon(1e-2));
}

TEST_CASE("a hot cell in thin cold gas spreads its heat and nothing else, whatever the step") {
    // The mean free path is 10^5 cells, so a step of the waves is 10^5 times what explicit diffusion bears.
    const double velocity = GENERATE(0.0, 3.0);
    Setup setup = cases::tube(64, 0.64, End::wall, End::wall, [&](double z) {
        const bool hot = z > 0.3 && z < 0.31;
        return cases::Point{1e-4, hot ? velocity : 0.0, hot ? 1e4 : 1e-2};
    });
    setup.choices.transport.name = "navier_stokes";
    Evolution evolution(setup);
    const auto energy = [&] { return evolution.ledger().energy; };
    const double before = energy();
    for (int k = 0; k < 20; ++k) {
        evolution.step(0.0, evolution.longest_step());
        const std::vector<double> t = cases::inside(evolution, evolution.flow().temperature);
        CHECK(*std::min_element(t.begin(), t.end()) > 0.0);
    }
    // Round-off: 20 steps of 64 cells.
    CHECK(energy() == Approx(before).epsilon(1e-12));
    const std::vector<double> t = cases::inside(evolution, evolution.flow().temperature);
    CHECK(*std::max_element(t.begin(), t.end()) < 1.01 * *std::min_element(t.begin(), t.end()));
}
