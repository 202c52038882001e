// SPDX-License-Identifier: MIT
// HLLC: two averaged states between the slowest and the fastest wave, parted by the contact, which it resolves exactly.
// Toro, Spruce & Speares 1994; Batten and others 1997. Any equation of state: only pressures and sound speeds enter.
//      s_l   s*   s_r
//        \ L*|R* /
//      L  \  |  /  R
// Written so that the mirrored problem gives the mirrored bits.
#pragma once

#include <string_view>

#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

struct FluxHllcSlow;

struct FluxHllc {
    using InSlowFlow = FluxHllcSlow;
    static constexpr std::string_view name = "hllc";
    static constexpr std::string_view words = "two states, parted by the contact wave";

    [[gnu::always_inline]] static FaceFlux at(const FaceState& left, const FaceState& right, double packing_density) {
        const WaveSpeeds s = wave_speeds(left, right, packing_density);
        const double mass_left = left.density * (s.slowest - left.normal);     // through the left wave, < 0
        const double mass_right = right.density * (s.fastest - right.normal);  // through the right wave, > 0
        // Toro 2009, eq. 10.37: speed of the contact.
        const double contact =
            ((right.pressure - left.pressure) + (mass_left * left.normal - mass_right * right.normal)) /
            (mass_left - mass_right);
        const double pressure_star = 0.5 * ((left.pressure + mass_left * (contact - left.normal)) +
                                            (right.pressure + mass_right * (contact - right.normal)));

        // The state the face lies in: outside the fan the velocity there is the gas's own, and then the star formulas
        // below reduce to the plain flux.
        const bool from_left = s.slowest >= 0.0 ? true : (s.fastest <= 0.0 ? false : contact >= 0.0);
        const bool inside = (s.slowest < 0.0) & (s.fastest > 0.0);
        const double normal = from_left ? left.normal : right.normal;
        const double tangent_1 = from_left ? left.tangent_1 : right.tangent_1;
        const double tangent_2 = from_left ? left.tangent_2 : right.tangent_2;
        const double temperature = from_left ? left.temperature : right.temperature;
        const double pressure_side = from_left ? left.pressure : right.pressure;
        const double wave = from_left ? s.slowest : s.fastest;
        const double through = from_left ? mass_left : mass_right;
        const double velocity = inside ? contact : normal;
        const double pressure = inside ? pressure_star : pressure_side;

        const double mass = through / (wave - velocity) * velocity;
        const double internal = 1.5 * temperature;
        const double kinetic = 0.5 * (normal * normal + (tangent_1 * tangent_1 + tangent_2 * tangent_2));
        // Toro 2009, eq. 10.39: energy per mass of the star state.
        const double energy = (internal + kinetic) + (velocity - normal) * (velocity + pressure_side / through);
        return {mass,
                mass * velocity + pressure,
                mass * tangent_1,
                mass * tangent_2,
                mass * energy + pressure * velocity,
                mass * internal,
                velocity,
                s.signal};
    }
};

/// HLLC for wide cells in slow flow: the jump of the normal velocity, whose dissipation would be c |du|, is scaled with
/// the Mach number before the Riemann problem is posed (Thornber and others 2008, eq. 19), which leaves u |du|. Sound
/// of a wavelength of many cells is then no longer damped by the scheme where c >> u. Equal to HLLC at M >= 1.
struct FluxHllcSlow {
    [[gnu::always_inline]] static FaceFlux at(const FaceState& left, const FaceState& right, double packing_density) {
        const double fastest = larger(left.normal * left.normal, right.normal * right.normal);
        const double sound = larger(left.sound_speed, right.sound_speed);
        const double mach = smaller(1.0, std::sqrt(fastest) / sound);
        const double mean = 0.5 * (left.normal + right.normal), half = (0.5 * mach) * (left.normal - right.normal);
        FaceState slow_left = left, slow_right = right;
        slow_left.normal = mean + half;
        slow_right.normal = mean - half;
        return FluxHllc::at(slow_left, slow_right, packing_density);
    }
};

}  // namespace shaken::continuum
