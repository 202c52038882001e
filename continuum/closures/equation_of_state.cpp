// SPDX-License-Identifier: MIT
#include "continuum/closures/equation_of_state.hpp"

#include <cmath>
#include <numbers>

#include "continuum/closures/closures.hpp"
#include "continuum/closures/effective_dissipation.hpp"

namespace shaken::continuum {

double EquationOfState::pressure(double volume_fraction, double temperature) const {
    return volume_fraction / sphere_volume * temperature * law_(volume_fraction, restitution_).chi;
}

double EquationOfState::sound_speed(double volume_fraction, double temperature) const {
    const Compressibility z = law_(volume_fraction, restitution_);
    return std::sqrt(temperature * (z.chi * (1.0 + (2.0 / 3.0) * z.chi) + z.slope));
}

double EquationOfState::specific_heat_at_constant_pressure(double volume_fraction) const {
    const Compressibility z = law_(volume_fraction, restitution_);
    return 1.5 + z.chi * z.chi / (z.chi + z.slope);
}

double EquationOfState::collision_rate(double volume_fraction, double temperature) const {
    const double g = (law_(volume_fraction, restitution_).chi - 1.0) / (2.0 * (1.0 + restitution_));
    return 24.0 / std::sqrt(std::numbers::pi) * g * std::sqrt(temperature);
}

EquationOfState make_equation_of_state(const scene::Choice& pair_correlation, double restitution) {
    return choose(
        PairCorrelations{}, "continuum.pair_correlation", pair_correlation, [&](auto pair) -> EquationOfState {
            using Pair = decltype(pair);
            const EquationOfState::Law law = [](double volume_fraction, double e) -> EquationOfState::Compressibility {
                const Contact contact = Pair::at(volume_fraction);
                const double virial = 2.0 * (1.0 + e);
                return {compressibility(volume_fraction, contact, virial),
                        compressibility_slope(volume_fraction, contact, virial)};
            };
            return {law, restitution, Pair::packing};
        });
}

EquationOfState make_equation_of_state(const scene::Scene& scene) {
    choose(Closures{}, "continuum.closure", scene.continuum.closure, [](auto) { return true; });
    return make_equation_of_state(scene.continuum.pair_correlation, pressure_restitution(scene));
}

double mean_free_path(double density) { return std::sqrt(std::numbers::pi / 8.0) / (density * std::numbers::pi); }

}  // namespace shaken::continuum
