// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include "continuum/closures/closures.hpp"
#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/closures/equation_of_state.hpp"
#include "continuum/closures/values.hpp"
#include "continuum/kernels.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

TEST_CASE("the vectorisable power equals the library's to round-off") {
    double worst = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double x = 2.0 * std::exp(-30.0 * i / 100000.0);
        for (const double a : {0.8666666666666667, -0.13, 1.0})
            worst = std::max(worst, std::abs(fast_power(x, a) / std::pow(x, a) - 1.0));
    }
    // Round-off: the exponent reaches 43, so an ulp of it is 43 * 2.2e-16 * ln 2 in the power.
    CHECK(worst < 1e-14);
}

TEST_CASE("Jenkins and Richman's coefficients take the values of physics.md") {
    struct Row {
        double nu, g, p, gamma, lambda, mu, kappa, c;
    };
    const std::array<Row, 3> rows{{
        {0.10, 0.12460410, 0.27189787, 0.08216941, 0.03580367, 0.22502073, 0.94912316, 1.81351580},
        {0.40, 1.16461491, 3.78892459, 3.07199285, 1.33855898, 1.29962695, 5.27841943, 5.64608591},
        {0.62, 15.4516066, 63.3920252, 63.1747011, 27.5271029, 21.1970809, 79.7680993, 55.7310673},
    }};
    const double e = 0.7;
    for (const Row& row : rows) {
        const double n = row.nu / sphere_volume;
        const PressurePoint point = pressure_point<Goldshtein>(n, 1.0, 2.0 * (1.0 + e));
        const Transport t = JenkinsRichman::transport<Goldshtein>(n, 1.0, e);
        const double rate = JenkinsRichman::cooling_rate<Goldshtein>(n, e);
        // The table has nine digits.
        const auto value = [](double x) { return Approx(x).epsilon(2e-8); };
        INFO("volume fraction " << row.nu);
        CHECK(row.nu * Goldshtein::at(row.nu).g0 == value(row.g).epsilon(5e-8));
        CHECK(point.pressure == value(row.p));
        CHECK(1.5 * n * rate * (1.0 - e * e) == value(row.gamma).epsilon(1e-7));
        CHECK(t.bulk_viscosity == value(row.lambda).epsilon(2e-7));
        CHECK(t.shear_viscosity == value(row.mu));
        CHECK(t.conductivity == value(row.kappa));
        CHECK(std::sqrt(point.sound_speed_squared) == value(row.c));
    }
}

TEMPLATE_TEST_CASE("a pair correlation's slope is the derivative of its value", "", Goldshtein, CarnahanStarling) {
    for (const double nu : {1e-6, 0.01, 0.1, 0.3, 0.48, 0.5, 0.6, 0.64}) {
        const double h = 1e-5 * std::min(nu, TestType::packing - nu);
        const double difference = (TestType::at(nu + h).g0 - TestType::at(nu - h).g0) / (2.0 * h);
        INFO("volume fraction " << nu);
        // Truncation of the centred difference, h^2 = 1e-10 relative, and round-off eps/1e-5.
        CHECK(TestType::at(nu).slope == Approx(nu * difference).epsilon(1e-6).margin(1e-9));
    }
}

TEMPLATE_TEST_CASE("pressure and coefficients stay finite in the vacuum and grow without bound at packing", "",
                   Goldshtein, CarnahanStarling) {
    for (const double nu : {0.0, 1e-300, 1e-30, 1e-12}) {
        const Transport t = JenkinsRichman::transport<TestType>(nu / sphere_volume, 1.0, 0.9);
        // Boltzmann's values, to which nu = 1e-12 is 1e-10 near.
        CHECK(t.shear_viscosity == Approx(5.0 / 16.0 / std::sqrt(std::numbers::pi)).epsilon(1e-9));
        CHECK(t.conductivity == Approx(75.0 / 64.0 / std::sqrt(std::numbers::pi)).epsilon(1e-9));
        CHECK(pressure_point<TestType>(nu / sphere_volume, 1.0, 3.8).sound_speed_squared ==
              Approx(5.0 / 3.0).epsilon(1e-9));
    }
    double last = 0.0;
    for (const double room : {1e-2, 1e-4, 1e-6, 1e-8}) {
        const double p = pressure_point<TestType>((TestType::packing - room) / sphere_volume, 1.0, 3.8).pressure;
        CHECK(std::isfinite(p));
        CHECK(p > 10.0 * last);
        last = p;
    }
}

TEST_CASE(
    "Garzo and Dufty's coefficients are Jenkins and Richman's for elastic spheres, and depart from there linearly") {
    for (const double nu : {1e-9, 0.1, 0.3, 0.5, 0.62}) {
        const double n = nu / sphere_volume;
        const Transport gd = GarzoDufty::transport<Goldshtein>(n, 1.7, 1.0);
        const Transport jr = JenkinsRichman::transport<Goldshtein>(n, 1.7, 1.0);
        INFO("volume fraction " << nu);
        CHECK(gd.bulk_viscosity == Approx(jr.bulk_viscosity).epsilon(1e-12));
        CHECK(gd.shear_viscosity == Approx(jr.shear_viscosity).epsilon(1e-12));
        CHECK(gd.conductivity == Approx(jr.conductivity).epsilon(1e-12));
        CHECK(gd.density_conductivity == 0.0);
        const Transport near = GarzoDufty::transport<Goldshtein>(n, 1.7, 0.999);
        CHECK(near.shear_viscosity == Approx(jr.shear_viscosity).epsilon(5e-3));
        CHECK(near.density_conductivity != 0.0);
    }
    // Fourth cumulant of reference.md, a2 = c*/2, against simulation: -0.01424 at e = 0.8, 0.02118 at 0.6; the formula
    // is an estimate linear in a2, an eighth off at both.
    CHECK(0.5 * GarzoDufty::cumulant(0.8) == Approx(-0.01424).epsilon(0.13));
    CHECK(0.5 * GarzoDufty::cumulant(0.6) == Approx(0.02118).epsilon(0.13));
}

TEST_CASE("below freezing Carnahan and Starling's contact value gives the hard-sphere pressure") {
    // Z of Kolafa, Labik and Malijevsky 2004 (md/hard_sphere_theory.hpp); Carnahan and Starling are within 0.3 % of it.
    for (const auto& [nu, z] : {std::pair{0.10, 1.521647}, {0.30, 3.983985}, {0.45, 9.404139}})
        CHECK(1.0 + 4.0 * nu * CarnahanStarling::at(nu).g0 == Approx(z).epsilon(3e-3));
}

TEST_CASE("a fluid's transport is Carnahan and Starling's below freezing and stays finite at packing") {
    for (const double nu : {1e-9, 0.1, 0.48}) {
        const Transport fluid = JenkinsRichmanFluid::transport<Goldshtein>(nu / sphere_volume, 2.0, 0.7);
        const Transport whole = JenkinsRichman::transport<CarnahanStarling>(nu / sphere_volume, 2.0, 0.7);
        CHECK(fluid.shear_viscosity == Approx(whole.shear_viscosity).epsilon(1e-14));  // round-off
        CHECK(fluid.conductivity == Approx(whole.conductivity).epsilon(1e-14));
        CHECK(fluid.bulk_viscosity == Approx(whole.bulk_viscosity).epsilon(1e-14));
    }
    const double n = (Goldshtein::packing - 1e-9) / sphere_volume;
    // (1 - nu/2) / (1 - nu)^3 at 0.65: 15.74, so G_t = 10.23 and mu = n (sqrt(pi)/6) (0.03 + 1 + 3.856 * 10.23).
    CHECK(JenkinsRichmanFluid::transport<Goldshtein>(n, 1.0, 0.7).shear_viscosity == Approx(14.84).epsilon(0.002));
    CHECK(JenkinsRichmanFluid::cooling_rate<Goldshtein>(n, 0.7) == JenkinsRichman::cooling_rate<Goldshtein>(n, 0.7));
}

TEST_CASE("Bocquet and others' viscosity is Boltzmann's in thin gas and diverges by the power 1.75, all else by 1") {
    const auto at = [](double nu) {
        return JenkinsRichmanBocquet::transport<Goldshtein>(nu / sphere_volume, 1.0, 0.9);
    };
    CHECK(at(1e-12).shear_viscosity == Approx(5.0 / 16.0 / std::sqrt(std::numbers::pi)).epsilon(1e-9));
    const Transport near = at(Goldshtein::packing - 1e-5), nearer = at(Goldshtein::packing - 1e-6);
    // Truncation: the next term of each is of the order of the room left, 1e-5.
    CHECK(std::log10(nearer.shear_viscosity / near.shear_viscosity) == Approx(1.75).epsilon(1e-4));
    CHECK(std::log10(nearer.bulk_viscosity / near.bulk_viscosity) == Approx(1.0).epsilon(1e-4));
    CHECK(std::log10(nearer.conductivity / near.conductivity) == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("a closure asked by name gives the formulas of its header, by their powers of T") {
    const auto at = [](const char* closure, double temperature) {
        return closure_values({closure, {}}, {"goldshtein", {}}, 0.4, temperature, 0.7);
    };
    // The table of physics.md again, nine digits.
    const ClosureValues one = at("jenkins_richman", 1.0), four = at("jenkins_richman", 4.0);
    CHECK(one.pressure == Approx(3.78892459).epsilon(2e-8));
    CHECK(one.sound_speed == Approx(5.64608591).epsilon(2e-8));
    CHECK(one.transport.bulk_viscosity == Approx(1.33855898).epsilon(2e-8));
    CHECK(one.transport.shear_viscosity == Approx(1.29962695).epsilon(2e-8));
    CHECK(one.transport.conductivity == Approx(5.27841943).epsilon(2e-8));
    CHECK(one.cooling == Approx(3.07199285).epsilon(1e-7));
    CHECK(four.pressure == Approx(4.0 * one.pressure).epsilon(1e-15));  // round-off
    CHECK(four.sound_speed == Approx(2.0 * one.sound_speed).epsilon(1e-15));
    CHECK(four.transport.shear_viscosity == Approx(2.0 * one.transport.shear_viscosity).epsilon(1e-15));
    CHECK(four.cooling == Approx(8.0 * one.cooling).epsilon(1e-15));
    const ClosureValues heat = at("garzo_dufty", 1.0), hotter = at("garzo_dufty", 4.0);
    CHECK(hotter.transport.density_conductivity == Approx(8.0 * heat.transport.density_conductivity).epsilon(1e-14));
    // c* = 32 * 0.3 * 0.02 / (81 - 11.9 + 30 * 0.49 * 0.3) = 0.192/73.51, so the sink is 1 + 3 c*/32 of the other's.
    CHECK(heat.cooling / one.cooling == Approx(1.0 + 0.09375 * 0.192 / 73.51).epsilon(1e-14));

    CHECK_THROWS_WITH(at("jenkins_richmann", 1.0), Contains("did you mean \"jenkins_richman\"?"));
    CHECK_THROWS_AS(at("jenkins_richman", 0.0), std::invalid_argument);
    CHECK_THROWS_WITH(closure_values({"garzo_dufty", {}}, {"goldshtein", {}}, 0.65, 1.0, 0.9), Contains("0.65"));
    CHECK_THROWS_AS(closure_values({"garzo_dufty", {}}, {"goldshtein", {}}, 0.1, 1.0, 1.1), std::invalid_argument);
}

TEST_CASE("what a closure says of itself is what its formulas do") {
    for (const std::string& name : Closures::names()) {
        INFO(name);
        const ClosureTraits traits = traits_of({name, {}});
        const auto at = [&](double nu) { return closure_values({name, {}}, {"goldshtein", {}}, nu, 1.0, 0.8); };
        CHECK((at(0.3).transport.density_conductivity != 0.0) == traits.density_drives_heat);
        // With the terms in 1/G the viscosity tends to Boltzmann's, without them to 0 as the density.
        CHECK((at(1e-9).transport.shear_viscosity > 0.01) == traits.carries_between_contacts);
        const double of_maxwellian = closure_values({"jenkins_richman", {}}, {"goldshtein", {}}, 0.3, 1.0, 0.8).cooling;
        CHECK(at(0.3).cooling / of_maxwellian == Approx(traits.cooling_share(0.8)).epsilon(1e-14));  // round-off
    }
    for (const scene::Name& closure : Closures::described()) {
        INFO(closure.name);
        CHECK_FALSE(closure.words.empty());
        CHECK_FALSE(closure.reference.empty());
    }
}

TEST_CASE("the effective dissipation of e(v) takes the reference values") {
    const scene::Restitution law = scene::RestitutionVelocity{0.7, 1.0};
    const EffectiveDissipation table(law);
    CHECK_FALSE(table.is_constant());
    for (const auto& [t, d] : {std::pair{10.0, 0.509978}, {1.0, 0.508043}, {0.1, 0.429469}, {0.01, 0.206377}}) {
        INFO("temperature " << t);
        CHECK(effective_dissipation(law, t) == Approx(d).margin(5.1e-7));  // six digits are given
        CHECK(table(t) == Approx(d).margin(8e-7));                         // and the interpolation's 3.4e-7 relative
    }
}

TEST_CASE("the effective dissipation depends on T/v0^2 alone, and tends to T^(3/8) and to 1 - e0^2") {
    const scene::Restitution one = scene::RestitutionVelocity{0.8, 1.0}, three = scene::RestitutionVelocity{0.8, 3.0};
    CHECK(effective_dissipation(three, 9.0 * 0.37) == Approx(effective_dissipation(one, 0.37)).epsilon(1e-10));
    CHECK(effective_dissipation(one, 1e8) == Approx(0.36).epsilon(1e-10));
    // The next term is smaller by T^(3/8) (1 - e0)/2 or so: 1 % at T = 1e-6.
    CHECK(effective_dissipation(one, 1e-6) / effective_dissipation(one, 1e-8) ==
          Approx(std::pow(100.0, 0.375)).epsilon(1e-2));
    CHECK(EffectiveDissipation(scene::RestitutionConstant{0.9})(0.3) == Approx(0.19).epsilon(1e-15));
}

TEST_CASE("compare's equation of state is the solver's") {
    scene::Scene scene;
    scene.particles.restitution = scene::RestitutionConstant{0.7};
    const EquationOfState state = make_equation_of_state(scene);
    CHECK(state.sound_speed(0.4, 1.0) == Approx(5.64608591).epsilon(2e-9));
    CHECK(state.pressure(0.4, 1.0) == Approx(3.78892459).epsilon(2e-9));
    CHECK(state.sound_speed(0.4, 4.0) == Approx(2.0 * state.sound_speed(0.4, 1.0)).epsilon(1e-15));
    CHECK(state.specific_heat_at_constant_pressure(0.0) == Approx(2.5).epsilon(1e-12));
    CHECK(mean_free_path(1.0) == Approx(std::sqrt(std::numbers::pi / 8.0) / std::numbers::pi).epsilon(1e-15));
    scene.continuum.restitution = 0.9;
    CHECK(make_equation_of_state(scene).pressure(0.4, 1.0) > state.pressure(0.4, 1.0));
}

TEST_CASE("a name that is in no table is refused with the names that are") {
    scene::Scene scene;
    scene.continuum.pair_correlation = {"goldstein", {"layer.toml", 7, 3, "pair_correlation = \"goldstein\""}};
    CHECK_THROWS_WITH(make_equation_of_state(scene),
                      Contains("layer.toml:7:3") && Contains("goldshtein") && Contains("carnahan_starling"));
    scene::Continuum choices;
    choices.flux.name = "hlc";
    CHECK_THROWS_WITH(choose_kernels(choices), Contains("continuum.flux") && Contains("hllc"));
    choices = {};
    choices.limiter.name = "nolimit";
    CHECK_THROWS_AS(choose_kernels(choices), scene::SceneError);
    choices = {};
    choices.transport.name = "euler";
    CHECK_THROWS_WITH(choose_kernels(choices), Contains("inviscid"));
}
