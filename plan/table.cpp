// SPDX-License-Identifier: MIT
#include "plan/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "plan/work_precision.hpp"

namespace shaken::plan {

namespace {

/// Fields of one line; quoted ones may hold commas and doubled quotes.
std::vector<std::string> fields_of(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

PowerLaw fit(const std::vector<GridPoint>& points) {
    const auto n = static_cast<double>(points.size());
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const GridPoint& point : points) {
        const double a = std::log(point.spacing), b = std::log(point.error);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    PowerLaw law;
    law.order = (n * xy - x * y) / (n * xx - x * x);
    law.factor = std::exp((y - law.order * x) / n);
    double square = 0.0;
    for (const GridPoint& point : points)
        square += std::pow(std::log(point.error / (law.factor * std::pow(point.spacing, law.order))), 2);
    law.residual = std::sqrt(square / n);
    return law;
}

/// Errors near the least one say nothing of the order any more.
constexpr double well_above = 5.0;

Scheme condense(const std::string& name, std::vector<GridPoint> points) {
    std::sort(points.begin(), points.end(),
              [](const GridPoint& a, const GridPoint& b) { return a.spacing > b.spacing; });
    Scheme scheme{name, points, {}, points.front().error};
    for (const GridPoint& point : points) scheme.least_error = std::min(scheme.least_error, point.error);
    std::vector<GridPoint> falling;
    for (const GridPoint& point : points)
        if (point.error > well_above * scheme.least_error) falling.push_back(point);
    scheme.error = fit(falling.size() >= 2 ? falling : points);
    return scheme;
}

}  // namespace

std::vector<Row> parse_table(std::string_view csv) {
    std::vector<Row> rows;
    std::map<std::string, std::size_t> columns;
    while (!csv.empty()) {
        const std::string_view line = csv.substr(0, csv.find('\n'));
        csv.remove_prefix(std::min(csv.size(), line.size() + 1));
        if (line.empty() || line.front() == '#') continue;
        const std::vector<std::string> fields = fields_of(line);
        if (columns.empty()) {
            for (std::size_t i = 0; i < fields.size(); ++i) columns[fields[i]] = i;
            continue;
        }
        const auto text = [&](const char* name) -> const std::string& {
            const auto found = columns.find(name);
            if (found == columns.end() || found->second >= fields.size())
                throw std::runtime_error(fmt::format("work_precision.csv: no column {} in '{}'", name, line));
            return fields[found->second];
        };
        const auto number = [&](const char* name) { return std::strtod(text(name).c_str(), nullptr); };
        rows.push_back({text("study"), text("engine"), text("scheme"), text("knob"), text("quantity"), text("end"),
                        number("value"), 0.01 * number("error_percent"), number("cpu_seconds")});
    }
    return rows;
}

std::optional<double> Scheme::seconds_for(double wished) const {
    if (points.front().error <= wished) return points.front().cpu_seconds;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const GridPoint &coarse = points[k], &fine = points[k + 1];
        if (fine.error > wished) continue;
        const double share = std::log(wished / coarse.error) / std::log(fine.error / coarse.error);
        return coarse.cpu_seconds * std::pow(fine.cpu_seconds / coarse.cpu_seconds, share);
    }
    return std::nullopt;
}

Table::Table(const std::vector<Row>& rows) {
    std::map<std::string, std::vector<GridPoint>> points;
    for (const Row& row : rows) {
        if (row.study != "ch4_shock" || row.engine != "continuum" || row.knob != "dz" || row.quantity != "z_cm")
            continue;
        if (row.error > 0.0 && row.value > 0.0 && row.cpu_seconds > 0.0)
            points[row.scheme].push_back({row.value, row.error, row.cpu_seconds});
    }
    for (const auto& [name, measured] : points)
        if (measured.size() >= 3) schemes_.push_back(condense(name, measured));
    if (schemes_.empty()) throw std::runtime_error("work_precision.csv: no errors of z_cm against the spacing");
}

const Scheme& Table::cheapest(double error) const {
    const Scheme* best = nullptr;
    for (const Scheme& scheme : schemes_) {
        const std::optional<double> seconds = scheme.seconds_for(error);
        if (seconds && (!best || *seconds < *best->seconds_for(error))) best = &scheme;
    }
    if (best) return *best;
    return *std::min_element(schemes_.begin(), schemes_.end(),
                             [](const Scheme& a, const Scheme& b) { return a.least_error < b.least_error; });
}

double Table::floor() const {
    double least = schemes_.front().least_error;
    for (const Scheme& scheme : schemes_) least = std::min(least, scheme.least_error);
    return least;
}

const Table& measured_table() {
    static const Table table(parse_table(work_precision_csv));
    return table;
}

}  // namespace shaken::plan
