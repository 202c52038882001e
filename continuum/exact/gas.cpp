// SPDX-License-Identifier: MIT
#include "continuum/exact/gas.hpp"

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>

#include "continuum/closures/effective_dissipation.hpp"

namespace shaken::continuum::exact {

double cooled_temperature(double temperature, double restitution, double contact_rate, double time) {
    const double rate = 4.0 / std::sqrt(std::numbers::pi) * (1.0 - restitution * restitution) * contact_rate;
    const double root = 1.0 + rate * std::sqrt(temperature) * time;
    return temperature / (root * root);
}

double cooled_temperature(double temperature, const scene::Restitution& law, double contact_rate, double time) {
    namespace odeint = boost::numeric::odeint;
    const auto slope = [&](double t, double& change, double /*time*/) {
        change = -8.0 / std::sqrt(std::numbers::pi) * effective_dissipation(law, t) * contact_rate * t * std::sqrt(t);
    };
    const auto stepper = odeint::make_controlled(0.0, 1e-12, odeint::runge_kutta_dopri5<double>());
    odeint::integrate_adaptive(stepper, slope, temperature, 0.0, time, 1e-3 * time);
    return temperature;
}

double sound_attenuation(double density, const Transport& transport, double specific_heat_at_constant_pressure) {
    const double viscous = transport.bulk_viscosity + 4.0 / 3.0 * transport.shear_viscosity;
    const double thermal = transport.conductivity * (1.0 / 1.5 - 1.0 / specific_heat_at_constant_pressure);
    return 0.5 * (viscous + thermal) / density;
}

double isothermal_volume_fraction(const EquationOfState& state, double bottom, double temperature, double height,
                                  int steps) {
    const auto slope = [&](double nu) {
        const double chi = state.pressure(nu, 1.0) / (nu / sphere_volume);
        // chi + nu dchi/dnu, from c_p = 3/2 + chi^2/(chi + nu dchi/dnu).
        const double stiffness = chi * chi / (state.specific_heat_at_constant_pressure(nu) - 1.5);
        return -nu / (temperature * stiffness);
    };
    const double h = height / steps;
    double nu = bottom;
    for (int i = 0; i < steps; ++i) {
        const double a = slope(nu), b = slope(nu + 0.5 * h * a), c = slope(nu + 0.5 * h * b), d = slope(nu + h * c);
        nu += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return nu;
}

}  // namespace shaken::continuum::exact
