// SPDX-License-Identifier: MIT
// An experiment as plain values: what a scene file says, resolved and checked, for both engines.
// Units everywhere: sphere diameter sigma = 1, particle mass m = 1, gravity g = 1.
#pragma once

#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "scene/friction.hpp"
#include "scene/key_owner.hpp"
#include "scene/plate_motion.hpp"
#include "scene/restitution.hpp"

namespace shaken::scene {

/// Where a value was written, so that whoever refuses it can point at it.
struct Place {
    std::string source;  // file name, "--set" or empty for a default
    int line = 0;
    int column = 0;
    std::string text;  // the line itself
};

/// A name chosen from a table that its owner keeps (a closure, a flux); the owner refuses it with its place.
struct Choice {
    std::string name;
    Place place;
};

enum class Kind { layer, uniform, riemann, piston, column, wave, cooling_flow };

struct Plate {
    double acceleration = 3.0;             // Gamma, peak acceleration over g
    std::optional<double> frequency;       // f, in sqrt(g/sigma)
    std::optional<double> frequency_star;  // f* = f sqrt(H)
};

struct Particles {
    std::optional<std::int64_t> number;
    std::optional<double> depth;  // H = 0.9 N / (Lx Ly), as poured
    Restitution restitution = RestitutionConstant{};
    Friction friction;
    CollapseRemedy collapse = CollapseRemedy::none;
    double collapse_speed = 0.01;  // of elastic_below
    double collapse_time = 1e-4;   // of contact_time
};

struct Box {
    double x = 20.0, y = 20.0;  // periodic
    double ceiling = 200.0;     // fixed in the lab frame
};

struct Initial {
    double volume_fraction = 0.3;
    double temperature = 1.0;
    double noise = 0.0;                   // relative amplitude of random density noise (continuum)
    double wave = 0.0;                    // relative amplitude of a cosine wave of density (continuum)
    std::int64_t wave_x = 1, wave_y = 0;  // its waves along each side of the box
    std::uint64_t seed = 1;
    std::string file;
    double phase = 0.0;  // ft of the state in the file that a run starts from and at

    /// Whether the continuum's start differs from column to column.
    bool uneven() const { return noise > 0.0 || wave > 0.0; }
};

/// Uniform gas, one side of a verification case.
struct GasState {
    double volume_fraction = 0.3;
    double velocity = 0.0;  // in sqrt(g sigma)
    double temperature = 1.0;
};

/// A column of gas with an exact solution (the kinds riemann, piston, column, wave and cooling_flow; continuum only).
struct Tube {
    double length = 10.0;                                        // in sigma
    double time = 1.0;                                           // in sqrt(sigma/g)
    double restitution = 1.0;                                    // constant e
    Choice lower{"open", {}}, upper{"open", {}};                 // ends (riemann)
    std::optional<double> lower_temperature, upper_temperature;  // of heated ends (riemann)
    GasState left{0.4, 0.0, 1.0}, right{0.05, 0.0, 1.0};         // riemann: below and above the middle
    GasState gas{0.3, 0.0, 1.0};             // piston, column and cooling_flow (at the bottom), wave
    double speed = 1.0;                      // of a piston, into the gas
    double amplitude = 1e-4;                 // of the wave, relative
    std::optional<double> wall_temperature;  // of a heated bottom (column)
    double number_per_area = 1.0;            // on a heated bottom (column)
};

/// A gas without gravity or walls, in a cube periodic in three directions (the kind uniform). Its sample instants lie
/// `interval` apart; that interval takes the place of a cycle in Scene::motion and Scene::sample.
struct Uniform {
    std::optional<double> side;  // of the cube, in sigma; or particles.number
    double settle = 10.0;        // time before averaging, in sqrt(sigma/g), as the others
    double duration = 100.0;     // time averaged over
    double interval = 1.0;       // between sample instants
    std::int64_t frames = 1;     // whole states kept of that time, the last at its end; 0: none
};

struct Sample {
    std::int64_t phases = 200;      // a cycle
    std::int64_t settle = 10;       // cycles before averaging
    std::int64_t average = 50;      // cycles averaged over
    double bin = 0.5;               // height of a bin, in sigma
    std::int64_t frames = 20;       // whole states kept of each of the last cycles, at equal phases; 0: none
    std::int64_t frame_cycles = 1;  // how many cycles at the end keep them
    std::int64_t maps = 4;          // maps of z_cm(x, y) kept of every cycle, at equal phases
    double map_bin = 0.0;           // width of their bins, in sigma; 0: no maps
};

struct Md {
    std::uint64_t seed = 1;
    // Knobs of the method, which change speed and round-off and never the statistics; 0: chosen by the engine.
    double shell = 0.0;                   // reach of a neighbour list beyond contact, in sigma
    std::int64_t frames_per_cycle = 0;    // how often the moving frame is made to follow the layer
    double contacts_between_sorts = 0.0;  // of each particle, before they are reordered in space
};

struct Continuum {
    Choice dimension{"auto", {}};
    Choice scheme{"muscl", {}};
    Choice flux{"hllc", {}};
    Choice limiter{"van_leer", {}};
    Choice closure{"jenkins_richman", {}};
    Choice pair_correlation{"goldshtein", {}};
    Choice transport{"navier_stokes", {}};
    std::optional<double> restitution;                    // a constant in place of the scene's law
    double spacing = 0.2;                                 // vertical, in sigma
    double spacing_horizontal = 2.0;                      // in sigma
    double lid = 80.0;                                    // height of the upper end above the plate, moving with it
    Choice lower{"plate", {}}, upper{"stress_free", {}};  // with scheme ftcs, where none is written: lid
    std::optional<double> lower_temperature, upper_temperature;  // of heated ends
    double cfl = 0.8;
    double artificial_dissipation = 0.1;  // C_AD of the scheme ftcs
    double diffusion_factor = 0.16;       // s of the scheme ftcs
    double floor_density = 1e-7;          // relative to the mean density N / (Lx Ly lid); 1e-3 with the scheme ftcs
    double floor_temperature = 1e-4;      // in g sigma
};

struct Scene {
    std::string name;
    Kind kind = Kind::layer;
    Plate plate;
    Particles particles;
    Box box;
    Initial initial;
    Tube tube;
    Uniform uniform;
    Sample sample;
    Md md;
    Continuum continuum;

    // What the values above imply; filled by the reader (scene/read_scene.hpp).
    PlateMotion motion;
    std::int64_t number_of_particles = 0;
    double depth = 0.0;  // H; 0 where there is no layer

    std::string source;                    // the file it was read from, or what stands for it in messages
    std::map<std::string, Place> written;  // "section.key" of what is no default, and where it was written
    std::set<std::string> without_part;    // "section.key" of what has no part in the run, and is not printed
    KeyOwners owners;                      // the engines whose keys it has

    double number_per_area() const { return static_cast<double>(number_of_particles) / (box.x * box.y); }
    /// Height in sigma of the flat layer that a run starts from.
    double thickness_at_start() const { return number_per_area() * (std::numbers::pi / 6.0) / initial.volume_fraction; }
};

}  // namespace shaken::scene
