// SPDX-License-Identifier: MIT
// What the operators of a step work on together: the state with its books, and the formulas that its scene chose.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/kernels.hpp"
#include "continuum/setup.hpp"
#include "continuum/step/ledger.hpp"

namespace shaken::continuum {

/// One a column, so that sums do not depend on threads.
using Books = std::vector<Ledger>;

struct Fluid {
    /// Throws scene::SceneError for unknown names.
    explicit Fluid(Setup setup);

    Setup setup;  // its flow is the state
    Kernels kernels;
    Constants constants;
    EffectiveDissipation dissipation;
    Books books;
    bool moves_along_x = false, moves_along_y = false;  // whether u_x, u_y can differ from 0
    // Rates of change, by the fluxes or by the stresses across columns, and the largest squared jump of velocity around
    // each cell; (ny, nx, stride) each.
    struct Rates {
        std::vector<double> mass, momentum_x, momentum_y, momentum_z, energy, internal, jump, pressure;
    } rates;

    const Grid& grid() const { return setup.grid; }
    Flow& flow() { return setup.flow; }
    const Flow& flow() const { return setup.flow; }
    Ledger& books_of(std::int64_t column) { return books[static_cast<std::size_t>(column)]; }

    /// How many threads share the columns; one without a column would only wait.
    int threads() const;
};

/// The number of the thread that asks, for its own scratch.
std::size_t thread();

/// The cells of one column, without its ghosts.
void copy_column(const Grid& grid, const Flow& from, Flow& to, std::int64_t column);

}  // namespace shaken::continuum
