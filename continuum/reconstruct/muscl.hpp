// SPDX-License-Identifier: MIT
// MUSCL: a straight line in each cell, its slope limited. van Leer 1979. Second order where smooth; between the values
// of the neighbours, so positive and below packing wherever they are.
//     | q[1] | q[2] | q[3] | q[4] |
//                 left^right           values at the face between q[2] and q[3]
#pragma once

#include <cstdint>

#include "continuum/flux/face_state.hpp"
#include "continuum/reconstruct/stencil.hpp"

namespace shaken::continuum {

template <class Limiter>
struct Muscl {
    template <class Cells>
    [[gnu::always_inline]] static double left(const Cells& q) {
        return q[2] + 0.5 * Limiter::slope(q[2] - q[1], q[3] - q[2]);
    }
    template <class Cells>
    [[gnu::always_inline]] static double right(const Cells& q) {
        return q[3] - 0.5 * Limiter::slope(q[3] - q[2], q[4] - q[3]);
    }

    /// The gas just below and just above face f.
    [[gnu::always_inline]] static FaceValues below(const Stencil& s, std::int64_t f, double /*packing_density*/) {
        return {left(CellsAround{s.density, f}), left(CellsAround{s.normal, f}), left(CellsAround{s.tangent_1, f}),
                left(CellsAround{s.tangent_2, f}), left(CellsAround{s.temperature, f})};
    }
    [[gnu::always_inline]] static FaceValues above(const Stencil& s, std::int64_t f, double /*packing_density*/) {
        return {right(CellsAround{s.density, f}), right(CellsAround{s.normal, f}), right(CellsAround{s.tangent_1, f}),
                right(CellsAround{s.tangent_2, f}), right(CellsAround{s.temperature, f})};
    }
};

}  // namespace shaken::continuum
