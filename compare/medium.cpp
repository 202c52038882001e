// SPDX-License-Identifier: MIT
#include "compare/medium.hpp"

#include <cmath>

#include "continuum/closures/equation_of_state.hpp"

namespace shaken::compare {

Medium medium_of(const scene::Scene& scene) {
    const continuum::EquationOfState equation = continuum::make_equation_of_state(scene);
    return {[equation](double volume_fraction, double temperature) {
                if (volume_fraction >= equation.packing_limit()) return std::nan("");
                return equation.sound_speed(volume_fraction, temperature);
            },
            [](double density) { return continuum::mean_free_path(density); }};
}

}  // namespace shaken::compare
