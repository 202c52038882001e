// SPDX-License-Identifier: MIT
#include "fields/height_maps.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "files/errors.hpp"

namespace shaken::fields {

namespace {

/// Bin of a coordinate on a periodic axis.
std::int64_t periodic_bin(double x, double length, std::int64_t bins) {
    const auto bin = static_cast<std::int64_t>(std::floor(x / length * static_cast<double>(bins))) % bins;
    return bin < 0 ? bin + bins : bin;
}

/// What part of [from, from + side) lies in each bin, as visit(bin, part); the parts sum to 1.
template <class Visit>
void for_each_part(double from, double side, double length, std::int64_t bins, Visit visit) {
    const double width = length / static_cast<double>(bins);
    const auto first = static_cast<std::int64_t>(std::floor(from / width + 1e-9));
    for (std::int64_t bin = first;; ++bin) {
        const double lower = std::max(from, width * static_cast<double>(bin));
        const double upper = std::min(from + side, width * static_cast<double>(bin + 1));
        if (upper - lower > 1e-9 * side) visit(((bin % bins) + bins) % bins, (upper - lower) / side);
        if (from + side <= width * static_cast<double>(bin + 1) * (1.0 + 1e-12)) break;
    }
}

}  // namespace

HeightMaps::HeightMaps(HorizontalGrid grid) : grid_(grid) {}

std::vector<double> HeightMaps::row(std::size_t row) const {
    const auto from = heights_.begin() + static_cast<std::ptrdiff_t>(row * grid_.size());
    return {from, from + static_cast<std::ptrdiff_t>(grid_.size())};
}

std::vector<std::size_t> HeightMaps::rows_at(double phase, std::int64_t first) const {
    std::vector<std::size_t> found;
    for (std::size_t r = 0; r < rows(); ++r)
        if (cycles_[r] >= first && std::abs(phases_[r] - phase) < 1e-9) found.push_back(r);
    return found;
}

void HeightMaps::begin(std::int64_t cycle, double phase) {
    cycles_.push_back(cycle);
    phases_.push_back(phase);
    mass_.assign(grid_.size(), 0.0);
    moment_.assign(grid_.size(), 0.0);
}

void HeightMaps::add_point(double x, double y, double mass, double height) {
    const std::int64_t ix = periodic_bin(x, grid_.length_x, grid_.nx), iy = periodic_bin(y, grid_.length_y, grid_.ny);
    const auto bin = static_cast<std::size_t>(iy * grid_.nx + ix);
    mass_[bin] += mass;
    moment_[bin] += mass * height;
}

void HeightMaps::add_rectangle(double x, double y, double side_x, double side_y, double mass, double height) {
    for_each_part(y, side_y, grid_.length_y, grid_.ny, [&](std::int64_t iy, double part_y) {
        for_each_part(x, side_x, grid_.length_x, grid_.nx, [&](std::int64_t ix, double part_x) {
            const auto bin = static_cast<std::size_t>(iy * grid_.nx + ix);
            mass_[bin] += mass * part_x * part_y;
            moment_[bin] += mass * part_x * part_y * height;
        });
    });
}

void HeightMaps::end() {
    double sum = 0.0, filled = 0.0;
    for (std::size_t bin = 0; bin < mass_.size(); ++bin) {
        if (mass_[bin] > 0.0) {
            sum += moment_[bin] / mass_[bin];
            filled += 1.0;
        }
    }
    for (std::size_t bin = 0; bin < mass_.size(); ++bin)
        heights_.push_back(mass_[bin] > 0.0 ? moment_[bin] / mass_[bin] : sum / std::max(1.0, filled));
}

void HeightMaps::clear() {
    cycles_.clear();
    phases_.clear();
    heights_.clear();
}

void HeightMaps::save(files::CheckpointWriter& out, const std::string& prefix) const {
    out.put(prefix + "cycle", cycles_);
    out.put(prefix + "phase", phases_);
    out.put(prefix + "height", heights_);
}

void HeightMaps::restore(const files::CheckpointReader& in, const std::string& prefix) {
    cycles_ = in.take<std::int64_t>(prefix + "cycle");
    phases_.resize(cycles_.size());
    heights_.resize(cycles_.size() * static_cast<std::size_t>(grid_.nx * grid_.ny));
    in.take_into(prefix + "phase", std::span(phases_));
    in.take_into(prefix + "height", std::span(heights_));
}

void HeightMaps::write(files::Hdf5File& file, const std::string& group) const {
    file.make_group(group);
    file.attribute(group, "length_x", grid_.length_x);
    file.attribute(group, "length_y", grid_.length_y);
    file.write(group + "/cycle", cycles_);
    file.write(group + "/phase", phases_);
    file.write<double>(group + "/height", heights_,
                       {rows(), static_cast<std::uint64_t>(grid_.ny), static_cast<std::uint64_t>(grid_.nx)});
}

HeightMaps HeightMaps::read(const files::Hdf5File& file, const std::string& group) {
    const files::Shape shape = file.shape(group + "/height");
    if (shape.size() != 3) throw files::Damaged(group + "/height: not an array of maps");
    HeightMaps maps({static_cast<std::int64_t>(shape[2]), static_cast<std::int64_t>(shape[1]),
                     file.read_number_attribute(group, "length_x"), file.read_number_attribute(group, "length_y")});
    maps.cycles_ = file.read<std::int64_t>(group + "/cycle");
    maps.phases_ = file.read<double>(group + "/phase");
    maps.heights_ = file.read<double>(group + "/height");
    if (maps.cycles_.size() != shape[0] || maps.phases_.size() != shape[0])
        throw files::Damaged(group + ": maps, cycles and phases differ in number");
    return maps;
}

}  // namespace shaken::fields
