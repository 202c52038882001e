// SPDX-License-Identifier: MIT
// Cell fields of a structured grid in HDF5, one dataset a field and frame, with an XDMF text beside it that ParaView's
// "XDMF Reader" opens. Layout in docs/formats.md.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "files/hdf5.hpp"

namespace shaken::fields {

/// Cells of a box: counts and spacings in the order x, y, z. Field arrays are (nz, ny, nx), x fastest.
struct Grid {
    std::array<std::int64_t, 3> cells{1, 1, 1};
    std::array<double, 3> spacing{1.0, 1.0, 1.0};
    std::int64_t size() const { return cells[0] * cells[1] * cells[2]; }
};

/// Appends frames to an open HDF5 file under /frames/00000/..., and writes the XDMF text.
class FieldFile {
  public:
    FieldFile(files::Hdf5File& file, const std::filesystem::path& path, Grid grid);

    /// One instant: time since the start, cycle and phase ft, height of the grid's lower edge (the plate) in the lab,
    /// and named fields of grid.size() values.
    void add_frame(double time, std::int64_t cycle, double phase, double lower_edge,
                   const std::vector<std::pair<std::string, std::span<const double>>>& fields);

    /// Writes NAME.xdmf beside NAME.h5. Throws CannotCreate or WriteFailed.
    void write_xdmf() const;

  private:
    struct Frame {
        double time, lower_edge;
        std::vector<std::string> fields;
    };
    files::Hdf5File& file_;
    std::filesystem::path path_;
    Grid grid_;
    std::vector<Frame> frames_;
};

}  // namespace shaken::fields
