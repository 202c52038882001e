// SPDX-License-Identifier: MIT
// What was measured of speed against accuracy (data/expected/work_precision.csv), condensed to what a plan needs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shaken::plan {

/// One measured point; columns of the file by name, errors as shares.
struct Row {
    std::string study, engine, scheme, knob, quantity, end;
    double value = 0.0, error = 0.0, cpu_seconds = 0.0;
};

/// Throws std::runtime_error where a column is missing.
std::vector<Row> parse_table(std::string_view csv);

/// error = factor spacing^order, least squares of the logarithms.
struct PowerLaw {
    double factor = 0.0, order = 0.0;
    double residual = 0.0;  // rms of the logarithms: 0.1 is 10 per cent
};

struct GridPoint {
    double spacing = 0.0, error = 0.0, cpu_seconds = 0.0;
};

/// A scheme on ch4_shock: error of z_cm and CPU seconds against the vertical spacing, coarsest first.
struct Scheme {
    std::string name;
    std::vector<GridPoint> points;
    PowerLaw error;  // over the points well above the least error, where something else than the spacing decides
    double least_error = 0;
    /// Between the first two points that have the error between them; nothing where none is as small.
    std::optional<double> seconds_for(double wished) const;
};

class Table {
  public:
    explicit Table(const std::vector<Row>& rows);
    /// Of the schemes that reach the error, the one that takes the least time; the most exact one if none does.
    const Scheme& cheapest(double error) const;
    const std::vector<Scheme>& schemes() const { return schemes_; }
    /// The least error of z_cm that a grid of the table has: below it nothing is promised.
    double floor() const;

  private:
    std::vector<Scheme> schemes_;
};

/// The table that the program was built with.
const Table& measured_table();

}  // namespace shaken::plan
