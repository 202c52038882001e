// SPDX-License-Identifier: MIT
#include "continuum/sizes.hpp"

#include <fmt/format.h>

#include <string>

#include "scene/errors.hpp"

namespace shaken::continuum {

namespace {

using scene::refusal;
using scene::Scene;

constexpr double largest = 8e9;  // bytes

/// A temperature belongs to an end named heated; that such an end has one is checked where its name is.
template <class Ends>
void check_temperatures(const Scene& s, const std::string& section, const Ends& ends) {
    const auto check = [&](const std::string& end, const scene::Choice& name,
                           const std::optional<double>& temperature) {
        const std::string key = section + "." + end;
        if (temperature && name.name != "heated")
            throw refusal(s, key + "_temperature",
                          fmt::format("{0}_temperature needs {0} = \"heated\"; it is \"{1}\"", key, name.name));
    };
    check("lower", ends.lower, ends.lower_temperature);
    check("upper", ends.upper, ends.upper_temperature);
}

void check_averages(const Scene& s) {
    const double bins = s.continuum.lid / s.sample.bin, phases = static_cast<double>(s.sample.phases);
    // Ten blocks of seven moments of 8 bytes, and a height a cycle.
    const double profiles = phases * (10.0 * 7.0 * 8.0 * bins + 8.0 * static_cast<double>(s.sample.average));
    if (profiles > largest)
        throw refusal(s, "sample.phases",
                      fmt::format("sample.phases = {} with {:.3g} bins and {} cycles needs {:.3g} GB for averages; at "
                                  "most {:.3g} are allowed",
                                  s.sample.phases, bins, s.sample.average, 1e-9 * profiles, 1e-9 * largest));
}

void check_cells(const Scene& s) {
    const double columns =
        s.continuum.dimension.name == "1" || (s.continuum.dimension.name == "auto" && !s.initial.uneven())
            ? 1.0
            : s.box.x * s.box.y / (s.continuum.spacing_horizontal * s.continuum.spacing_horizontal);
    const double cells = columns * s.continuum.lid / s.continuum.spacing;
    constexpr double bytes_a_cell = 220.0;
    if (s.continuum.dimension.name != "2" && cells * bytes_a_cell > largest)
        throw refusal(s, "continuum.spacing",
                      fmt::format("continuum.spacing = {} and spacing_horizontal = {} make {:.3g} cells; at most "
                                  "{:.3g} are allowed",
                                  s.continuum.spacing, s.continuum.spacing_horizontal, cells, largest / bytes_a_cell));
}

void check_layer(const Scene& s) {
    if (s.continuum.lid < s.thickness_at_start())
        throw refusal(s, "continuum.lid",
                      fmt::format("continuum.lid = {} is below the top of the layer at the start, {:.4g}",
                                  s.continuum.lid, s.thickness_at_start()));
    check_averages(s);
    check_cells(s);
    check_temperatures(s, "continuum", s.continuum);
    if (s.continuum.spacing > 0.25 * s.continuum.lid)
        throw refusal(s, "continuum.spacing",
                      fmt::format("continuum.spacing = {} leaves fewer than 4 cells below continuum.lid = {}",
                                  s.continuum.spacing, s.continuum.lid));
}

void check_tube(const Scene& s) {
    check_temperatures(s, "tube", s.tube);
    const double cells = s.tube.length / s.continuum.spacing;
    if (!(cells >= 16.0 && cells <= 1e7))
        throw refusal(s, "continuum.spacing",
                      fmt::format("continuum.spacing = {} makes {:.3g} cells of tube.length = {}; allowed: 16 to 1e7",
                                  s.continuum.spacing, cells, s.tube.length));
    if (s.kind == scene::Kind::column && !s.tube.wall_temperature && s.tube.restitution < 1.0)
        throw refusal(s, "tube.restitution",
                      "tube.restitution below 1 needs tube.wall_temperature: without heat the gas cools");
}

}  // namespace

void check_sizes(const Scene& s) {
    if (s.kind == scene::Kind::layer)
        check_layer(s);
    else if (s.kind != scene::Kind::uniform)
        check_tube(s);
}

}  // namespace shaken::continuum
