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

    Stencil shifted(std::int64_t by) const {
        Stencil result = *this;
        for (Cells* field :
             {&result.density, &result.normal, &result.tangent_1, &result.tangent_2, &result.temperature})
            for (const double*& cell : *field) cell += by;
        return result;
    }
};

/// Values of the six cells around face f.
struct CellsAround {
    const Stencil::Cells& row;
    std::int64_t face;
    [[gnu::always_inline]] double operator[](std::size_t k) const { return row[k][face]; }
};

}  // namespace shaken::continuum
