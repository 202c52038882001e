// SPDX-License-Identifier: MIT
// Cells of one, two or three dimensions. Columns are contiguous in z, with ghost cells below and above; x and y wrap
// around (periodic), so they need none. One cell in x or y means that nothing varies there.
//   index of cell (ix, iy, iz) = (iy * nx + ix) * stride + ghosts + iz          arrays are (ny, nx, stride)
#pragma once

#include <cstddef>
#include <cstdint>

namespace shaken::continuum {

struct Grid {
    static constexpr std::int64_t ghosts = 3;

    std::int64_t nx = 1, ny = 1, nz = 1;
    double dx = 1.0, dy = 1.0, dz = 1.0;  // sigma

    std::int64_t columns() const { return nx * ny; }
    std::int64_t cells() const { return nx * ny * nz; }
    /// Doubles from one column to the next, a multiple of 8 (one cache line).
    std::int64_t stride() const { return (nz + 2 * ghosts + 7) / 8 * 8; }
    std::size_t size() const { return static_cast<std::size_t>(columns() * stride()); }
    /// Index of the lowest cell inside a column.
    std::int64_t first(std::int64_t column) const { return column * stride() + ghosts; }
    std::int64_t column(std::int64_t ix, std::int64_t iy) const { return iy * nx + ix; }
    double centre(std::int64_t iz) const { return (static_cast<double>(iz) + 0.5) * dz; }
};

}  // namespace shaken::continuum
