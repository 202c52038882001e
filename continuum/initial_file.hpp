// SPDX-License-Identifier: MIT
// A start from what an earlier run left: continuum.h5 (whole fields) or md.h5 (profiles in bins), onto any grid.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "continuum/grid.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// A state on a grid of its own; arrays (nz, ny, nx), the plate's frame.
struct StoredFlow {
    std::array<std::int64_t, 3> cells{1, 1, 1};
    std::array<double, 3> spacing{1.0, 1.0, 1.0};
    double lower = 0.0;  // edge of the lowest cell above the plate
    std::vector<double> density, velocity_x, velocity_y, velocity_z, temperature;
};

/// Reads the frame (continuum.h5) or the mean profile (md.h5, or a continuum.h5 without frames) at the phase nearest to
/// `phase`. Empty bins of a profile take velocity and temperature of the nearest bin below that holds anything.
/// Throws files::NoInput or files::Damaged; scene::SceneError where nothing was kept within 0.01 of the phase.
StoredFlow read_flow(const std::filesystem::path& path, double phase);

/// Linear interpolation at the centre of a cell of another grid; periodic along x and y, where the stored state is
/// taken as one whole width; no density above or below the stored heights.
struct Interpolated {
    double density, velocity_x, velocity_y, velocity_z, temperature;
};
Interpolated interpolate(const StoredFlow& stored, const Grid& grid, std::int64_t ix, std::int64_t iy, std::int64_t iz);

}  // namespace shaken::continuum
