// SPDX-License-Identifier: MIT
#include "app/fit_noise_command.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
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

/// Rows of the named columns, in order of `value`. Columns that are not there are empty.
compare::OnsetCurve read_table(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw files::NoInput(fmt::format("{}: no such table", path.string()));
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> header = split(line);
    const std::vector<std::string> wanted{"value", "mean_square", "order", "mean_square_error", "order_error"};
    std::map<std::string, std::size_t> column;
    for (std::size_t c = 0; c < header.size(); ++c) column.emplace(header[c], c);
    for (std::size_t w = 0; w < 3; ++w)
        if (!column.contains(wanted[w]))
            throw files::Damaged(
                fmt::format("{}:1: no column '{}'; needed: value, mean_square, order", path.string(), wanted[w]));
    std::vector<std::vector<double>> rows;
    for (int number = 2; std::getline(file, line); ++number) {
        const std::vector<std::string> cells = split(line);
        std::vector<double> row;
        for (const std::string& name : wanted) {
            if (!column.contains(name)) continue;
            try {
                row.push_back(std::stod(cells.at(column.at(name))));
            } catch (const std::logic_error&) {
                throw files::Damaged(fmt::format("{}:{}: no number in column '{}'", path.string(), number, name));
            }
        }
        rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    compare::OnsetCurve curve;
    std::vector<std::vector<double>*> targets{&curve.control, &curve.mean_square, &curve.order};
    if (column.contains(wanted[3])) targets.push_back(&curve.mean_square_error);
    if (column.contains(wanted[4])) targets.push_back(&curve.order_error);
    for (const auto& row : rows)
        for (std::size_t t = 0; t < targets.size(); ++t) targets[t]->push_back(row[t]);
    return curve;
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
    const compare::OnsetCurve measured = read_table(path);
    if (measured.control.size() < 4)
        throw files::Damaged(
            fmt::format("{}: {} rows; at least four are needed", path.string(), measured.control.size()));
    const std::vector<compare::ModelCurve> model = model_curves(options);
    std::filesystem::path beside = path;
    files::write_atomically(beside.replace_extension(".model.csv"), as_table(model));
    const compare::NoiseFit fit = [&] {
        try {
            return compare::fit_noise(measured, model);
        } catch (const std::invalid_argument& error) {
            throw files::Damaged(fmt::format("{}: {}", path.string(), error.what()));
        }
    }();
    nlohmann::ordered_json residuals = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < model.size(); ++i)
        residuals.push_back({{"noise", model[i].noise}, {"residual", fit.residuals[i]}});
    const nlohmann::ordered_json line{{"noise", fit.noise},
                                      {"noise_error", fit.noise_error},
                                      {"mean_field_onset", fit.mean_field_onset},
                                      {"mean_field_onset_error", fit.mean_field_onset_error},
                                      {"onset", fit.onset},
                                      {"onset_control", fit.onset_control},
                                      {"scale", fit.scale},
                                      {"residual", fit.residual},
                                      {"residuals", residuals}};
    fmt::print("{}\n", line.dump());
    return exit_code::done;
}

}  // namespace shaken::app
