// SPDX-License-Identifier: MIT
// The cells around the faces of a sweep.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace shaken::continuum {

/// Pointers to one value each of the six cells around face 0 of a sweep, cells 2 and 3 touching it; face f uses the
/// elements [f]. Along z the six pointers are one column shifted; along x and y they are six columns.
struct Stencil {
    using Cells = std::array<const double*, 6>;
    Cells density, normal, tangent_1, tangent_2, temperature;
};

/// Values of the six cells around face f.
struct CellsAround {
    const Stencil::Cells& row;
    std::int64_t face;
    [[gnu::always_inline]] double operator[](std::size_t k) const { return row[k][face]; }
};

}  // namespace shaken::continuum
