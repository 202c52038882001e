// SPDX-License-Identifier: MIT
// Sweeps along x and y. A face lies between two whole columns, so the loop of the kernel runs along z as ever; rows of
// columns are walked with the fluxes of one side kept for the next column. Rows are cut into pieces for the threads:
// where a piece begins its first face is computed twice, by the same kernel from the same cells, hence to the same
// bits.
#include <omp.h>

#include <algorithm>

#include "continuum/step/carry.hpp"

namespace shaken::continuum {

namespace {

/// Pieces of each row such that all threads have work, none shorter than 4 columns.
std::int64_t pieces_of_row(std::int64_t rows, std::int64_t length) {
    const std::int64_t wanted = (4 * omp_get_num_threads() + rows - 1) / rows;
    return std::clamp<std::int64_t>(wanted, 1, std::max<std::int64_t>(1, length / 4));
}

// A mean free path of 20,000 sigma: what waves do to gas as thin as this nobody asks. Above the layer of the source's
// section 3.2.8 that is two thirds of the rows.
constexpr double thinnest_of_high_order = 1e-5;

}  // namespace

std::int64_t Carry::rows_with_gas() const {
    const Grid& grid = fluid_.grid();
    const std::int64_t columns = grid.columns();
    std::int64_t rows = 0;
#pragma omp parallel for schedule(static) num_threads(fluid_.threads()) reduction(max : rows)
    for (std::int64_t column = 0; column < columns; ++column) {
        const double* density = fluid_.flow().density.data() + grid.first(column);
        std::int64_t here = grid.nz;
        while (here > rows && !(density[here - 1] > thinnest_of_high_order)) --here;
        rows = std::max(rows, here);
    }
    return rows;
}

void Carry::sweep_row(Direction direction, std::int64_t row, std::int64_t from, std::int64_t to, const Sweeps& sweeps,
                      std::int64_t rows, bool first_sweep) {
    const Grid& grid = fluid_.grid();
    const Flow& flow = fluid_.flow();
    const bool along_x = direction == Direction::x;
    const std::int64_t length = along_x ? grid.nx : grid.ny;
    const double spacing = along_x ? grid.dx : grid.dy;
    const auto column = [&](std::int64_t i) {
        const std::int64_t wrapped = (i % length + length) % length;
        return along_x ? grid.column(wrapped, row) : grid.column(row, wrapped);
    };
    const std::vector<double>& normal = along_x ? flow.velocity_x : flow.velocity_y;
    const std::vector<double>& tangent = along_x ? flow.velocity_y : flow.velocity_x;
    const auto fluxes_below = [&](std::int64_t i, const FaceArrays& faces) {
        Stencil stencil;
        for (std::size_t k = 0; k < 6; ++k) {
            const std::int64_t cell = grid.first(column(i - 3 + static_cast<std::int64_t>(k)));
            stencil.density[k] = flow.density.data() + cell;
            stencil.normal[k] = normal.data() + cell;
            stencil.tangent_1[k] = tangent.data() + cell;
            stencil.tangent_2[k] = flow.velocity_z.data() + cell;
            stencil.temperature[k] = flow.temperature.data() + cell;
        }
        sweeps.horizontal(stencil, faces, rows, fluid_.constants);
        sweeps.thin(stencil.shifted(rows), faces.shifted(rows), grid.nz - rows, fluid_.constants);
    };
    FaceArrays below = scratch_[thread()].faces.arrays(), above = scratch_[thread()].faces_above.arrays();
    fluxes_below(from, below);
    for (std::int64_t i = from; i < to; ++i) {
        fluxes_below(i + 1, above);
        add_rates(column(i), below, above, direction, spacing, first_sweep);
        std::swap(below, above);
    }
}

void Carry::sweep_along_x(const Sweeps& sweeps, std::int64_t rows) {
    const Grid& grid = fluid_.grid();
    const std::int64_t pieces = pieces_of_row(grid.ny, grid.nx);
#pragma omp for schedule(static)
    for (std::int64_t task = 0; task < grid.ny * pieces; ++task) {
        const std::int64_t row = task / pieces, piece = task % pieces;
        sweep_row(Direction::x, row, piece * grid.nx / pieces, (piece + 1) * grid.nx / pieces, sweeps, rows, true);
    }
}

void Carry::sweep_along_y(const Sweeps& sweeps, std::int64_t rows, bool first_sweep) {
    const Grid& grid = fluid_.grid();
    const std::int64_t pieces = pieces_of_row(grid.nx, grid.ny);
#pragma omp for schedule(static)
    for (std::int64_t task = 0; task < grid.nx * pieces; ++task) {
        const std::int64_t row = task / pieces, piece = task % pieces;
        sweep_row(Direction::y, row, piece * grid.ny / pieces, (piece + 1) * grid.ny / pieces, sweeps, rows,
                  first_sweep);
    }
}

}  // namespace shaken::continuum
