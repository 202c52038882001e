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
constexpr Range fractions{0.0, 1.0};
constexpr Range widths{2.0, 1e6};
// Up to where equal spheres fill space, 0.74048; what an engine can start from may be less, and it says so.
constexpr Range packings{0.0, 0.74, true};

/// The names that every kind of continuum run has.
void describe_continuum_choices(Scene& s, ParameterVisitor& v) {
    v.section("continuum", "granular hydrodynamics");
    v.choice({"scheme", "", "discretisation"}, s.continuum.scheme);
    v.choice({"flux", "", "numerical flux (muscl, weno5)"}, s.continuum.flux);
    v.choice({"limiter", "", "slope limiter (muscl)"}, s.continuum.limiter);
    v.choice({"closure", "", "transport coefficients"}, s.continuum.closure);
    v.choice({"pair_correlation", "", "pair correlation at contact"}, s.continuum.pair_correlation);
    v.choice({"transport", "", "\"navier_stokes\" or \"inviscid\""}, s.continuum.transport);
}

/// What the scheme ftcs alone has.
void describe_finite_differences(Scene& s, ParameterVisitor& v) {
    v.number({"artificial_dissipation", "",
              "C_AD of the scheme ftcs: C_AD dx^2 exp(-200 nu)/dt is added to the diffusion of u and T"},
             s.continuum.artificial_dissipation, {0.0, 1.0});
    v.number({"diffusion_factor", "", "s of the scheme ftcs: its step is at most s n dx^2 over mu, lambda and kappa"},
             s.continuum.diffusion_factor, {0.0, 10.0, true});
}

/// What contacts do, in every kind of scene.
void describe_contacts(Particles& p, ParameterVisitor& v) {
    v.restitution(
        {"restitution", "",
         "a number e in [0, 1], or { law = \"velocity\", e0 = 0.7, v0 = 1 }: 1 - (1 - e0)(v/v0)^(3/4) below v0"},
        p.restitution);
    v.friction({"friction", "",
                "\"none\", or { law = \"walton\", beta0 = 0.35, mu = 0.5 }, or the law \"walton_without_spin\" (MD)"},
               p.friction);
    v.remedy({"collapse", "", "remedy of the MD against inelastic collapse: none, elastic_below or contact_time"},
             p.collapse);
    v.number({"collapse_speed", "sqrt(g sigma)", "elastic_below: contacts slower than this are elastic"},
             p.collapse_speed, positive);
    v.number({"collapse_time", "sqrt(sigma/g)",
              "contact_time: contacts that follow another of a partner sooner than this are elastic"},
             p.collapse_time, positive);
}

/// The names that every kind of MD run has.
void describe_md(Scene& s, ParameterVisitor& v) {
    v.section("md", "event-driven molecular dynamics");
    v.seed({"seed", "", "of positions and velocities at the start"}, s.md.seed);
    v.number({"shell", "sigma", "reach of a neighbour list beyond contact; 0: chosen from the density"}, s.md.shell,
             {0.0, 10.0});
    v.number({"contacts_between_sorts", "", "of each particle, before they are reordered in space; 0: the default"},
             s.md.contacts_between_sorts, {0.0, 1e9});
}

/// The two ends of a column of the continuum; `names` are what each may be.
void describe_ends(const std::array<std::string_view, 2>& names, Choice& lower, Choice& upper,
                   std::optional<double>& lower_temperature, std::optional<double>& upper_temperature,
                   ParameterVisitor& v) {
    v.choice({"lower", "", names[0]}, lower);
    v.choice({"upper", "", names[1]}, upper);
    v.optional_number({"lower_temperature", "g sigma", "of a heated lower end"}, lower_temperature, positive);
    v.optional_number({"upper_temperature", "g sigma", "of a heated upper end"}, upper_temperature, positive);
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
    describe_contacts(s.particles, v);

    v.section("box", "the cell: periodic in x and y");
    v.number({"x", "sigma", "width"}, s.box.x, widths);
    v.number({"y", "sigma", "width"}, s.box.y, widths);
    v.number({"ceiling", "sigma", "height of the ceiling of the MD, fixed in the lab"}, s.box.ceiling, widths);

    v.section("initial", "a flat layer on the plate");
    v.number({"volume_fraction", "", "of the layer at the start"}, s.initial.volume_fraction, packings);
    v.number({"temperature", "g sigma", "granular temperature at the start"}, s.initial.temperature, positive);
    v.number({"noise", "", "relative amplitude of random density noise (continuum)"}, s.initial.noise, {0.0, 0.5});
    v.number({"wave", "", "relative amplitude of one cosine wave of density (continuum)"}, s.initial.wave, {0.0, 0.5});
    v.whole({"wave_x", "", "its waves along the box's side x"}, s.initial.wave_x, {0.0, 10000.0});
    v.whole({"wave_y", "", "its waves along the box's side y"}, s.initial.wave_y, {0.0, 10000.0});
    v.seed({"seed", "", "of the random start"}, s.initial.seed);
    v.text({"file", "", "an earlier output to start from"}, s.initial.file);
    v.number({"phase", "", "ft of the state in that file which a run starts from and at, a sample instant"},
             s.initial.phase, {0.0, 1.0});

    v.section("sample", "when and how fields are measured");
    v.whole({"phases", "", "sample instants a cycle, a multiple of 20"}, s.sample.phases, {20.0, 100000.0});
    v.whole({"settle", "cycles", "before averaging begins"}, s.sample.settle, {0.0, 1e9});
    v.whole({"average", "cycles", "to average over"}, s.sample.average, counts);
    v.number({"bin", "sigma", "height of a bin of the profiles"}, s.sample.bin, {0.01, 100.0});
    v.whole({"frames", "", "whole states kept of the last cycle, at equal phases; a divisor of phases, 0 for none"},
            s.sample.frames, {0.0, 100000.0});
    v.whole({"frame_cycles", "", "how many cycles at the end keep them; two show a pattern at half the frequency"},
            s.sample.frame_cycles, {1.0, 1000.0});
    v.whole({"maps", "", "maps of z_cm(x, y) kept of every cycle, at equal phases; a divisor of phases"}, s.sample.maps,
            {1.0, 100000.0});
    v.number({"map_bin", "sigma", "width of a bin of these maps; 0: no maps are kept"}, s.sample.map_bin,
             {0.0, 1000.0});

    describe_md(s, v);
    v.whole({"frames_per_cycle", "", "how often the moving frame follows the layer; 0: the default"},
            s.md.frames_per_cycle, {0.0, 10000.0});

    describe_continuum_choices(s, v);
    v.choice({"dimension", "", "\"auto\", 1, 2 or 3"}, s.continuum.dimension);
    v.optional_number({"restitution", "", "a constant in place of the scene's law"}, s.continuum.restitution,
                      fractions);
    v.number({"spacing", "sigma", "vertical grid spacing; the nearest that divides the height"}, s.continuum.spacing,
             {1e-4, 10.0});
    v.number({"spacing_horizontal", "sigma", "horizontal grid spacing; the nearest that divides a side"},
             s.continuum.spacing_horizontal, {1e-3, 1e6});
    v.number({"lid", "sigma", "height of the upper end above the plate, with which it moves"}, s.continuum.lid,
             {2.0, 1e6});
    describe_ends({"plate, or heated: a plate that gives and takes heat",
                   "stress_free, lid or heated; without: stress_free, with scheme ftcs lid"},
                  s.continuum.lower, s.continuum.upper, s.continuum.lower_temperature, s.continuum.upper_temperature,
                  v);
    v.number({"cfl", "", "Courant number of the acoustic step (muscl, weno5)"}, s.continuum.cfl, {0.0, 1.0, true});
    describe_finite_differences(s, v);
    v.number({"floor_density", "",
              "least density at the start, under ftcs at all times (1e-3 by default, and no less), relative to the "
              "mean density N/(x y lid)"},
             s.continuum.floor_density, {0.0, 0.1, true});
    v.number({"floor_temperature", "g sigma", "least temperature"}, s.continuum.floor_temperature, {0.0, 1.0, true});
}

/// A homogeneous gas in a periodic cube, without gravity: what hard-sphere theory knows most about.
void describe_uniform(Scene& s, ParameterVisitor& v) {
    v.section("particles", "spheres of diameter 1 and mass 1");
    v.optional_whole({"number", "", "how many, N; or give box.side"}, s.particles.number, counts);
    describe_contacts(s.particles, v);

    v.section("box", "a cube, periodic in three directions");
    v.optional_number({"side", "sigma", "of the cube, (pi N/(6 nu))^(1/3); or give particles.number"}, s.uniform.side,
                      widths);

    v.section("initial", "a homogeneous gas at rest as a whole");
    v.number({"volume_fraction", "", "of the gas, nu"}, s.initial.volume_fraction, packings);
    v.number({"temperature", "g sigma", "granular temperature at the start"}, s.initial.temperature, positive);
    v.seed({"seed", "", "of the random start"}, s.initial.seed);
    v.text({"file", "", "an earlier output of the MD to start from"}, s.initial.file);

    v.section("sample", "when the gas is measured");
    v.number({"interval", "sqrt(sigma/g)", "between sample instants"}, s.uniform.interval, positive);
    v.number({"settle", "sqrt(sigma/g)", "time before averaging, whole intervals"}, s.uniform.settle, at_least_zero);
    v.number({"duration", "sqrt(sigma/g)", "time averaged over, whole intervals"}, s.uniform.duration, positive);
    v.whole({"frames", "", "whole states kept of the time averaged over, the last at its end; 0: none"},
            s.uniform.frames, {0.0, 100000.0});

    describe_md(s, v);

    describe_continuum_choices(s, v);
    v.optional_number({"restitution", "", "a constant in place of the scene's law"}, s.continuum.restitution,
                      fractions);
}

void describe_gas(GasState& gas, ParameterVisitor& v) {
    v.number({"volume_fraction", "", "of the gas"}, gas.volume_fraction, {0.0, 0.649, true});
    v.number({"velocity", "sqrt(g sigma)", "of the gas, upwards"}, gas.velocity, any_number);
    v.number({"temperature", "g sigma", "granular temperature"}, gas.temperature, positive);
}

/// A column of gas that starts from a state with a known future.
void describe_tube(Scene& s, ParameterVisitor& v) {
    v.section("tube", "a column of gas whose exact solution is known");
    v.number({"length", "sigma", "of the tube"}, s.tube.length, positive);
    v.number({"time", "sqrt(sigma/g)", "how long it is followed"}, s.tube.time, positive);
    v.number({"restitution", "", "constant e"}, s.tube.restitution, fractions);
    switch (s.kind) {
        case Kind::riemann:
            describe_ends({"open, wall, periodic, heated or piston", "open, wall, periodic or heated"}, s.tube.lower,
                          s.tube.upper, s.tube.lower_temperature, s.tube.upper_temperature, v);
            v.number({"speed", "sqrt(g sigma)", "of a piston as the lower end, with which the frame moves"},
                     s.tube.speed, positive);
            v.section("initial.left", "the gas below the middle");
            describe_gas(s.tube.left, v);
            v.section("initial.right", "the gas above the middle");
            describe_gas(s.tube.right, v);
            break;
        case Kind::piston:
            v.number({"speed", "sqrt(g sigma)", "of the piston, the lower end, into gas at rest"}, s.tube.speed,
                     positive);
            v.section("initial", "the gas at rest before the piston");
            v.number({"volume_fraction", "", "of the gas"}, s.tube.gas.volume_fraction, {0.0, 0.649, true});
            v.number({"temperature", "g sigma", "granular temperature"}, s.tube.gas.temperature, positive);
            break;
        case Kind::column:
            v.optional_number({"wall_temperature", "g sigma", "of a heated bottom; without: none, and e must be 1"},
                              s.tube.wall_temperature, positive);
            v.section("initial", "gas at rest under gravity");
            v.number({"volume_fraction", "", "at the bottom (without a heated bottom)"}, s.tube.gas.volume_fraction,
                     {0.0, 0.649, true});
            v.number({"temperature", "g sigma", "granular temperature"}, s.tube.gas.temperature, positive);
            v.number({"number_per_area", "1/sigma^2", "particles on a heated bottom"}, s.tube.number_per_area,
                     positive);
            break;
        case Kind::wave:
            v.section("initial", "gas with a wave of sound of one wavelength");
            v.number({"volume_fraction", "", "of the gas"}, s.tube.gas.volume_fraction, {0.0, 0.649, true});
            v.number({"temperature", "g sigma", "granular temperature"}, s.tube.gas.temperature, positive);
            v.number({"amplitude", "", "of the density, relative"}, s.tube.amplitude, {0.0, 0.1, true});
            break;
        case Kind::cooling_flow:
            v.section("initial", "dilute gas of one density on a wall, warmest there, with a free surface at T = 0");
            v.number({"volume_fraction", "", "of the gas"}, s.tube.gas.volume_fraction, {0.0, 0.1, true});
            v.number({"temperature", "g sigma", "granular temperature at the wall"}, s.tube.gas.temperature, positive);
            break;
        case Kind::layer:
        case Kind::uniform:
            break;
    }
    describe_continuum_choices(s, v);
    v.number({"spacing", "sigma", "grid spacing"}, s.continuum.spacing, positive);
    v.number({"cfl", "", "Courant number of the acoustic step (muscl, weno5)"}, s.continuum.cfl, {0.0, 1.0, true});
    describe_finite_differences(s, v);
}

}  // namespace

void describe(Scene& s, ParameterVisitor& v) {
    v.section("scene", "what is computed");
    v.text({"name", "", "of the scene, in outputs and figures"}, s.name);
    v.kind({"kind", "", "what is simulated"}, s.kind);
    switch (s.kind) {
        case Kind::layer:
            describe_layer(s, v);
            break;
        case Kind::uniform:
            describe_uniform(s, v);
            break;
        case Kind::riemann:
        case Kind::piston:
        case Kind::column:
        case Kind::wave:
        case Kind::cooling_flow:
            describe_tube(s, v);
            break;
    }
}

}  // namespace shaken::scene
