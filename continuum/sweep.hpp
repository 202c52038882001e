// SPDX-License-Identifier: MIT
// Fluxes through a row of faces: reconstruct density, velocity and temperature on both sides, close them with the
// pressure there, solve the Riemann problem. The same loop for x, y and z.
#pragma once

#include <cmath>

#include "continuum/closures/pressure.hpp"
#include "continuum/flux/face_state.hpp"
#include "continuum/kernels.hpp"

namespace shaken::continuum {

/// A gas with the pressure and the sound speed that go with it.
template <class PairCorrelation>
[[gnu::always_inline]] inline FaceState face_state(const FaceValues& v, double virial) {
    const PressurePoint point = pressure_point<PairCorrelation>(v.density, v.temperature, virial);
    return {v.density,
            v.normal,
            v.tangent_1,
            v.tangent_2,
            v.temperature,
            point.pressure,
            std::sqrt(point.sound_speed_squared)};
}

template <class PairCorrelation, class Flux, class Reconstruct>
double sweep(const Stencil& stencil, const FaceArrays& out, std::int64_t count, const Constants& constants) {
    const Stencil s = stencil;
    double* __restrict mass = out.mass, * __restrict normal = out.normal, * __restrict tangent_1 = out.tangent_1, * __restrict tangent_2 = out.tangent_2, * __restrict energy = out.energy, * __restrict internal = out.internal, * __restrict velocity = out.velocity, * __restrict jump = out.jump;
    const double virial = constants.virial, packing = constants.packing_density;
    double signal = 0.0;
#pragma omp simd reduction(max : signal)
    for (std::int64_t f = 0; f < count; ++f) {
        const FaceState left = face_state<PairCorrelation>(Reconstruct::below(s, f, packing), virial);
        const FaceState right = face_state<PairCorrelation>(Reconstruct::above(s, f, packing), virial);
        const FaceFlux flux = Flux::at(left, right, packing);
        mass[f] = flux.mass;
        normal[f] = flux.normal;
        tangent_1[f] = flux.tangent_1;
        tangent_2[f] = flux.tangent_2;
        energy[f] = flux.energy;
        internal[f] = flux.internal;
        velocity[f] = flux.velocity;
        const double d_normal = s.normal[3][f] - s.normal[2][f];
        const double d_1 = s.tangent_1[3][f] - s.tangent_1[2][f], d_2 = s.tangent_2[3][f] - s.tangent_2[2][f];
        jump[f] = d_normal * d_normal + (d_1 * d_1 + d_2 * d_2);
        signal = signal > flux.signal ? signal : flux.signal;
    }
    return signal;
}

/// p* of a gas that meets its own mirror image: p + n (s - u)(0 - u), s the wave that runs back into it.
template <class PairCorrelation, class Reconstruct>
double wall_stress(const Stencil& stencil, const Constants& constants) {
    const FaceState gas =
        face_state<PairCorrelation>(Reconstruct::above(stencil, 0, constants.packing_density), constants.virial);
    FaceState image = gas;
    image.normal = -gas.normal;
    const WaveSpeeds s = wave_speeds(image, gas, constants.packing_density);
    const double stress = gas.pressure - gas.density * (s.fastest - gas.normal) * gas.normal;
    return stress > 0.0 ? stress : 0.0;
}

}  // namespace shaken::continuum
