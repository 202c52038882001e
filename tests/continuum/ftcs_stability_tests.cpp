// SPDX-License-Identifier: MIT
// Von Neumann's conditions that ftcs is held to, against what its steps do, driven by hand: nothing here can stop them.
#include <algorithm>
#include <cmath>
#include <string>

#include "cases.hpp"
#include "continuum/ftcs/ftcs.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

struct Gas {
    std::string what;
    double volume_fraction, spacing, artificial_dissipation;
    double stable, unstable;  // diffusion factors on either side of the bound
};

/// An elastic gas at rest at T = 1, its density disturbed from cell to cell by one in a million.
Setup noisy_gas(const Gas& gas, double factor) {
    constexpr std::int64_t cells = 64;
    scene::RandomStream random(1);
    Setup setup = cases::tube(cells, static_cast<double>(cells) * gas.spacing, End::wall, End::wall, [&](double) {
        return cases::Point{gas.volume_fraction * (1.0 + 1e-6 * random.uniform(-1.0, 1.0)), 0.0, 1.0};
    });
    setup.choices.transport.name = "navier_stokes";
    setup.choices.scheme.name = "ftcs";
    setup.choices.closure.name = "jenkins_richman_dense";
    setup.choices.artificial_dissipation = gas.artificial_dissipation;
    setup.choices.diffusion_factor = factor;
    return setup;
}

double fastest(const Ftcs& method) {
    double most = 0.0;
    for (const double u : method.flow().velocity_z) most = std::max(most, std::abs(u));
    return most;
}

/// By how much the fastest flow has grown between 500 steps and 10,000, or until it is no longer small.
double growth(Ftcs& method) {
    double early = 0.0;
    for (int step = 1; step <= 10000; ++step) {
        method.step(0.0, method.longest_step());
        if (step == 500) early = fastest(method);
        if (fastest(method) > 1e-2) return HUGE_VAL;
    }
    return fastest(method) / early;
}

}  // namespace

TEST_CASE("waves of a gas at rest die out within the conditions of ftcs and grow beyond them") {
    const Gas gas =
        GENERATE(Gas{"diffusion", 0.2, 0.2, 0.0, 0.72, 0.78}, Gas{"sound", 0.2, 1.4, 0.0, 0.43, 0.5},
                 Gas{"sound, coarse", 0.2, 5.0, 0.0, 0.033, 0.05}, Gas{"sound, dense", 0.5, 2.0, 0.0, 0.27, 0.31},
                 Gas{"artificial dissipation", 1e-4, 0.2, 0.3, 0.29, 0.33},
                 Gas{"artificial dissipation alone", 1e-4, 0.2, 0.48, 0.02, 0.08});
    INFO(gas.what);
    Ftcs within(noisy_gas(gas, gas.stable)), beyond(noisy_gas(gas, gas.unstable));
    CHECK(within.unstable_share(within.longest_step()) == 0.0);
    CHECK(growth(within) < 1.0);
    CHECK(beyond.unstable_share(beyond.longest_step()) == Approx(1.0));
    CHECK(growth(beyond) > 10.0);
}
