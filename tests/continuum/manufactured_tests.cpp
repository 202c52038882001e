// SPDX-License-Identifier: MIT
// Manufactured solutions: flows that stand still because a source balances everything the equations would do to them.
// The balance is written down here once more, from the equations and not from the solver: point values of smooth
// fields, closures and differences of sixth order. What the solver then does to the flow is its own error.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "continuum/closures/closures.hpp"
#include "continuum/closures/equation_of_state.hpp"
#include "continuum/step/evolution.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;
using namespace continuum;

namespace {

constexpr double length = 20.0, wave = 2.0 * std::numbers::pi / length;

/// Density, velocity along x and z, temperature.
using State = std::array<double, 4>;
using Field = std::function<State(double x, double z)>;

struct Physics {
    std::string closure = "jenkins_richman", pair_correlation = "goldshtein", scheme = "muscl";
    double restitution = 1.0, gravity = 0.0;
};

/// The right-hand side of the equations for n, u_x, u_z and T at a point, at rest in time.
class Balance {
  public:
    Balance(Field field, const Physics& physics)
        : field_(std::move(field)),
          physics_(physics),
          state_(make_equation_of_state({physics.pair_correlation, {}}, physics.restitution)) {}

    State rate(double x, double z) const {
        const auto [n, u, w, t] = field_(x, z);
        const auto value = [&](std::size_t i) { return [this, i](double a, double b) { return field_(a, b)[i]; }; };
        const double div = along_x(value(1), x, z) + along_z(value(2), x, z);
        const double pressure = pressure_at(x, z);
        const auto p = [this](double a, double b) { return pressure_at(a, b); };
        const auto fluxes = [this](std::size_t i) {
            return [this, i](double a, double b) { return diffusive_flux(a, b)[i]; };
        };
        const auto flux = diffusive_flux(x, z);  // xx, xz, zz, heat x, heat z
        const double force_x = along_x(fluxes(0), x, z) + along_z(fluxes(1), x, z) - along_x(p, x, z);
        const double force_z = along_x(fluxes(1), x, z) + along_z(fluxes(2), x, z) - along_z(p, x, z);
        const double work = flux[0] * along_x(value(1), x, z) + flux[2] * along_z(value(2), x, z) +
                            flux[1] * (along_z(value(1), x, z) + along_x(value(2), x, z));
        const double heat = along_x(fluxes(3), x, z) + along_z(fluxes(4), x, z);
        const auto carried = [&, ux = u, uz = w](std::size_t i) {
            return ux * along_x(value(i), x, z) + uz * along_z(value(i), x, z);
        };
        const double e = physics_.restitution;
        return {-carried(0) - n * div, -carried(1) + force_x / n, -carried(2) + force_z / n - physics_.gravity,
                -carried(3) + 2.0 / (3.0 * n) * (work - pressure * div + heat) -
                    cooling_rate(n) * (1.0 - e * e) * t * std::sqrt(t)};
    }

  private:
    static constexpr double step = 0.02;  // of the differences: (wave step)^6 = 6e-14 of a slope

    template <class F>
    static double slope(F f) {
        return (45.0 * (f(1) - f(-1)) - 9.0 * (f(2) - f(-2)) + (f(3) - f(-3))) / (60.0 * step);
    }
    template <class F>
    static double along_x(const F& f, double x, double z) {
        return slope([&](int i) { return f(x + i * step, z); });
    }
    template <class F>
    static double along_z(const F& f, double x, double z) {
        return slope([&](int i) { return f(x, z + i * step); });
    }

    double pressure_at(double x, double z) const {
        const State s = field_(x, z);
        return state_.pressure(s[0] * sphere_volume, s[3]);
    }

    template <class Visit>
    auto with_closure(Visit visit) const {
        return choose(Closures{}, "closure", {physics_.closure, {}}, [&](auto closure) {
            return choose(PairCorrelations{}, "pair_correlation", {physics_.pair_correlation, {}},
                          [&](auto pair) { return visit(closure, pair); });
        });
    }
    double cooling_rate(double n) const {
        return with_closure([&](auto closure, auto pair) {
            return decltype(closure)::template cooling_rate<decltype(pair)>(n, physics_.restitution);
        });
    }

    std::array<double, 5> diffusive_flux(double x, double z) const {
        const auto [n, u, w, t] = field_(x, z);
        const Transport c = with_closure([&, density = n, temperature = t](auto closure, auto pair) {
            return decltype(closure)::template transport<decltype(pair)>(density, temperature, physics_.restitution);
        });
        const auto slope_x = [&](std::size_t i) {
            return along_x([&](double a, double b) { return field_(a, b)[i]; }, x, z);
        };
        const auto slope_z = [&](std::size_t i) {
            return along_z([&](double a, double b) { return field_(a, b)[i]; }, x, z);
        };
        const double spread = (c.bulk_viscosity - 2.0 / 3.0 * c.shear_viscosity) * (slope_x(1) + slope_z(2));
        return {spread + 2.0 * c.shear_viscosity * slope_x(1), c.shear_viscosity * (slope_z(1) + slope_x(2)),
                spread + 2.0 * c.shear_viscosity * slope_z(2),
                c.conductivity * slope_x(3) + c.density_conductivity * slope_x(0),
                c.conductivity * slope_z(3) + c.density_conductivity * slope_z(0)};
    }

    Field field_;
    Physics physics_;
    EquationOfState state_;
};

/// Mean distance from the field after `time`, in so many steps, on cells x cells.
State errors(const Field& field, const Physics& physics, std::int64_t cells, double time, int steps) {
    Grid grid;
    grid.nx = grid.nz = cells;
    grid.dx = grid.dz = length / static_cast<double>(cells);
    Setup setup(grid);
    setup.boundaries.lower.end = setup.boundaries.upper.end = End::periodic;
    setup.choices.scheme.name = physics.scheme;
    setup.choices.closure.name = physics.closure;
    setup.choices.pair_correlation.name = physics.pair_correlation;
    setup.restitution = physics.restitution;
    setup.sink = scene::RestitutionConstant{physics.restitution};
    setup.gravity = physics.gravity;
    const Balance balance(field, physics);
    std::vector<State> exact, source;
    for (std::int64_t ix = 0; ix < cells; ++ix) {
        for (std::int64_t iz = 0; iz < cells; ++iz) {
            const double x = (static_cast<double>(ix) + 0.5) * grid.dx, z = grid.centre(iz);
            exact.push_back(field(x, z));
            source.push_back(balance.rate(x, z));
        }
    }
    const auto for_cells = [&](Flow& flow, const std::function<void(std::array<double*, 4>, std::size_t)>& visit) {
        for (std::int64_t ix = 0; ix < cells; ++ix) {
            for (std::int64_t iz = 0; iz < cells; ++iz) {
                const auto i = static_cast<std::size_t>(grid.first(ix) + iz);
                visit({&flow.density[i], &flow.velocity_x[i], &flow.velocity_z[i], &flow.temperature[i]},
                      static_cast<std::size_t>(ix * cells + iz));
            }
        }
    };
    for_cells(setup.flow, [&](auto cell, std::size_t i) {
        for (std::size_t k = 0; k < 4; ++k) *cell[k] = exact[i][k];
    });
    Evolution evolution(setup);
    const auto push = [&](double dt) {
        for_cells(evolution.flow(), [&](auto cell, std::size_t i) {
            for (std::size_t k = 0; k < 4; ++k) *cell[k] -= dt * source[i][k];
        });
    };
    // Half of the source before and half after each step: second order (Strang 1968).
    const double dt = time / steps;
    for (int s = 0; s < steps; ++s) {
        push(0.5 * dt);
        evolution.step(s * dt, dt);
        push(0.5 * dt);
    }
    State sum{};
    for_cells(evolution.flow(), [&](auto cell, std::size_t i) {
        for (std::size_t k = 0; k < 4; ++k)
            sum[k] += std::abs(*cell[k] - exact[i][k]) / static_cast<double>(cells * cells);
    });
    return sum;
}

double total(const State& s) { return s[0] + s[1] + s[2] + s[3]; }

/// Observed order in space of the sum of the four mean errors, from 16 and 32 cells a side; printed with the errors.
/// The steps go with the square of the spacing, so that what is first order in time, the diffusion, keeps out of it.
double order(const std::string& name, const Field& field, const Physics& physics) {
    constexpr std::int64_t cells = 16;
    constexpr double time = 1.0;
    constexpr int steps = 32;  // of two carries each: Courant number near 0.1
    const double coarse = total(errors(field, physics, cells, time, steps));
    const double fine = total(errors(field, physics, 2 * cells, time, 4 * steps));
    const double found = std::log2(coarse / fine);
    fmt::print("manufactured, {:<44} {:<8} {:.3e} {:.3e}   order {:.2f}\n", name, physics.scheme, coarse, fine, found);
    return found;
}

constexpr double density = 0.3 * 6.0 / std::numbers::pi;

}  // namespace

TEST_CASE("each diffusive term alone holds a manufactured solution to second order", "[convergence]") {
    const auto sine = [](double s) { return std::sin(wave * s); };
    struct Case {
        std::string name;
        Field field;
        Physics physics;
    };
    Physics heat_of_density;
    heat_of_density.closure = "garzo_dufty";
    heat_of_density.restitution = 0.8;
    Physics cooling;
    cooling.restitution = 0.8;
    const auto [name, field, physics] = GENERATE_COPY(values<Case>({
        {"conduction along z",
         [=](double, double z) {
             return State{density, 0.0, 0.0, 1.0 + 0.2 * sine(z)};
         },
         {}},
        {"conduction along x",
         [=](double x, double) {
             return State{density, 0.0, 0.0, 1.0 + 0.2 * sine(x)};
         },
         {}},
        {"shear of u_x along z",
         [=](double, double z) {
             return State{density, 0.5 * sine(z), 0.0, 1.0};
         },
         {}},
        {"shear of u_z along x",
         [=](double x, double) {
             return State{density, 0.0, 0.5 * sine(x), 1.0};
         },
         {}},
        {"compression along z",
         [=](double, double z) {
             return State{density, 0.0, 0.3 * sine(z), 1.0};
         },
         {}},
        {"compression along x",
         [=](double x, double) {
             return State{density, 0.3 * sine(x), 0.0, 1.0};
         },
         {}},
        {"mixed derivatives",
         [=](double x, double z) {
             return State{density, 0.3 * sine(x + z), 0.3 * sine(z - x), 1.0};
         },
         {}},
        {"heat along the density gradient",
         [=](double x, double z) {
             return State{density * (1.0 + 0.2 * sine(x + z)), 0.0, 0.0, 1.0};
         },
         heat_of_density},
        {"cooling",
         [=](double x, double z) {
             return State{density * (1.0 + 0.2 * sine(x)), 0.0, 0.0, 1.0 + 0.2 * sine(z)};
         },
         cooling},
    }));
    CHECK(order(name, field, physics) > 1.85);
}

TEST_CASE("all terms at once hold a manufactured solution to second order", "[convergence]") {
    const Field field = [](double x, double z) {
        return State{density * (1.0 + 0.2 * std::sin(wave * (x + z)) + 0.05 * std::cos(2.0 * wave * z)),
                     0.3 + 0.2 * std::cos(wave * (x - z)), -0.2 + 0.3 * std::sin(wave * (z + 2.0 * x)),
                     1.0 + 0.2 * std::cos(wave * (z + x)) + 0.1 * std::sin(wave * x)};
    };
    Physics physics;
    physics.restitution = 0.9;
    physics.gravity = 0.1;
    const auto [closure, pair] = GENERATE(table<std::string, std::string>(
        {{"jenkins_richman", "goldshtein"}, {"jenkins_richman", "carnahan_starling"}, {"garzo_dufty", "goldshtein"}}));
    physics.closure = closure;
    physics.pair_correlation = pair;
    physics.scheme = GENERATE("muscl", "weno5");
    CHECK(order("all terms, " + closure + ", " + pair, field, physics) > 1.85);
}
