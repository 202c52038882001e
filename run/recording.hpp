// SPDX-License-Identifier: MIT
// What is recorded at every sample instant: a column's name, unit and value stand together, in one line.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "run/stream.hpp"

namespace shaken::run {

struct ColumnName {
    std::string name, unit;  // unit in sigma, m, g; "1" for a number
};

/// Sampled: what there is to be read off at an instant.
template <class Sampled>
struct Column {
    const char* name;
    const char* unit;
    double (*value)(const Sampled&);
};

template <class Sampled>
class Recording {
  public:
    explicit Recording(std::vector<Column<Sampled>> columns) : columns_(std::move(columns)) {}

    std::vector<ColumnName> names() const {
        std::vector<ColumnName> names;
        for (const auto& column : columns_) names.push_back({column.name, column.unit});
        return names;
    }
    /// sample: its number since the start; time in sqrt(sigma/g).
    void emit(std::int64_t sample, double time, const Sampled& sampled, const Emit& emit) const {
        std::vector<double> row{static_cast<double>(sample), time};
        for (const auto& column : columns_) row.push_back(column.value(sampled));
        emit(Stream::row, row);
    }

  private:
    std::vector<Column<Sampled>> columns_;
};

}  // namespace shaken::run
