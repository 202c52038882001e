// SPDX-License-Identifier: MIT
#include "fields/time_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

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

void TimeSeries::save(files::CheckpointWriter& out, const std::string& prefix) const {
    out.put(prefix + "step", step_);
    out.put(prefix + "time", time_);
    out.put(prefix + "values", values_);
}

void TimeSeries::restore(const files::CheckpointReader& in, const std::string& prefix) {
    step_ = in.take<std::int64_t>(prefix + "step");
    time_.resize(step_.size());
    values_.resize(step_.size() * columns_.size());  // another number of columns is another version's
    in.take_into(prefix + "time", std::span(time_));
    in.take_into(prefix + "values", std::span(values_));
}

void TimeSeries::write(files::Hdf5File& file) const {
    if (columns_.empty()) return;
    const std::string first = "/observables/" + columns_.front();
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const std::string group = "/observables/" + columns_[c];
        std::vector<double> column(rows());
        for (std::size_t row = 0; row < rows(); ++row) column[row] = values_[row * columns_.size() + c];
        file.write(group + "/value", column);
        if (c == 0) {
            file.write(group + "/step", step_);
            file.write(group + "/time", time_);
        } else {
            file.hard_link(first + "/step", group + "/step");
            file.hard_link(first + "/time", group + "/time");
        }
    }
}

}  // namespace shaken::fields
