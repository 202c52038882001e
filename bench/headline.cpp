// SPDX-License-Identifier: MIT
// The cell of Bougie 2004, section 3.2.8: 42 x 42, depth 5.4, Gamma 2.2, f* 0.4174, e0 0.7, at dx = dy = 2 and dz =
// 0.2.
//   headline time  [--dz 0.2 --dx 2 --lid 25 --cycles 10 --scheme muscl --closure jenkins_richman --cfl 0.8
//   --gamma 2.2]   ten cycles of the cell, timed headline wave  [the same]   a wave of length 21 and amplitude 1/2 on a
//   strip of that grid, three cycles
// A flat layer has no error in z_cm(x, y), so `wave` lifts and lowers a settled layer in flight by cos(2 pi x/21)/2 and
// prints the amplitude of that mode of z_cm at 20 phases a cycle, as one line of JSON. The wave varies along x only,
// and so a strip (two dimensions) has the errors of the cell.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "continuum/initial_state.hpp"
#include "continuum/method.hpp"

using namespace shaken;
using namespace shaken::continuum;

namespace {

struct Options {
    double dx = 2.0, dz = 0.2, lid = 25.0, cfl = 0.8;
    double box = 42.0;
    int cycles = 0;
    std::string scheme = "muscl", closure = "jenkins_richman";
    double gamma = 2.2;
};

scene::Scene cell(const Options& o) {
    scene::Scene scene;
    scene.box.x = scene.box.y = o.box;
    scene.number_of_particles = std::llround(6.0 * o.box * o.box);
    scene.depth = 5.4;
    scene.motion = scene::PlateMotion::from_acceleration(o.gamma, 0.4174 / std::sqrt(5.4));
    scene.particles.restitution = scene::RestitutionVelocity{0.7, 1.0};
    scene.continuum.spacing = o.dz;
    scene.continuum.spacing_horizontal = o.dx;
    scene.continuum.lid = o.lid;
    scene.continuum.cfl = o.cfl;
    scene.continuum.scheme.name = o.scheme;
    scene.continuum.closure.name = o.closure;
    return scene;
}

constexpr int phases = 20;
constexpr int settled = 6;        // cycles of one column
constexpr int seeded_phase = 12;  // ft = 0.6: in flight

/// From sample instant to sample instant, in equal steps, as the solver does.
void advance(Method& evolution, double period, int from, int to) {
    for (int phase = from; phase < to; ++phase) {
        const double start = period * (phase % phases) / phases, interval = period / phases;
        for (double done = 0.0; done < interval;) {
            const double left = interval - done, pieces = std::ceil(left / evolution.longest_step() * (1.0 - 1e-12));
            evolution.step(start + done, left / pieces);
            done = pieces <= 1.0 ? interval : done + left / pieces;
        }
    }
}

constexpr double wavelength = 21.0, wanted_amplitude = 0.5;

/// Amplitude of cos(2 pi x/21) in the height of the centre of mass.
double amplitude(const Grid& grid, const Flow& flow) {
    double sum = 0.0;
    for (std::int64_t c = 0; c < grid.columns(); ++c) {
        double mass = 0.0, moment = 0.0;
        for (std::int64_t i = 0; i < grid.nz; ++i) {
            const double n = flow.density[static_cast<std::size_t>(grid.first(c) + i)];
            mass += n;
            moment += n * grid.centre(i);
        }
        const double x = (static_cast<double>(c % grid.nx) + 0.5) * grid.dx;
        sum += moment / mass * std::cos(2.0 * std::numbers::pi * x / wavelength);
    }
    return 2.0 * sum / static_cast<double>(grid.columns());
}
double amplitude(const Method& evolution) { return amplitude(evolution.grid(), evolution.flow()); }

/// A settled column under each (x, y), lifted by lift cos(2 pi x/21), mass as before.
void lift_columns(const Method& column, double lift, Setup& setup) {
    const Grid& grid = setup.grid;
    const std::int64_t nz = grid.nz, source = column.grid().first(0);
    for (std::int64_t c = 0; c < grid.columns(); ++c) {
        const double x = (static_cast<double>(c % grid.nx) + 0.5) * grid.dx;
        const double shift = lift * std::cos(2.0 * std::numbers::pi * x / wavelength) / grid.dz;
        double before = 0.0, after = 0.0;
        for (std::int64_t i = 0; i < nz; ++i) {
            const double place = std::clamp(static_cast<double>(i) - shift, 0.0, static_cast<double>(nz - 1));
            const auto below = std::min<std::int64_t>(static_cast<std::int64_t>(place), nz - 2);
            const double part = place - static_cast<double>(below);
            const auto between = [&](const std::vector<double>& field) {
                const auto k = static_cast<std::size_t>(source + below);
                return (1.0 - part) * field[k] + part * field[k + 1];
            };
            const auto to = static_cast<std::size_t>(grid.first(c) + i);
            setup.flow.density[to] = between(column.flow().density);
            setup.flow.velocity_z[to] = between(column.flow().velocity_z);
            setup.flow.temperature[to] = between(column.flow().temperature);
            before += column.flow().density[static_cast<std::size_t>(source + i)];
            after += setup.flow.density[to];
        }
        for (std::int64_t i = 0; i < nz; ++i)
            setup.flow.density[static_cast<std::size_t>(grid.first(c) + i)] *= before / after;
    }
}

/// A layer in flight with a wave of half a diameter in z_cm. At ft = 0.6 its tail still stands on the plate, where
/// lifting it draws mass in and lowering it presses mass out: a lift of 0.5 moves z_cm by 0.35 only, so the lift is
/// raised until z_cm has the wanted wave.
Setup seeded(const scene::Scene& scene, int dimension) {
    scene::Scene one = scene;
    one.continuum.dimension.name = "1";
    // The finite differences settle to another flat layer; their wave is to start from the same.
    if (one.continuum.scheme.name == "ftcs") one.continuum.scheme.name = "muscl";
    const std::unique_ptr<Method> column = make_method(make_setup(one));
    advance(*column, scene.motion.period(), 0, settled * phases + seeded_phase);
    scene::Scene many = scene;
    many.continuum.dimension.name = std::to_string(dimension);
    Setup setup = make_setup(many);
    double lift = wanted_amplitude;
    for (int i = 0; i < 30; ++i) {
        lift_columns(*column, lift, setup);
        lift *= wanted_amplitude / amplitude(setup.grid, setup.flow);
    }
    return setup;
}

void print_wave(const Options& o) {
    const scene::Scene scene = cell(o);
    const std::unique_ptr<Method> method = make_method(seeded(scene, 2));
    const int cycles = o.cycles > 0 ? o.cycles : 3;
    std::string amplitudes = fmt::format("{:.6f}", amplitude(*method));
    for (int phase = seeded_phase; phase < seeded_phase + cycles * phases; ++phase) {
        advance(*method, scene.motion.period(), phase, phase + 1);
        amplitudes += fmt::format(", {:.6f}", amplitude(*method));
    }
    fmt::print(
        "{{\"dx\": {}, \"dz\": {}, \"lid\": {}, \"scheme\": \"{}\", \"cfl\": {}, \"steps\": {}, \"amplitude\": "
        "[{}]}}\n",
        o.dx, o.dz, o.lid, o.scheme, o.cfl, method->steps(), amplitudes);
}

void print_time(const Options& o) {
    const scene::Scene scene = cell(o);
    const std::unique_ptr<Method> method = make_method(seeded(scene, 3));
    const int cycles = o.cycles > 0 ? o.cycles : 10;
    const auto begin = std::chrono::steady_clock::now();
    const double cpu = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    advance(*method, scene.motion.period(), seeded_phase, seeded_phase + cycles * phases);
    fmt::print(
        "{{\"cells\": {}, \"cycles\": {}, \"steps\": {}, \"threads\": {}, \"wall_seconds\": {:.2f}, \"cpu_seconds\": "
        "{:.2f}, "
        "\"amplitude\": {:.5f}}}\n",
        method->grid().cells(), cycles, method->steps(), omp_get_max_threads(),
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
        static_cast<double>(std::clock()) / CLOCKS_PER_SEC - cpu, amplitude(*method));
}

}  // namespace

int main(int argc, char** argv) {
    Options o;
    std::map<std::string, double*> numbers{{"--dx", &o.dx},   {"--dz", &o.dz},       {"--lid", &o.lid},
                                           {"--cfl", &o.cfl}, {"--gamma", &o.gamma}, {"--box", &o.box}};
    const std::string what = argc > 1 ? argv[1] : "";
    for (int i = 2; i + 1 < argc; i += 2) {
        const std::string key = argv[i];
        if (const auto found = numbers.find(key); found != numbers.end())
            *found->second = std::atof(argv[i + 1]);
        else if (key == "--cycles")
            o.cycles = std::atoi(argv[i + 1]);
        else if (key == "--scheme")
            o.scheme = argv[i + 1];
        else if (key == "--closure")
            o.closure = argv[i + 1];
        else
            return fmt::print(stderr, "headline: unknown option {}\n", key), 2;
    }
    if (what == "time") return print_time(o), 0;
    if (what == "wave") return print_wave(o), 0;
    return fmt::print(
               stderr,
               "usage: headline time|wave [--dx --dz --lid --box --cfl --cycles --scheme --closure --gamma VALUE]\n"),
           2;
}
