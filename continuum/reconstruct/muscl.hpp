// SPDX-License-Identifier: MIT
// MUSCL: a straight line in each cell, its slope limited. van Leer 1979. Second order where smooth; between the values
// of the neighbours, so positive and below packing wherever they are.
//     | q[1] | q[2] | q[3] | q[4] |
//                 left^right           values at the face between q[2] and q[3]
#pragma once

#include <cstddef>

namespace continuum {

template <class Limiter>
struct Muscl {
    static constexpr std::size_t first_cell = 1, last_cell = 4;  // of the six around a face

    template <class Cells>
    [[gnu::always_inline]] static double left(const Cells& q) {
        return q[2] + 0.5 * Limiter::slope(q[2] - q[1], q[3] - q[2]);
    }
    template <class Cells>
    [[gnu::always_inline]] static double right(const Cells& q) {
        return q[3] - 0.5 * Limiter::slope(q[3] - q[2], q[4] - q[3]);
    }
};

}  // namespace continuum
