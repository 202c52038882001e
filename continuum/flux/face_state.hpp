// SPDX-License-Identifier: MIT
// What meets at a face, and what passes through it. "Normal" is along the sweep, 1 and 2 are the other two directions.
#pragma once

namespace shaken::continuum {

/// What a reconstruction gives at one side of a face.
struct FaceValues {
    double density, normal, tangent_1, tangent_2, temperature;
};

struct FaceState {
    double density, normal, tangent_1, tangent_2, temperature;
    double pressure, sound_speed;
};

struct FaceFlux {
    double mass, normal, tangent_1, tangent_2, energy;
    double internal;  // internal energy carried by the mass, for the equation de/dt + div(e u) = -p div u
    double velocity;  // of the gas at the face, for its div u
    double signal;    // fastest wave, for the step
};

}  // namespace shaken::continuum
