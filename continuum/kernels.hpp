// SPDX-License-Identifier: MIT
// The loops over the cells of one column, as functions that a solver picks once by the names in its scene. Inside
// them the closure, the flux and the reconstruction are template arguments: no call, branch or allocation a cell.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/reconstruct/stencil.hpp"
#include "continuum/time_integrator.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// Constants of a run that the kernels need.
struct Constants {
    double restitution = 1.0;      // of pressure and transport
    double virial = 4.0;           // 2 (1 + e)
    double packing_density = 1.0;  // n at which the pressure diverges
    double floor_temperature = 0.0;
    double trust = 0.0;  // the total energy gives the temperature where it leaves more than trust * n * (jump of u)^2
};

/// Arrays of one sweep, an element a face.
struct FaceArrays {
    double *mass, *normal, *tangent_1, *tangent_2, *energy, *internal, *velocity;
    double* jump;  // squared difference of velocity across the face

    FaceArrays shifted(std::int64_t by) const {
        return {mass + by,   normal + by,   tangent_1 + by, tangent_2 + by,
                energy + by, internal + by, velocity + by,  jump + by};
    }
};

/// Fluxes through `count` faces; returns the fastest wave met.
using SweepKernel = double (*)(const Stencil&, const FaceArrays&, std::int64_t count, const Constants&);

/// Stress on a reflecting wall at rest, from the three cells beside it and their mirror images: the stencil is that of
/// the face in the wall, with the gas above it (element 0).
using WallKernel = double (*)(const Stencil&, const Constants&);

/// Pressure and sound speed of `count` cells.
using PressureKernel = void (*)(const double* density, const double* temperature, double* pressure, double* sound_speed,
                                std::int64_t count, const Constants&);

/// Viscosities, conductivity and cooling rate (dT/dt = -rate D T^(3/2)) of `count` cells.
struct TransportArrays {
    double *bulk, *shear, *conductivity, *density_conductivity, *cooling;
};
using TransportKernel = void (*)(const double* density, const double* temperature, const TransportArrays&,
                                 std::int64_t count, const Constants&);

struct Kernels {
    SweepKernel sweep = nullptr;              // along z
    SweepKernel sweep_horizontal = nullptr;   // along x and y, where cells are wide and flow is slow
    SweepKernel sweep_thin = nullptr;         // along x and y, in the rows above the layer that hold next to nothing
    SweepKernel sweep_first_order = nullptr;  // what a step that failed is repeated with
    WallKernel wall = nullptr;
    PressureKernel pressure = nullptr;
    TransportKernel transport = nullptr;
    std::span<const Stage> stages;
    double packing = 0.65;
    bool viscous = true;
    bool density_drives_heat = false;  // whether the closure has a heat flux along the density gradient
};

/// The kernels that [continuum] names; throws scene::SceneError for a name no table has.
Kernels choose_kernels(const scene::Continuum& choices);

}  // namespace shaken::continuum
