// SPDX-License-Identifier: MIT
// Named columns of numbers, one row a sample instant: totals, ledgers, centre of mass; what a file holds as H5MD
// observables.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "files/hdf5.hpp"

namespace shaken::fields {

class TimeSeries {
  public:
    explicit TimeSeries(std::vector<std::string> columns);

    /// One row: sample number since the start (the H5MD step), time in sqrt(sigma/g), a value for each column.
    void add(std::int64_t step, double time, std::span<const double> values);

    std::size_t rows() const { return step_.size(); }
    const std::vector<std::string>& columns() const { return columns_; }
    double time(std::size_t row) const { return time_[row]; }
    /// Throws std::out_of_range for a column that is not there.
    double value(std::size_t row, const std::string& column) const;

    /// These columns of /observables/NAME/{value,step,time}. Throws files::Damaged where they differ in length.
    static TimeSeries read(const files::Hdf5File& file, std::vector<std::string> columns);

  private:
    std::vector<std::string> columns_;
    std::vector<std::int64_t> step_;
    std::vector<double> time_;
    std::vector<double> values_;  // (rows, columns)
};

}  // namespace shaken::fields
