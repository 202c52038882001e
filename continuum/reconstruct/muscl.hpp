// SPDX-License-Identifier: MIT
// MUSCL: a straight line in each cell, its slope limited. van Leer 1979. Second order where smooth; between the values
// of the neighbours, so positive and below packing wherever they are.
//     | q[1] | q[2] | q[3] | q[4] |
//                 left^right           values at the face between q[2] and q[3]
#pragma once

#include <cstdint>

#include "continuum/flux/face_state.hpp"
#include "continuum/flux/wave_speeds.hpp"
#include "continuum/reconstruct/shock.hpp"
#include "continuum/reconstruct/stencil.hpp"

namespace shaken::continuum {

/// With `flattens`, slopes are less steep in strong shocks.
template <class Limiter, bool flattens = true>
struct Muscl {
    using AcrossColumns = Muscl<Limiter, false>;  // whose cells are too wide to hold a shock (shock.hpp)

    template <class Cells>
    [[gnu::always_inline]] static double left(const Cells& q, double half = 0.5) {
        return q[2] + half * Limiter::slope(q[2] - q[1], q[3] - q[2]);
    }
    template <class Cells>
    [[gnu::always_inline]] static double right(const Cells& q, double half = 0.5) {
        return q[3] - half * Limiter::slope(q[3] - q[2], q[4] - q[3]);
    }

    /// The gas just below and just above face f.
    [[gnu::always_inline]] static FaceValues below(const Stencil& s, std::int64_t f, double /*packing_density*/) {
        const double half = half_cell(s, f);
        return {positive(left(CellsAround{s.density, f}, half), s.density[2][f]), left(CellsAround{s.normal, f}, half),
                left(CellsAround{s.tangent_1, f}, half), left(CellsAround{s.tangent_2, f}, half),
                positive(left(CellsAround{s.temperature, f}, half), s.temperature[2][f])};
    }
    [[gnu::always_inline]] static FaceValues above(const Stencil& s, std::int64_t f, double /*packing_density*/) {
        const double half = half_cell(s, f);
        return {positive(right(CellsAround{s.density, f}, half), s.density[3][f]),
                right(CellsAround{s.normal, f}, half), right(CellsAround{s.tangent_1, f}, half),
                right(CellsAround{s.tangent_2, f}, half),
                positive(right(CellsAround{s.temperature, f}, half), s.temperature[3][f])};
    }

  private:
    /// Beside gas denser by 1e16 and more the steepest slope leaves nothing at the face, by rounding; a face without
    /// gas has no velocity. What is left is the rounding error of the cell's own value.
    [[gnu::always_inline]] static double positive(double at_face, double in_cell) {
        return larger(at_face, 1e-16 * in_cell);
    }
    /// From a cell's middle to its face, less what a shock takes of the slope.
    [[gnu::always_inline]] static double half_cell(const Stencil& s, std::int64_t f) {
        if constexpr (flattens && Limiter::in_shock < 1.0) return in_strong_shock(s, f) ? 0.5 * Limiter::in_shock : 0.5;
        return 0.5;
    }
};

}  // namespace shaken::continuum
