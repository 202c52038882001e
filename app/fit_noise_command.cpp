// SPDX-License-Identifier: MIT
#include "app/fit_noise_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/exit_codes.hpp"
#include "app/options.hpp"
#include "compare/patterns/noise_fit.hpp"
#include "compare/patterns/power_spectrum.hpp"
#include "files/atomic_write.hpp"
#include "files/errors.hpp"
#include "swift_hohenberg/simulation.hpp"

namespace shaken::app {

namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

/// Columns of numbers of a CSV, by name; where `needed` is lacking or a cell is no number, says so. Columns of `wanted`
/// that the file does not have are left out.
using Table = std::map<std::string, std::vector<double>>;

Table read_table(const std::filesystem::path& path, const std::vector<std::string>& needed,
                 const std::vector<std::string>& wanted = {}) {
    std::ifstream file(path);
    if (!file) throw files::NoInput(fmt::format("{}: no such table", path.string()));
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> header = split(line);
    Table table;
    std::map<std::string, std::size_t> column;
    for (const auto* names : {&needed, &wanted}) {
        for (const std::string& name : *names) {
            const auto at = std::find(header.begin(), header.end(), name);
            if (at != header.end()) {
                column.emplace(name, static_cast<std::size_t>(at - header.begin()));
                table[name] = {};
            } else if (names == &needed) {
                throw files::Damaged(
                    fmt::format("{}:1: no column '{}'; needed: {}", path.string(), name, fmt::join(needed, ", ")));
            }
        }
    }
    for (int number = 2; std::getline(file, line); ++number) {
        const std::vector<std::string> cells = split(line);
        for (const auto& [name, at] : column) {
            try {
                table[name].push_back(std::stod(cells.at(at)));
            } catch (const std::logic_error&) {
                throw files::Damaged(fmt::format("{}:{}: no number in column '{}'", path.string(), number, name));
            }
        }
    }
    return table;
}

/// Rows of one control are runs of their own, not one run again.
void refuse_rows_twice(const Table& table, const std::filesystem::path& path) {
    std::map<std::array<double, 3>, std::size_t> first;
    for (std::size_t i = 0; i < table.at("value").size(); ++i) {
        const std::array row{table.at("value")[i], table.at("mean_square")[i], table.at("order")[i]};
        if (std::isnan(row[1] + row[2])) continue;
        const auto [before, is_new] = first.emplace(row, i);
        constexpr std::size_t first_line = 2;
        if (!is_new)
            throw files::Damaged(
                fmt::format("{0}:{1} and {0}:{2}: one run twice, value = {3} with equal mean_square and "
                            "order; an average is over independent runs",
                            path.string(), before->second + first_line, i + first_line, row[0]));
    }
}

/// <psi^2> and P_max against the control: the mean of the rows (seeds) of each value, in order.
compare::OnsetCurve read_measured(const std::filesystem::path& path) {
    const Table table = read_table(path, {"value", "mean_square", "order"}, {"mean_square_error", "order_error"});
    refuse_rows_twice(table, path);
    const auto& value = table.at("value");
    const std::set<double> controls(value.begin(), value.end());
    compare::OnsetCurve curve;
    curve.control.assign(controls.begin(), controls.end());
    const auto merge = [&](const char* name, bool squares) {
        std::vector<double> merged;
        if (!table.contains(name)) return merged;
        for (const double control : controls) {
            double sum = 0.0, rows = 0.0;
            for (std::size_t i = 0; i < value.size(); ++i) {
                if (value[i] != control) continue;
                const double cell = table.at(name)[i];
                sum += squares ? cell * cell : cell;
                rows += 1.0;
            }
            merged.push_back((squares ? std::sqrt(sum) : sum) / rows);
        }
        return merged;
    };
    curve.mean_square = merge("mean_square", false);
    curve.order = merge("order", false);
    curve.mean_square_error = merge("mean_square_error", true);
    curve.order_error = merge("order_error", true);
    return curve;
}

/// TABLE.blocks.csv, if there is one: the blocks of cycles of every run, by control.
std::vector<compare::MeasuredRuns> read_blocks(std::filesystem::path path) {
    path.replace_extension(".blocks.csv");
    if (!std::filesystem::exists(path)) return {};
    std::vector<std::string> needed{"value", "run", "mean_square"};
    const auto angles = static_cast<std::size_t>(compare::PowerSpectrum::angles);
    for (std::size_t a = 0; a < angles; ++a) needed.push_back(fmt::format("power_{}", a));
    const Table table = read_table(path, needed);
    std::map<double, std::map<double, std::vector<compare::PatternBlock>>> by_control;
    for (std::size_t i = 0; i < table.at("value").size(); ++i) {
        compare::PatternBlock block{table.at("mean_square")[i], {}};
        for (std::size_t a = 0; a < angles; ++a) block.by_angle.push_back(table.at(needed[3 + a])[i]);
        by_control[table.at("value")[i]][table.at("run")[i]].push_back(block);
    }
    std::vector<compare::MeasuredRuns> points;
    for (const auto& [control, runs] : by_control) {
        points.push_back({control, {}});
        for (const auto& [run, blocks] : runs) points.back().runs.push_back(blocks);
    }
    return points;
}

/// Curves of the model that an earlier call left.
std::vector<compare::ModelCurve> read_model(const std::filesystem::path& path) {
    const Table table = read_table(path, {"noise", "control", "mean_square", "order"});
    std::vector<compare::ModelCurve> curves;
    for (std::size_t i = 0; i < table.at("noise").size(); ++i) {
        if (curves.empty() || curves.back().noise != table.at("noise")[i]) curves.push_back({table.at("noise")[i], {}});
        compare::OnsetCurve& curve = curves.back().curve;
        curve.control.push_back(table.at("control")[i]);
        curve.mean_square.push_back(table.at("mean_square")[i]);
        curve.order.push_back(table.at("order")[i]);
    }
    return curves;
}

/// One steady state of the model: its mean spectrum.
struct Job {
    Job(const swift_hohenberg::Parameters& p)
        : simulation(p), transform({p.points, p.points, p.side, p.side}), spectrum(transform) {}

    void run(std::int64_t settle, std::int64_t average) {
        simulation.advance(settle);
        for (std::int64_t i = 0; i < average; ++i) {
            simulation.step();
            spectrum.add(transform.amplitudes(simulation.field()));
        }
    }

    swift_hohenberg::Simulation simulation;
    compare::MapTransform transform;
    compare::PowerSpectrum spectrum;
};

std::vector<compare::ModelCurve> model_curves(const FitNoiseOptions& options) {
    const auto points = static_cast<std::size_t>(options.controls), seeds = static_cast<std::size_t>(options.seeds);
    const auto control = [&](std::size_t i) {
        return options.lowest +
               (options.highest - options.lowest) * static_cast<double>(i) / static_cast<double>(points - 1);
    };
    // Made one after another, since transforms are planned then; run at once.
    std::vector<std::unique_ptr<Job>> jobs;
    for (const double noise : options.noises) {
        for (std::size_t i = 0; i < points; ++i) {
            for (std::size_t s = 0; s < seeds; ++s) {
                swift_hohenberg::Parameters p;
                p.control = control(i);
                p.noise = noise;
                p.seed = options.seed + s;
                jobs.push_back(std::make_unique<Job>(p));
            }
        }
    }
    spdlog::info("{} steady states of the model, {} steps each", jobs.size(), options.settle + options.average);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t j = 0; j < jobs.size(); ++j) jobs[j]->run(options.settle, options.average);

    std::vector<compare::ModelCurve> curves;
    std::size_t job = 0;
    for (const double noise : options.noises) {
        compare::ModelCurve curve{noise, {}};
        for (std::size_t i = 0; i < points; ++i) {
            double square = 0.0, order = 0.0;
            for (std::size_t s = 0; s < seeds; ++s, ++job) {
                square += jobs[job]->spectrum.mean_square() / static_cast<double>(seeds);
                order += jobs[job]->spectrum.order() / static_cast<double>(seeds);
            }
            curve.curve.control.push_back(control(i));
            curve.curve.mean_square.push_back(square);
            curve.curve.order.push_back(order);
        }
        curves.push_back(curve);
    }
    return curves;
}

std::string as_table(const std::vector<compare::ModelCurve>& curves) {
    std::string text = "noise,control,mean_square,order\n";
    for (const auto& [noise, curve] : curves)
        for (std::size_t i = 0; i < curve.control.size(); ++i)
            text +=
                fmt::format("{},{:.6g},{:.6g},{:.6g}\n", noise, curve.control[i], curve.mean_square[i], curve.order[i]);
    return text;
}

void check(const FitNoiseOptions& options) {
    if (options.noises.size() < 3) throw UsageError("--noises: at least three are needed");
    for (std::size_t i = 0; i < options.noises.size(); ++i)
        if (!(options.noises[i] > 0.0) || (i > 0 && options.noises[i] <= options.noises[i - 1]))
            throw UsageError("--noises must be above 0 and ascend");
    if (!(options.lowest < options.highest)) throw UsageError("--lowest must be below --highest");
}

}  // namespace

int run_fit_noise(const FitNoiseOptions& options) {
    check(options);
    const std::filesystem::path path =
        std::filesystem::is_directory(options.table) ? options.table / "table.csv" : options.table;
    const compare::OnsetCurve measured = read_measured(path);
    if (measured.control.size() < 4)
        throw files::Damaged(
            fmt::format("{}: {} values; at least four are needed", path.string(), measured.control.size()));
    std::filesystem::path kept = options.model;
    if (kept.empty()) kept = std::filesystem::path(path).replace_extension(".model.csv");
    if (options.model.empty() || !std::filesystem::exists(kept))
        files::write_atomically(kept, as_table(model_curves(options)));
    const std::vector<compare::ModelCurve> model = read_model(kept);
    const std::vector<compare::MeasuredRuns> blocks = read_blocks(path);
    const auto by = options.onset_by_size ? compare::OnsetBy::mean_square : compare::OnsetBy::order;
    const compare::NoiseFit fit = [&] {
        try {
            return compare::fit_noise(measured, model, compare::redraw_blocks(measured, blocks), options.draws, 1, by);
        } catch (const std::invalid_argument& error) {
            throw files::Damaged(fmt::format("{}: {}", path.string(), error.what()));
        }
    }();
    nlohmann::ordered_json residuals = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < model.size(); ++i)
        residuals.push_back({{"noise", model[i].noise}, {"residual", fit.residuals[i]}});
    nlohmann::ordered_json without = nlohmann::ordered_json::array();
    for (const auto& [control, one] : compare::fit_without_each(measured, model, by))
        without.push_back({{"value", control}, {"noise", one.noise}, {"mean_field_onset", one.mean_field_onset}});
    const nlohmann::ordered_json line{{"noise", fit.noise},
                                      {"noise_error", fit.noise_error},
                                      {"noise_low", fit.noise_low},
                                      {"noise_high", fit.noise_high},
                                      {"mean_field_onset", fit.mean_field_onset},
                                      {"mean_field_onset_error", fit.mean_field_onset_error},
                                      {"onset", fit.onset},
                                      {"onset_error", fit.onset_error},
                                      {"onset_control", fit.onset_control},
                                      {"scale", fit.scale},
                                      {"residual", fit.residual},
                                      {"draws", fit.fitted_draws},
                                      {"points_with_blocks", blocks.size()},
                                      {"residuals", residuals},
                                      {"without_one_value", without}};
    fmt::print("{}\n", line.dump());
    return exit_code::done;
}

}  // namespace shaken::app
