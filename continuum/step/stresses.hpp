// SPDX-License-Identifier: MIT
// Viscous stresses, conduction and the heat of the density gradient through the face between two columns.
#pragma once

#include <cstdint>

namespace shaken::continuum {

/// What the stresses at a face carry: momentum along the face's normal, along it horizontally, along z, and energy.
struct Carried {
    double *normal, *lateral, *vertical, *energy;
};

/// The fields of one column, element 0 the lowest cell.
struct ColumnFields {
    const double *density, *normal, *lateral, *vertical, *temperature, *thermal_speed;
    const double *bulk, *shear, *conductivity, *density_conductivity;  // at T = 1
};

/// Face between columns `left` and `right` of a row; the lateral neighbours of either give the derivative along it.
struct Neighbourhood {
    ColumnFields left, right;
    ColumnFields left_before, left_after, right_before, right_after;
    double width, lateral_width;
    double share;  // of a face
};

/// Into `out`, cell by cell of the face's nz; coefficients capped as relax_horizontal.hpp says.
void stresses_between(const Neighbourhood& at, double dz, double dt, std::int64_t nz, const Carried& out);

}  // namespace shaken::continuum
