// SPDX-License-Identifier: MIT
#include "continuum/step/relax.hpp"

#include <algorithm>

namespace shaken::continuum {

Relax::Relax(Fluid& fluid)
    : fluid_(fluid),
      coefficients_(fluid.grid()),
      column_(fluid, coefficients_),
      horizontal_(fluid, coefficients_),
      ones_(rows_of_threads<Row>(fluid)) {
    for (Row& ones : ones_) std::fill(static_cast<double*>(ones), ones + fluid.grid().nz, 1.0);
}

void Relax::operator()(double dt) {
    const EffectiveDissipation& dissipation = fluid_.dissipation;
    const bool cools = !(dissipation.is_constant() && dissipation.constant() == 0.0);
    if (!cools && !fluid_.kernels.viscous) return;
    take_coefficients();
    const bool horizontal = fluid_.kernels.viscous && fluid_.grid().columns() > 1;
    const int pieces = horizontal ? horizontal_.pieces(0.5 * dt) : 1;
    const double piece = dt / pieces;
    for (int i = 0; i < pieces; ++i) {
        if (horizontal) horizontal_(0.5 * piece);
        relax_columns(piece, cools);
        if (horizontal) horizontal_(0.5 * piece);
    }
    pieces_ += pieces;
}

std::size_t Relax::doubles() const { return 5 * coefficients_.bulk.size() + horizontal_.doubles(); }

void Relax::take_coefficients() {
    const Grid& grid = fluid_.grid();
#pragma omp parallel for schedule(static) num_threads(fluid_.threads())
    for (std::int64_t column = 0; column < grid.columns(); ++column) {
        const std::int64_t first = grid.first(column);
        fluid_.kernels.transport(fluid_.flow().density.data() + first, ones_[thread()], coefficients_.from(first),
                                 grid.nz, fluid_.constants);
    }
}

void Relax::relax_columns(double dt, bool cools) {
#pragma omp parallel for schedule(static) num_threads(fluid_.threads())
    for (std::int64_t column = 0; column < fluid_.grid().columns(); ++column) {
        if (fluid_.kernels.viscous)
            column_.cool_and_diffuse(column, dt, cools);
        else
            column_.cool(column, dt);
    }
}

}  // namespace shaken::continuum
