// SPDX-License-Identifier: MIT
#include "scene/parameters.hpp"

#include <fmt/format.h>

#include <array>

namespace shaken::scene {

std::string Range::text() const {
    const bool below = lower > -unbounded, above = upper < unbounded;
    if (below && above) return fmt::format("{}{}, {}]", open_lower ? '(' : '[', lower, upper);
    if (below) return open_lower ? fmt::format("greater than {}", lower) : fmt::format("at least {}", lower);
    if (above) return fmt::format("at most {}", upper);
    return "a finite number";
}

const std::vector<std::string>& kind_names() {
    static const std::vector<std::string> names{"layer",  "uniform", "riemann",     "piston",
                                                "column", "wave",    "cooling_flow"};
    return names;
}

const std::vector<std::string>& restitution_law_names() {
    static const std::vector<std::string> names{"constant", "velocity"};
    return names;
}

const std::vector<std::string>& friction_law_names() {
    static const std::vector<std::string> names{"none", "walton", "walton_without_spin"};
    return names;
}

const std::vector<std::string>& collapse_remedy_names() {
    static const std::vector<std::string> names{"none", "elastic_below", "contact_time"};
    return names;
}

namespace {

// Largest counts are those that fit the engines' 32-bit indices with room to spare.
constexpr Range counts{1.0, 1e9};
// Up to where equal spheres fill space, 0.74048; what an engine can start from may be less, and it says so.
constexpr Range packings{0.0, 0.74, true};

/// What engines add to a section.
void describe_of_owners(Scene& s, std::string_view section, ParameterVisitor& v) {
    for (const KeyOwner* owner : s.owners.list) {
        v.owner(owner->name);
        owner->describe_shared(s, section, v);
    }
    v.owner({});
}

/// What contacts do, in every kind of scene that has particles.
void describe_contacts(Scene& s, ParameterVisitor& v) {
    v.restitution(
        {"restitution", "",
         "a number e in [0, 1], or { law = \"velocity\", e0 = 0.7, v0 = 1 }: 1 - (1 - e0)(v/v0)^(3/4) below v0"},
        s.particles.restitution);
    describe_of_owners(s, "particles", v);
}

void describe_layer(Scene& s, ParameterVisitor& v) {
    v.section("plate", "the oscillating plate, z_p = A (1 - cos 2 pi f t)");
    v.number({"acceleration", "g", "peak acceleration over gravity, Gamma = 4 pi^2 f^2 A"}, s.plate.acceleration,
             at_least_zero);
    v.optional_number({"frequency", "sqrt(g/sigma)", "f; or give frequency_star"}, s.plate.frequency, not_at_rest);
    v.optional_number({"frequency_star", "", "f* = f sqrt(H); or give frequency"}, s.plate.frequency_star, not_at_rest);

    v.section("particles", "the grains: spheres of diameter 1 and mass 1");
    v.optional_whole({"number", "", "how many, N; or give depth"}, s.particles.number, counts);
    v.optional_number({"depth", "sigma", "depth as poured, H = 0.9 N/(x y); or give number"}, s.particles.depth,
                      positive);
    describe_contacts(s, v);

    v.section("box", "the cell: periodic in x and y");
    v.number({"x", "sigma", "width"}, s.box.x, widths);
    v.number({"y", "sigma", "width"}, s.box.y, widths);
    describe_of_owners(s, "box", v);

    v.section("initial", "a flat layer on the plate");
    v.number({"volume_fraction", "", "of the layer at the start", Part::start}, s.initial.volume_fraction, packings);
    v.number({"temperature", "g sigma", "granular temperature at the start", Part::start}, s.initial.temperature,
             positive);
    describe_of_owners(s, "initial", v);
    v.seed({"seed", "", "of the random start", Part::start}, s.initial.seed);
    v.text({"file", "", "an earlier output to start from", Part::start}, s.initial.file);
    v.number(
        {"phase", "", "ft of the state in that file which a run starts from and at, a sample instant", Part::start},
        s.initial.phase, {0.0, 1.0});

    v.section("sample", "when and how fields are measured");
    v.whole({"phases", "", "sample instants a cycle, a multiple of 20"}, s.sample.phases, {20.0, 100000.0});
    v.whole({"settle", "cycles", "before averaging begins", Part::length}, s.sample.settle, {0.0, 1e9});
    v.whole({"average", "cycles", "to average over", Part::length}, s.sample.average, counts);
    v.number({"bin", "sigma", "height of a bin of the profiles"}, s.sample.bin, {0.01, 100.0});
    v.whole({"frames", "", "whole states kept of the last cycle, at equal phases; a divisor of phases, 0 for none",
             Part::length},
            s.sample.frames, {0.0, 100000.0});
    v.whole({"frame_cycles", "", "how many cycles at the end keep them; two show a pattern at half the frequency",
             Part::length},
            s.sample.frame_cycles, {1.0, 1000.0});
    v.whole({"maps", "", "maps of z_cm(x, y) kept of every cycle, at equal phases; a divisor of phases"}, s.sample.maps,
            {1.0, 100000.0});
    v.number({"map_bin", "sigma", "width of a bin of these maps; 0: no maps are kept"}, s.sample.map_bin,
             {0.0, 1000.0});
}

/// A homogeneous gas in a periodic cube, without gravity: what hard-sphere theory knows most about.
void describe_uniform(Scene& s, ParameterVisitor& v) {
    v.section("particles", "spheres of diameter 1 and mass 1");
    v.optional_whole({"number", "", "how many, N; or give box.side"}, s.particles.number, counts);
    describe_contacts(s, v);

    v.section("box", "a cube, periodic in three directions");
    v.optional_number({"side", "sigma", "of the cube, (pi N/(6 nu))^(1/3); or give particles.number"}, s.uniform.side,
                      widths);

    v.section("initial", "a homogeneous gas at rest as a whole");
    v.number({"volume_fraction", "", "of the gas, nu"}, s.initial.volume_fraction, packings);
    v.number({"temperature", "g sigma", "granular temperature at the start", Part::start}, s.initial.temperature,
             positive);
    v.seed({"seed", "", "of the random start", Part::start}, s.initial.seed);
    v.text({"file", "", "an earlier output of the MD to start from", Part::start}, s.initial.file);

    v.section("sample", "when the gas is measured");
    v.number({"interval", "sqrt(sigma/g)", "between sample instants"}, s.uniform.interval, positive);
    v.number({"settle", "sqrt(sigma/g)", "time before averaging, whole intervals", Part::length}, s.uniform.settle,
             at_least_zero);
    v.number({"duration", "sqrt(sigma/g)", "time averaged over, whole intervals", Part::length}, s.uniform.duration,
             positive);
    v.whole({"frames", "", "whole states kept of the time averaged over, the last at its end; 0: none", Part::length},
            s.uniform.frames, {0.0, 100000.0});
}

}  // namespace

void describe(Scene& s, ParameterVisitor& v) {
    v.section("scene", "what is computed");
    v.text({"name", "", "of the scene, in outputs and figures", Part::label}, s.name);
    v.kind({"kind", "", "what is simulated"}, s.kind);
    switch (s.kind) {
        case Kind::layer:
            describe_layer(s, v);
            break;
        case Kind::uniform:
            describe_uniform(s, v);
            break;
        default:  // a kind that one engine alone can run
            break;
    }
    for (const KeyOwner* owner : s.owners.list) {
        v.owner(owner->name);
        owner->describe_own(s, v);
    }
    v.owner({});
}

}  // namespace shaken::scene
