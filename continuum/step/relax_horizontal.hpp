// SPDX-License-Identifier: MIT
// Viscosity and conduction across columns, and the stresses that mix directions; explicit, conservative, second order.
//     tau_ij = (lambda - 2 mu/3) div u delta_ij + mu (d_i u_j + d_j u_i)
// At a face normal to x all of tau_xj is taken here; at a face normal to z only what diffuse() leaves: the derivatives
// along x and y. Derivatives along a face are means over the cells on both sides.
// Explicit diffusion carries at most n dx^2/(4 dt) (two horizontal dimensions, /2 with one) through a face. Relaxation
// is cut into as many equal pieces as that asks for wherever the mean free path is below longest_free_path; in thinner
// gas, where these equations say nothing, the coefficients are capped instead. The mixed terms need no tighter bound
// there as long as each piece also has its implicit diffusion along z: with a = D dt/dx^2 and b = D dt/dz^2 a piece
// changes a disturbance by (1 - a + 2 sqrt(a b))/(1 + b) at most, and that is below one. Where coefficients are capped
// b is no longer that of the same D, and the mixed ones are held below n dx dz/(4 dt): without it thin gas above a
// falling crest was thrown about and took heat from nowhere. Heat along the density gradient is capped with conduction,
// by the same factor.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/step/coefficients.hpp"
#include "continuum/step/fluid.hpp"
#include "continuum/step/row.hpp"
#include "continuum/step/stresses.hpp"

namespace shaken::continuum {

class RelaxHorizontal {
  public:
    /// Fluid and coefficients must outlive it.
    RelaxHorizontal(Fluid& fluid, Coefficients& coefficients);

    void operator()(double dt);

    /// How many equal pieces of dt it is stable in.
    int pieces(double dt) const;
    /// Doubles that it keeps beside the fluid's, without scratch.
    std::size_t doubles() const { return thermal_speed_.size(); }

  private:
    struct CarriedRows {
        explicit CarriedRows(std::int64_t cells) : normal(cells), lateral(cells), vertical(cells), energy(cells) {}
        Row normal, lateral, vertical, energy;
        Carried arrays() { return {normal, lateral, vertical, energy}; }
    };
    struct Scratch {
        explicit Scratch(std::int64_t cells)
            : west(cells),
              east(cells),
              south(cells),
              north(cells),
              face(cells),
              divergence(cells),
              slope_x(cells),
              slope_y(cells),
              corrected(cells),
              floored(cells) {}
        CarriedRows west, east, south, north;  // through the sides of a column
        CarriedRows face;                      // below each cell, from derivatives along x and y
        Row divergence, slope_x, slope_y;      // d_x u_x + d_y u_y, d_x u_z, d_y u_z of the cells
        Row corrected, floored;                // energy
    };

    double share_of_face() const;
    double narrowest_square() const;
    ColumnFields fields(std::int64_t x, std::int64_t y, bool along_x) const;
    void stresses_of_sides(std::int64_t column, double dt);
    void stresses_of_faces(std::int64_t column, double dt);
    void sum_stresses(std::int64_t column);
    void apply(std::int64_t column, double dt);

    Fluid& fluid_;
    Coefficients& coefficients_;
    std::vector<double> thermal_speed_;  // sqrt(T); (ny, nx, stride), empty where there is one column
    std::vector<Scratch> scratch_;
};

}  // namespace shaken::continuum
