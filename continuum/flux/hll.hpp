// SPDX-License-Identifier: MIT
// HLL: one averaged state between slowest and fastest wave. Harten, Lax & van Leer 1983; Toro 2009, section 10.3.
// Smears contacts; the most robust of the fluxes here, and what the others fall back on.
#pragma once

#include <string_view>

#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

struct FluxHll {
    using InSlowFlow = FluxHll;
    static constexpr std::string_view name = "hll";
    static constexpr std::string_view words = "one averaged state between the slowest and the fastest wave";

    [[gnu::always_inline]] static FaceFlux at(const FaceState& left, const FaceState& right, double packing_density) {
        const WaveSpeeds s = wave_speeds(left, right, packing_density);
        // With the waves clipped at the face one formula covers the supersonic cases too.
        const double slowest = smaller(s.slowest, 0.0);
        const double fastest = larger(s.fastest, 0.0);
        const double width_inverse = 1.0 / (fastest - slowest);
        const double carried_left = left.density * left.normal, carried_right = right.density * right.normal;
        const double internal_left = 1.5 * left.density * left.temperature;
        const double internal_right = 1.5 * right.density * right.temperature;
        const double total_left = internal_left + 0.5 * left.density * speed_squared(left);
        const double total_right = internal_right + 0.5 * right.density * speed_squared(right);
        const auto average = [&](double flux_left, double flux_right, double jump) {
            return width_inverse * ((fastest * flux_left - slowest * flux_right) + (slowest * fastest) * jump);
        };
        const double mass = average(carried_left, carried_right, right.density - left.density);
        const double upwind_1 = mass >= 0.0 ? left.tangent_1 : right.tangent_1;
        const double upwind_2 = mass >= 0.0 ? left.tangent_2 : right.tangent_2;
        return {mass,
                average(carried_left * left.normal + left.pressure, carried_right * right.normal + right.pressure,
                        carried_right - carried_left),
                mass * upwind_1,
                mass * upwind_2,
                average((total_left + left.pressure) * left.normal, (total_right + right.pressure) * right.normal,
                        total_right - total_left),
                average(internal_left * left.normal, internal_right * right.normal, internal_right - internal_left),
                width_inverse * (fastest * left.normal - slowest * right.normal),
                s.signal};
    }

  private:
    static double speed_squared(const FaceState& state) {
        return state.normal * state.normal + (state.tangent_1 * state.tangent_1 + state.tangent_2 * state.tangent_2);
    }
};

}  // namespace shaken::continuum
