// SPDX-License-Identifier: MIT
// Knudsen number, omega tau and packed share of known fields.
#include "compare/validity.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

/// A column with room for its own fields.
struct Column {
    std::vector<double> density, temperature, none;

    Column(std::size_t cells, double volume_fraction, double of_temperature)
        : density(cells, volume_fraction / continuum::sphere_volume), temperature(cells, of_temperature), none(cells) {}
    continuum::ColumnView view() const { return {density, none, none, none, temperature}; }
};

continuum::EquationOfState gas() { return continuum::make_equation_of_state({"goldshtein", {}}, 0.7); }

compare::Validity of(const std::vector<Column>& columns, double spacing, double omega = 1.0) {
    std::vector<continuum::ColumnView> views;
    for (const Column& column : columns) views.push_back(column.view());
    return compare::validity_of(views, spacing, gas(), omega);
}

}  // namespace

TEST_CASE("a uniform gas has Kn = 0 and one omega tau, that of Enskog's collision rate") {
    // G = 0.12460410 at nu = 0.1; the rate 4 n g0 sqrt(pi T) at T = 4, n = 0.6/pi.
    const double rate = 4.0 * (0.6 / std::numbers::pi) * (0.12460410 / 0.1) * std::sqrt(4.0 * std::numbers::pi);
    const compare::Validity v = of({Column(10, 0.1, 4.0)}, 0.5, 2.0);
    CHECK(v.knudsen == 0.0);
    CHECK(v.knudsen_largest == 0.0);
    CHECK(v.omega_tau == Approx(2.0 / rate).epsilon(1e-7));  // the digits of G
    CHECK(v.omega_tau_largest == Approx(2.0 / rate).epsilon(1e-7));
    CHECK(v.packed_share == 0.0);
}

TEST_CASE("a temperature that falls exponentially has Kn = l over its length everywhere") {
    Column column(400, 0.1, 1.0);
    const double length = 5.0, spacing = 0.05;
    for (std::size_t k = 0; k < 400; ++k)
        column.temperature[k] = 3.0 * std::exp(-spacing * static_cast<double>(k) / length);
    const double free_path = std::sqrt(std::numbers::pi / 8.0) / (0.6 / std::numbers::pi * std::numbers::pi);
    const compare::Validity v = of({column}, spacing);
    CHECK(v.knudsen == Approx(free_path / length).epsilon(1e-4));           // truncation, (dz/L)^2/6, and of the ends
    CHECK(v.knudsen_largest == Approx(free_path / length).epsilon(0.006));  // one-sided at the top: dz/(2 L)
}

TEST_CASE("the layer counts, by mass; the gas above it does not") {
    Column column(4, 0.2, 1.0);
    column.density[1] *= 0.5;
    column.density[2] *= 0.1;   // nu = 0.02: outside
    column.density[3] *= 1e-6;  // outside, and hardly a collision there
    column.temperature = {1.0, 1.0, 1.0, 4.0};
    const auto alone = [](double volume_fraction) { return 1.0 / gas().collision_rate(volume_fraction, 1.0); };
    const compare::Validity v = of({column}, 1.0);
    CHECK(v.omega_tau == Approx((0.2 * alone(0.2) + 0.1 * alone(0.1)) / 0.3));
    CHECK(v.omega_tau_largest == Approx(alone(0.1)));

    SECTION("columns count alike") {
        const compare::Validity both = of({column, Column(4, 0.1, 1.0)}, 1.0);
        CHECK(both.omega_tau == Approx((0.2 * alone(0.2) + 0.5 * alone(0.1)) / 0.7));
    }
    SECTION("a gas without a layer counts where it has half its greatest density") {
        for (double& n : column.density) n *= 0.1;
        CHECK(of({column}, 1.0).omega_tau == Approx(alone(0.02)));
        column.density[1] *= 1.1;
        CHECK(of({column}, 1.0).omega_tau_largest == Approx(alone(0.011)));
    }
}

TEST_CASE("the packed share is of all mass") {
    Column column(4, 0.1, 1.0);
    column.density[0] = 0.61 / continuum::sphere_volume;
    column.density[1] = 0.59 / continuum::sphere_volume;
    column.density[2] = 0.02 / continuum::sphere_volume;  // above the layer
    CHECK(of({column}, 1.0).packed_share == Approx(0.61 / (0.61 + 0.59 + 0.02 + 0.1)));
}

TEST_CASE("a run has the means of its states' means and the largest of their largest") {
    const std::vector<compare::Validity> states{{1.0, 2.0, 3.0, 9.0, 0.1}, {3.0, 8.0, 5.0, 6.0, 0.3}};
    const compare::ValidityOfRun run = compare::over_run(states);
    CHECK(run.mean.knudsen == 2.0);
    CHECK(run.mean.knudsen_largest == 8.0);
    CHECK(run.mean.omega_tau == 4.0);
    CHECK(run.mean.omega_tau_largest == 9.0);
    CHECK(run.mean.packed_share == Approx(0.2));
    CHECK(run.packed_share_largest == 0.3);
}

TEST_CASE("each limit warns above it and is silent below") {
    const auto words = [](double knudsen, double omega_tau, double packed_share) {
        compare::ValidityOfRun run;
        run.mean = {knudsen, 100.0, omega_tau, 1000.0, packed_share};
        run.packed_share_largest = 1.0;  // the largest values do not warn
        return compare::warnings(run);
    };
    const double kn = compare::knudsen_limit, wt = compare::omega_tau_limit, packed = compare::packed_share_limit;
    CHECK(words(0.99 * kn, 0.99 * wt, 0.99 * packed).empty());
    for (const auto& [warned, key] :
         {std::pair{words(1.01 * kn, 0.0, 0.0), "Knudsen"}, std::pair{words(0.0, 1.01 * wt, 0.0), "omega tau"},
          std::pair{words(0.0, 0.0, 1.01 * packed), "of the mass is above nu = 0.6"}}) {
        REQUIRE(warned.size() == 1);
        CHECK_THAT(warned[0], Contains(key));
    }
    CHECK(words(2.0 * kn, 2.0 * wt, 2.0 * packed).size() == 3);
}
