// SPDX-License-Identifier: MIT
// Scratch of a thread: each operator of a step has its own rows, named after what they hold, one set a thread.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/kernels.hpp"
#include "continuum/step/fluid.hpp"

namespace shaken::continuum {

/// Doubles for the cells of a column, its ghosts and its faces; stands for the pointer to the first.
class Row {
  public:
    explicit Row(std::int64_t cells) : values_(static_cast<std::size_t>(cells + 2 * Grid::ghosts + 8) / 8 * 8, 0.0) {}
    operator double*() { return values_.data(); }

  private:
    std::vector<double> values_;
};

/// The fluxes through a row of faces.
struct FaceRows {
    explicit FaceRows(std::int64_t cells)
        : mass(cells),
          normal(cells),
          tangent_1(cells),
          tangent_2(cells),
          energy(cells),
          internal(cells),
          velocity(cells),
          jump(cells) {}
    Row mass, normal, tangent_1, tangent_2, energy, internal, velocity, jump;

    FaceArrays arrays() { return {mass, normal, tangent_1, tangent_2, energy, internal, velocity, jump}; }
};

/// A set of rows for every thread that works on this fluid.
template <class Rows>
std::vector<Rows> rows_of_threads(const Fluid& fluid) {
    return std::vector<Rows>(static_cast<std::size_t>(fluid.threads()), Rows(fluid.grid().nz));
}

}  // namespace shaken::continuum
