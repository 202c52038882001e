// SPDX-License-Identifier: MIT
// Maps of z_cm(x, y): the height of the centre of mass over each bin of a horizontal grid, at some phases of every
// cycle. One rule for both engines: particles and continuum cells deposit mass where they are; a cell that lies across
// the edge of a bin is parted by area.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "files/checkpoint.hpp"
#include "files/hdf5.hpp"

namespace shaken::fields {

/// Equal bins over a periodic rectangle [0, length_x) x [0, length_y), in sigma.
struct HorizontalGrid {
    std::int64_t nx = 0, ny = 0;
    double length_x = 1.0, length_y = 1.0;

    double dx() const { return length_x / static_cast<double>(nx); }
    double dy() const { return length_y / static_cast<double>(ny); }
    std::size_t size() const { return static_cast<std::size_t>(nx * ny); }
    bool operator==(const HorizontalGrid&) const = default;
};

class HeightMaps {
  public:
    explicit HeightMaps(HorizontalGrid grid = {});

    const HorizontalGrid& grid() const { return grid_; }
    std::size_t rows() const { return cycles_.size(); }
    std::int64_t cycle(std::size_t row) const { return cycles_[row]; }
    /// ft in [0, 1).
    double phase(std::size_t row) const { return phases_[row]; }
    /// Heights in sigma, shape (ny, nx), x fastest; a bin without mass has the mean of the others.
    std::vector<double> row(std::size_t row) const;
    /// Rows at this phase (ft) of cycles from `first` on, in order.
    std::vector<std::size_t> rows_at(double phase, std::int64_t first) const;

    /// Opens a new map; what is added until end() belongs to it.
    void begin(std::int64_t cycle, double phase);
    /// A point mass; positions outside the rectangle are taken back into it.
    void add_point(double x, double y, double mass, double height);
    /// A rectangle from (x, y), of these sides, no larger than the grid: its mass and the height of its own centre.
    void add_rectangle(double x, double y, double side_x, double side_y, double mass, double height);
    void end();
    /// Forgets all maps, for whoever has taken them elsewhere.
    void clear();

    void save(files::CheckpointWriter& out, const std::string& prefix) const;
    void restore(const files::CheckpointReader& in, const std::string& prefix);
    /// GROUP/height (rows, ny, nx), GROUP/cycle, GROUP/phase, attributes length_x, length_y.
    void write(files::Hdf5File& file, const std::string& group) const;
    static HeightMaps read(const files::Hdf5File& file, const std::string& group);

  private:
    HorizontalGrid grid_;
    std::vector<std::int64_t> cycles_;
    std::vector<double> phases_;
    std::vector<double> heights_;        // (rows, ny, nx)
    std::vector<double> mass_, moment_;  // of the open map
};

}  // namespace shaken::fields
