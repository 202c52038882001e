// SPDX-License-Identifier: MIT
#include "app/closure_command.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/exit_codes.hpp"
#include "app/options.hpp"
#include "continuum/closures/closures.hpp"
#include "continuum/closures/values.hpp"
#include "scene/errors.hpp"

namespace shaken::app {

namespace {

using continuum::ClosureValues;

struct Column {
    const char *name, *unit, *words;
    double (*value)(const ClosureValues&);
};

// Units as in scenes; T is in g sigma and n in 1/sigma^3, so that those of viscosity and conductivity are one.
constexpr std::array<Column, 7> columns{{
    {"p", "m g/sigma^2", "pressure", [](const ClosureValues& v) { return v.pressure; }},
    {"c", "sqrt(g sigma)", "speed of sound", [](const ClosureValues& v) { return v.sound_speed; }},
    {"mu", "m sqrt(g/sigma)/sigma", "shear viscosity",
     [](const ClosureValues& v) { return v.transport.shear_viscosity; }},
    {"lambda", "m sqrt(g/sigma)/sigma", "bulk viscosity",
     [](const ClosureValues& v) { return v.transport.bulk_viscosity; }},
    {"kappa", "m sqrt(g/sigma)/sigma", "conductivity: q = -kappa grad T - mu_n grad n",
     [](const ClosureValues& v) { return v.transport.conductivity; }},
    {"mu_n", "m g sigma^3 sqrt(g/sigma)", "conductivity along the density gradient",
     [](const ClosureValues& v) { return v.transport.density_conductivity; }},
    {"gamma", "m g sqrt(g/sigma)/sigma^2", "energy that collisions take, of a unit of volume in a unit of time",
     [](const ClosureValues& v) { return v.cooling; }},
}};

nlohmann::ordered_json described(const std::vector<scene::Name>& list) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const scene::Name& one : list)
        all.push_back({{"name", one.name}, {"words", one.words}, {"reference", one.reference}});
    return all;
}

int print_list(bool json) {
    const auto closures = continuum::Closures::described(), pairs = continuum::PairCorrelations::described();
    if (json) {
        fmt::print(
            "{}\n",
            nlohmann::ordered_json{{"closures", described(closures)}, {"pair_correlations", described(pairs)}}.dump());
        return exit_code::done;
    }
    const auto print = [](const char* title, const std::vector<scene::Name>& list) {
        fmt::print("{}\n", title);
        for (const scene::Name& one : list) fmt::print("  {:<24} {}. {}\n", one.name, one.words, one.reference);
    };
    print("closures (continuum.closure)", closures);
    print("pair correlations (continuum.pair_correlation)", pairs);
    return exit_code::done;
}

void print_table(const ClosureOptions& options, const std::vector<ClosureValues>& values) {
    fmt::print("# {}, {}, T = {} g sigma, e = {}\n", options.name, options.pair_correlation, options.temperature,
               options.restitution);
    for (const Column& c : columns) fmt::print("# {:<7} {}; in {}\n", c.name, c.words, c.unit);
    fmt::print("{:>10}", "nu");
    for (const Column& c : columns) fmt::print(" {:>12}", c.name);
    fmt::print("\n");
    for (std::size_t i = 0; i < values.size(); ++i) {
        fmt::print("{:>10g}", options.volume_fractions[i]);
        for (const Column& c : columns) fmt::print(" {:>12.6g}", c.value(values[i]));
        fmt::print("\n");
    }
}

void print_json(const ClosureOptions& options, const std::vector<ClosureValues>& values) {
    nlohmann::ordered_json out{{"closure", options.name},
                               {"pair_correlation", options.pair_correlation},
                               {"T", options.temperature},
                               {"e", options.restitution},
                               {"nu", options.volume_fractions}};
    for (const Column& c : columns)
        for (const ClosureValues& v : values) out[c.name].push_back(c.value(v));
    out["units"]["T"] = "g sigma";
    for (const Column& c : columns) out["units"][c.name] = c.unit;
    fmt::print("{}\n", out.dump());
}

}  // namespace

int run_closure(const ClosureOptions& options) {
    if (options.name.empty()) return print_list(options.json);
    std::vector<ClosureValues> values;
    try {
        for (const double nu : options.volume_fractions)
            values.push_back(continuum::closure_values({options.name, {}}, {options.pair_correlation, {}}, nu,
                                                       options.temperature, options.restitution));
    } catch (const scene::SceneError& unknown) {
        throw UsageError(fmt::format("closure: {}", unknown.what()));
    } catch (const std::invalid_argument& outside) {
        throw UsageError(fmt::format("closure: {}", outside.what()));
    }
    if (options.json)
        print_json(options, values);
    else
        print_table(options, values);
    return exit_code::done;
}

}  // namespace shaken::app
