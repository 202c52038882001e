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
    std::string_view name;
    End end;
};

constexpr std::array<Entry, 8> ends{{{"plate", End::wall},
                                     {"lid", End::wall},
                                     {"stress_free", End::stress_free},
                                     {"wall", End::wall},
                                     {"heated", End::wall},
                                     {"piston", End::wall},
                                     {"open", End::open},
                                     {"periodic", End::periodic}}};

Boundary named_boundary(const NamedEnd& end) {
    const auto known = std::find(end.allowed.begin(), end.allowed.end(), end.name.name);
    if (known == end.allowed.end()) throw scene::unknown_choice(end.key, end.name, end.allowed);
    if (*known == "heated" && !end.temperature)
        throw scene::SceneError(end.name.place, fmt::format("{0} = \"heated\" needs {0}_temperature", end.key));
    const auto entry = std::find_if(ends.begin(), ends.end(), [&](const Entry& e) { return e.name == *known; });
    return {entry->end, end.temperature};
}

}  // namespace

Boundaries named_boundaries(const NamedEnd& lower, const NamedEnd& upper) {
    const Boundaries both{named_boundary(lower), named_boundary(upper)};
    if ((both.lower.end == End::periodic) != (both.upper.end == End::periodic))
        throw scene::SceneError(upper.name.place,
                                fmt::format("{} and {} are periodic together or not at all", lower.key, upper.key));
    return both;
}

std::vector<std::string> ends_below_layer() { return {"plate", "heated"}; }
std::vector<std::string> ends_above_layer() { return {"stress_free", "lid", "heated"}; }

Boundaries boundaries_of_layer(const scene::Continuum& c) {
    return named_boundaries({"continuum.lower", c.lower, c.lower_temperature, ends_below_layer()},
                            {"continuum.upper", c.upper, c.upper_temperature, ends_above_layer()});
}

Boundaries boundaries_of_tube(const scene::Tube& t) {
    return named_boundaries(
        {"tube.lower", t.lower, t.lower_temperature, {"open", "wall", "periodic", "heated", "piston"}},
        {"tube.upper", t.upper, t.upper_temperature, {"open", "wall", "periodic", "heated"}});
}

}  // namespace shaken::continuum
