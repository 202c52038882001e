// SPDX-License-Identifier: MIT
#include "continuum/boundary/named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/errors.hpp"

namespace shaken::continuum {

namespace {

struct Entry {
    std::string_view name, words;
    End end;
};

constexpr std::array<Entry, 8> ends{{
    {"plate", "reflects; moves with the plate of the scene", End::wall},
    {"lid", "reflects; moves with the plate", End::wall},
    {"stress_free", "reflects, bears pressure but no viscous stress; moves with the plate", End::stress_free},
    {"wall", "reflects; at rest", End::wall},
    {"heated", "reflects, and is at a given temperature; moves with the plate or piston", End::wall},
    {"piston", "reflects; moves into the gas at constant speed", End::wall},
    {"open", "nothing changes across it", End::open},
    {"periodic", "the other end, both or none", End::periodic},
}};

const Entry& entry_of(std::string_view name) {
    return *std::find_if(ends.begin(), ends.end(), [&](const Entry& e) { return e.name == name; });
}

std::vector<scene::Name> described(std::initializer_list<std::string_view> names) {
    std::vector<scene::Name> all;
    for (const std::string_view name : names) all.push_back({std::string(name), std::string(entry_of(name).words), ""});
    return all;
}

Boundary named_boundary(const NamedEnd& end) {
    std::vector<std::string> known;
    for (const scene::Name& allowed : end.allowed) known.push_back(allowed.name);
    if (std::find(known.begin(), known.end(), end.name.name) == known.end())
        throw scene::unknown_choice(end.key, end.name, known);
    if (end.name.name == "heated" && !end.temperature)
        throw scene::SceneError(end.name.place, fmt::format("{0} = \"heated\" needs {0}_temperature", end.key));
    return {entry_of(end.name.name).end, end.temperature};
}

}  // namespace

Boundaries named_boundaries(const NamedEnd& lower, const NamedEnd& upper) {
    const Boundaries both{named_boundary(lower), named_boundary(upper)};
    if ((both.lower.end == End::periodic) != (both.upper.end == End::periodic))
        throw scene::SceneError(upper.name.place,
                                fmt::format("{} and {} are periodic together or not at all", lower.key, upper.key));
    return both;
}

std::vector<scene::Name> ends_below_layer() { return described({"plate", "heated"}); }
std::vector<scene::Name> ends_above_layer() { return described({"stress_free", "lid", "heated"}); }
std::vector<scene::Name> ends_below_tube() { return described({"open", "wall", "periodic", "heated", "piston"}); }
std::vector<scene::Name> ends_above_tube() { return described({"open", "wall", "periodic", "heated"}); }

Boundaries boundaries_of_layer(const scene::Continuum& c) {
    return named_boundaries({"continuum.lower", c.lower, c.lower_temperature, ends_below_layer()},
                            {"continuum.upper", c.upper, c.upper_temperature, ends_above_layer()});
}

Boundaries boundaries_of_tube(const scene::Tube& t) {
    return named_boundaries({"tube.lower", t.lower, t.lower_temperature, ends_below_tube()},
                            {"tube.upper", t.upper, t.upper_temperature, ends_above_tube()});
}

}  // namespace shaken::continuum
