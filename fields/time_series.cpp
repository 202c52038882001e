// SPDX-License-Identifier: MIT
#include "fields/time_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "files/errors.hpp"

namespace shaken::fields {

TimeSeries::TimeSeries(std::vector<std::string> columns) : columns_(std::move(columns)) {}

void TimeSeries::add(std::int64_t step, double time, std::span<const double> values) {
    if (values.size() != columns_.size()) {
        throw std::invalid_argument(fmt::format("a row of {} values for {} columns", values.size(), columns_.size()));
    }
    step_.push_back(step);
    time_.push_back(time);
    values_.insert(values_.end(), values.begin(), values.end());
}

double TimeSeries::value(std::size_t row, const std::string& column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found == columns_.end() || row >= rows())
        throw std::out_of_range(fmt::format("no row {} of column {}", row, column));
    return values_[row * columns_.size() + static_cast<std::size_t>(found - columns_.begin())];
}

TimeSeries TimeSeries::read(const files::Hdf5File& file, std::vector<std::string> columns) {
    TimeSeries series(std::move(columns));
    if (series.columns_.empty()) return series;
    const std::string first = "/observables/" + series.columns_.front();
    series.step_ = file.read<std::int64_t>(first + "/step");
    series.time_ = file.read<double>(first + "/time");
    const std::size_t width = series.columns_.size();
    series.values_.resize(series.rows() * width);
    for (std::size_t c = 0; c < width; ++c) {
        const auto column = file.read<double>("/observables/" + series.columns_[c] + "/value");
        if (column.size() != series.rows() || series.time_.size() != series.rows())
            throw files::Damaged("/observables/" + series.columns_[c] + ": not as many rows as " + first);
        for (std::size_t row = 0; row < series.rows(); ++row) series.values_[row * width + c] = column[row];
    }
    return series;
}

}  // namespace shaken::fields
