// SPDX-License-Identifier: MIT
// The exact solutions, against the values of reference.md section 2, and the runs that are held against them.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>

#include "continuum/closures/closures.hpp"
#include "continuum/exact/gas.hpp"
#include "continuum/exact/heated_layer.hpp"
#include "continuum/exact/riemann.hpp"
#include "continuum/verification.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;
using scene::GasState;

namespace {

EquationOfState elastic() { return make_equation_of_state(scene::Choice{"goldshtein", {}}, 1.0); }

scene::Scene tube(scene::Kind kind, double length, double time, double spacing) {
    scene::Scene scene;
    scene.kind = kind;
    scene.tube.length = length;
    scene.tube.time = time;
    scene.continuum.spacing = spacing;
    return scene;
}

}  // namespace

TEST_CASE("the exact Riemann solver has the star states of the reference", "[validation]") {
    struct Case {
        GasState left, right;
        double pressure, velocity;
    };
    const Case c = GENERATE(Case{{1e-8, 0.0, 1.0}, {1.25e-9, 0.0, 0.8}, 2.9394519e-9, 0.84119486},
                            Case{{0.4, 0.0, 1.0}, {0.05, 0.0, 1.0}, 0.27807153, 1.41748760},
                            Case{{0.3, -2.0, 1.0}, {0.3, 2.0, 1.0}, 0.029430711, 0.0});
    const exact::Riemann solution(c.left, c.right, elastic());
    CHECK(solution.pressure() == Approx(c.pressure).epsilon(3e-8));  // the reference's digits
    CHECK(solution.velocity() == Approx(c.velocity).margin(2e-8));
}

TEST_CASE("the exact Riemann solver has the densities, temperatures and the shock of the reference", "[validation]") {
    const exact::Riemann solution({0.4, 0.0, 1.0}, {0.05, 0.0, 1.0}, elastic());
    CHECK(solution.left_star().volume_fraction == Approx(0.26931956).epsilon(3e-8));
    CHECK(solution.right_star().volume_fraction == Approx(0.093156826).epsilon(3e-8));
    CHECK(solution.left_star().temperature == Approx(0.34218922).epsilon(3e-8));
    CHECK(solution.right_star().temperature == Approx(2.04787479).epsilon(3e-8));
    CHECK(solution.right_wave_speed() == Approx(3.05973949).epsilon(3e-8));
    // Its profile is continuous through the rarefaction and jumps at contact and shock.
    const double contact = solution.velocity(), shock = solution.right_wave_speed();
    CHECK(solution.at(contact - 1e-9).volume_fraction == Approx(0.26931956).epsilon(3e-8));
    CHECK(solution.at(contact + 1e-9).volume_fraction == Approx(0.093156826).epsilon(3e-8));
    CHECK(solution.at(shock + 1e-9).volume_fraction == 0.05);
    for (double speed = -6.0; speed + 0.01 < contact; speed += 0.01)
        CHECK(std::abs(solution.at(speed + 0.01).volume_fraction - solution.at(speed).volume_fraction) < 2e-3);
}

TEST_CASE("a shock of Mach 2 into volume fraction 0.2 compresses and heats as the reference says", "[validation]") {
    // The piston that drives it: found from the exact solver itself by asking for the front's Mach number.
    const EquationOfState state = elastic();
    const double c = state.sound_speed(0.2, 1.0);
    double low = 0.1 * c, high = 2.0 * c;
    for (int i = 0; i < 80; ++i) {
        const double u = 0.5 * (low + high);
        const exact::Riemann s({0.2, u, 1.0}, {0.2, -u, 1.0}, state);
        (s.right_wave_speed() + u < 2.0 * c ? low : high) = u;
    }
    const exact::Riemann s({0.2, low, 1.0}, {0.2, -low, 1.0}, state);
    CHECK(s.right_star().volume_fraction / 0.2 == Approx(1.44584711).epsilon(3e-8));
    CHECK(s.right_star().temperature == Approx(2.41156147).epsilon(3e-8));
}

TEST_CASE("the exact piston has the plateau of the reference", "[validation]") {
    const exact::Riemann s({0.1, 1.0, 1e-12}, {0.1, -1.0, 1e-12}, elastic());
    CHECK(s.right_star().volume_fraction == Approx(0.22178164).epsilon(3e-8));
    CHECK(s.right_star().temperature == Approx(1.0 / 3.0).epsilon(1e-9));
    CHECK(s.right_wave_speed() + 1.0 == Approx(1.82114187).epsilon(3e-8));
}

TEST_CASE("two states that part faster than a vacuum opens are refused") {
    CHECK_THROWS_AS(exact::Riemann({0.1, -50.0, 1.0}, {0.1, 50.0, 1.0}, elastic()), std::domain_error);
}

TEST_CASE("attenuation of sound, columns and heated layers have the values of the reference", "[validation]") {
    const EquationOfState state = elastic();
    const auto attenuation = [&](double nu) {
        const Transport t = JenkinsRichman::transport<Goldshtein>(nu / sphere_volume, 1.0, 1.0);
        return exact::sound_attenuation(nu / sphere_volume, t, state.specific_heat_at_constant_pressure(nu));
    };
    CHECK(attenuation(0.1) == Approx(1.56797960).epsilon(1e-8));
    CHECK(attenuation(0.3) == Approx(2.02295631).epsilon(1e-8));
    CHECK(exact::isothermal_volume_fraction(state, 0.3, 1.0, 3.32533494) == Approx(0.15).epsilon(1e-8));
    CHECK(exact::isothermal_volume_fraction(state, 0.3, 1.0, 6.22738523) == Approx(0.03).epsilon(1e-8));
    CHECK(exact::heated_layer_temperature(1.0, 1.0, exact::dilute_jenkins_richman(0.9), 0.0) ==
          Approx(0.78113952).epsilon(1e-8));
    // Haff: T falls to a quarter when (4/sqrt(pi)) (1 - e^2) G sqrt(T) t = 1.
    const double t = std::sqrt(std::numbers::pi) / 4.0 / (0.19 * 0.1246041);
    CHECK(exact::cooled_temperature(1.0, 0.9, 0.1246041, t) == Approx(0.25).epsilon(1e-12));
}

TEST_CASE("the exact heated layer obeys the equations of a dilute layer, integrated down from its top") {
    const double m = GENERATE(0.0, 0.1, 0.4);
    const exact::DiluteGas gas{0.8, m, 1.3};
    // Pressure, heat flux, temperature over height: p = n T, dp/dz = -n, dq/dz = -gamma, q = -kappa dT/dz - mu_n dn/dz
    // with dn/dz = -(n/T)(1 + dT/dz).
    using State = std::array<double, 3>;
    const auto slope = [&](const State& s, State& change, double) {
        const double n = s[0] / s[2], root = std::sqrt(s[2]);
        const double kappa = gas.conductivity * root, mu_n = gas.density_conductivity * s[2] * root / n;
        change = {-n, -gas.cooling * n * n * s[2] * root, (mu_n * n / s[2] - s[1]) / (kappa - mu_n * n / s[2])};
    };
    namespace odeint = boost::numeric::odeint;
    State s{1e-5, 0.0, 2.0};
    std::vector<State> seen;
    const auto stepper = odeint::make_controlled(0.0, 1e-12, odeint::runge_kutta_dopri5<State>());
    double z = 0.0;
    while (s[0] < 2.0) {
        const double down = 0.5 * s[2];  // half the height over which p falls by e
        odeint::integrate_adaptive(stepper, slope, s, z, z - down, -1e-3);
        z -= down;
        seen.push_back(s);
    }
    for (const State& at : seen) {
        INFO("density conductivity " << m << ", weight " << at[0]);
        // No flux at p = 1e-5 in the place of p = 0.
        CHECK(exact::heated_layer_temperature(s[2], s[0], gas, at[0]) == Approx(at[2]).epsilon(1e-4));
    }
}

TEST_CASE("a Riemann problem of any states is held against its exact solution") {
    scene::Scene scene = tube(scene::Kind::riemann, 10.0, 0.6, 0.05);
    CHECK(verify(scene).why_no_exact.find("inviscid") != std::string::npos);
    scene.continuum.transport.name = "inviscid";
    const Verification coarse = verify(scene);
    scene.continuum.spacing = 0.025;
    const Verification fine = verify(scene);
    CHECK(fine.why_no_exact.empty());
    // First order at the shock, 2/3 at the contact: a factor of 1.6 at least, and below a percent.
    CHECK(coarse.volume_fraction_error / fine.volume_fraction_error > 1.5);
    CHECK(fine.volume_fraction_error < 5e-3);
    CHECK(fine.velocity_error < 1e-2);
    scene.tube.time = 4.0;
    CHECK(verify(scene).why_no_exact.find("end of the tube") != std::string::npos);
}

TEST_CASE("sound runs and fades as the linear theory says", "[validation]") {
    const auto run = [](double spacing) {
        scene::Scene scene = tube(scene::Kind::wave, 400.0, 800.0, spacing);
        scene.tube.gas.volume_fraction = 0.1;
        return verify(scene);
    };
    const Verification v = run(4.0);
    REQUIRE(v.numbers.size() == 2);
    // Truncation at 100 cells a wavelength; the next order of the theory, of order (Gamma k/c)^2 = 2e-4, slows the
    // sound.
    CHECK(v.numbers[0].relative_error() == Approx(0.0).margin(1e-3));
    // The scheme's own damping of the clipped crests and backward Euler's: a few per cent of the wave's.
    CHECK(v.numbers[1].relative_error() == Approx(0.0).margin(4e-2));
}

TEST_CASE("a dilute layer on a heated bottom has the temperature of the reference", "[validation]") {
    scene::Scene scene = tube(scene::Kind::column, 12000.0, 2000.0, 60.0);
    scene.tube.restitution = 0.9;
    scene.tube.wall_temperature = 1000.0;
    scene.tube.gas.temperature = 900.0;
    const Verification v = verify(scene);
    REQUIRE(v.numbers.size() == 2);
    CHECK(v.numbers[0].exact == Approx(0.78113952).epsilon(1e-6));
    // Not quite dilute: nu = 5e-4 at the bottom changes chi and kappa by some 2e-3 there.
    CHECK(v.numbers[0].computed == Approx(0.78113952).epsilon(1e-2));
}

TEST_CASE("heat along the density gradient warms the top of a dilute layer, by the same amount for every step",
          "[validation]") {
    const auto run = [](double cfl) {
        scene::Scene scene = tube(scene::Kind::column, 12000.0, 10000.0, 120.0);
        scene.tube.restitution = 0.9;
        scene.tube.wall_temperature = 1000.0;
        scene.tube.gas.temperature = 900.0;
        scene.continuum.closure.name = "garzo_dufty";
        scene.continuum.cfl = cfl;
        return verify(scene);
    };
    const Verification v = run(0.8), fine = run(0.2);
    REQUIRE(v.numbers.size() == 2);
    REQUIRE(v.numbers[0].why_no_exact.empty());
    const auto at = [](const Verification& of, double height) {
        return of.temperature[static_cast<std::size_t>(height / 120.0)] / 1000.0;
    };
    // Truncation of cells of 120 at the wall, and not quite dilute (nu = 5e-4): 0.0028; 0.0070 where the wall gives no
    // heat along the density gradient.
    CHECK(v.numbers[1].computed < 4e-3);
    CHECK(at(v, 6300.0) == Approx(1.52).epsilon(1e-2));
    CHECK(at(fine, 6300.0) == Approx(at(v, 6300.0)).epsilon(5e-3));
}

TEST_CASE("an exact value is shown where it is exact, and elsewhere the reason why there is none") {
    scene::Scene scene = tube(scene::Kind::column, 12000.0, 10.0, 600.0);
    scene.tube.restitution = 0.9;
    scene.tube.wall_temperature = 1000.0;
    scene.tube.gas.temperature = 900.0;
    const auto reason = [&] { return verify(scene).numbers.front().why_no_exact; };
    for (const char* closure : {"jenkins_richman", "jenkins_richman_fluid", "jenkins_richman_bocquet", "garzo_dufty"}) {
        scene.continuum.closure.name = closure;
        CHECK(reason().empty());
    }
    scene.continuum.closure.name = "jenkins_richman_dense";
    CHECK_THAT(reason(), Contains("jenkins_richman_dense"));
    scene.continuum.closure.name = "jenkins_richman";
    scene.tube.number_per_area = 50.0;
    CHECK_THAT(reason(), Contains("dilute"));

    scene::Scene wave = tube(scene::Kind::wave, 40.0, 40.0, 1.0);
    wave.tube.gas.volume_fraction = 0.1;
    wave.tube.restitution = 0.9;
    CHECK_THAT(verify(wave).numbers.front().why_no_exact, Contains("restitution = 1"));

    scene::Scene column = tube(scene::Kind::column, 16.0, 0.1, 0.5);
    column.tube.restitution = 0.9;
    CHECK_THAT(verify(column).why_no_exact, Contains("restitution = 1"));

    scene::Scene flow = tube(scene::Kind::cooling_flow, 5.0e6, 1.0e4, 2.5e5);
    flow.tube.restitution = 0.9;
    flow.tube.gas.volume_fraction = 1e-6;
    flow.continuum.transport.name = "inviscid";
    CHECK(verify(flow).why_no_exact.empty());
    flow.continuum.closure.name = "garzo_dufty";
    CHECK_THAT(verify(flow).why_no_exact, Contains("garzo_dufty"));
}

TEST_CASE("a steady state is one number, whatever the number and the length of the steps") {
    scene::Scene scene = tube(scene::Kind::column, 12000.0, 4000.0, 200.0);
    scene.tube.restitution = 0.7;
    scene.tube.wall_temperature = 1000.0;
    scene.tube.gas.temperature = 900.0;
    const double at_wall = verify(scene).temperature.front();
    for (const double later : {4.0, 8.0, 12.0}) {  // half a step, a step, one and a half
        scene.tube.time = 4000.0 + later;
        // What has not settled yet: 4e-6 in three time units.
        CHECK(verify(scene).temperature.front() == Approx(at_wall).epsilon(2e-5));
    }
    scene.tube.time = 4000.0;
    scene.continuum.cfl = 0.4;
    const double at_half = verify(scene).temperature.front();
    scene.continuum.cfl = 0.2;
    const double at_quarter = verify(scene).temperature.front();
    // Truncation of a step in which conduction crosses ten cells; it falls with the step.
    CHECK(at_wall == Approx(at_quarter).epsilon(5e-3));
    CHECK(at_half == Approx(at_quarter).epsilon(2e-3));
}

TEST_CASE("a column at rest stays at rest", "[validation]") {
    scene::Scene scene = tube(scene::Kind::column, 16.0, 30.0, 0.1);
    const Verification v = verify(scene);
    CHECK(v.why_no_exact.empty());
    CHECK(v.volume_fraction_error < 1e-3);  // truncation at the walls, second order
    CHECK(v.velocity_error < 1e-3);
}

TEST_CASE("a piston is held against its exact shock", "[validation]") {
    scene::Scene scene = tube(scene::Kind::piston, 10.0, 2.0, 0.025);
    scene.continuum.transport.name = "inviscid";
    scene.tube.gas = {0.3, 0.0, 1e-8};
    const Verification v = verify(scene);
    CHECK(v.why_no_exact.empty());
    CHECK(v.volume_fraction_error < 1e-2);  // entropy noise of 1 % and two cells of the front
    CHECK(v.temperature_error < 3e-2);
}

TEST_CASE("a uniform scene cools by Haff's law, or by the equation of its e(v)", "[validation]") {
    scene::Scene scene;
    scene.kind = scene::Kind::uniform;
    scene.initial.volume_fraction = 0.2;
    scene.initial.temperature = 1.0;
    scene.box.x = 10.0;
    scene.uniform.settle = 0.0;
    scene.uniform.duration = 20.0;
    scene.particles.restitution = scene::RestitutionConstant{0.9};
    const Verification haff = verify(scene);
    REQUIRE(haff.why_no_exact.empty());
    CHECK(haff.temperature.front() < 0.1);
    CHECK(haff.temperature_error < 1e-11);  // round-off
    scene.continuum.closure.name = "garzo_dufty";
    CHECK(verify(scene).temperature_error < 1e-11);
    CHECK(verify(scene).temperature.front() != haff.temperature.front());
    scene.continuum.closure.name = "jenkins_richman";
    scene.particles.restitution = scene::RestitutionVelocity{0.7, 1.0};
    const Verification slowed = verify(scene);
    CHECK(slowed.temperature.front() < 0.1);
    CHECK(slowed.temperature_error < 1e-3);  // truncation: D(T) is taken anew every step
}

TEST_CASE("gas that cools streams to a wall as the exact cooling flow does", "[validation]") {
    const auto run = [](double spacing) {
        scene::Scene scene = tube(scene::Kind::cooling_flow, 5.0e6, 2.2e6, spacing);
        scene.tube.restitution = 0.9;
        scene.tube.gas.volume_fraction = 1e-6;
        scene.continuum.transport.name = "inviscid";
        return verify(scene);
    };
    const Verification coarse = run(2.5e4), fine = run(6.25e3);
    REQUIRE(fine.why_no_exact.empty());
    // At the wall 1/(1 - t/t*)^2 times what it was, t* = 3.896e6.
    CHECK(fine.exact_volume_fraction.front() == Approx(5.3e-6).epsilon(0.01));
    // Away from the free surface, where the density falls to nothing at once, the flow is smooth: second order.
    const auto error_below = [](const Verification& v, double height) {
        double difference = 0.0, size = 0.0;
        for (std::size_t i = 0; i < v.height.size() && v.height[i] < height; ++i) {
            difference += std::abs(v.volume_fraction[i] - v.exact_volume_fraction[i]);
            size += v.exact_volume_fraction[i];
        }
        return difference / size;
    };
    CHECK(std::log(error_below(coarse, 5.0e5) / error_below(fine, 5.0e5)) / std::log(4.0) > 1.8);
    CHECK(error_below(fine, 5.0e5) < 5e-5);
}
