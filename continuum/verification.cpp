// SPDX-License-Identifier: MIT
#include "continuum/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "continuum/advance.hpp"
#include "continuum/boundary/named.hpp"
#include "continuum/closures/closures.hpp"
#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/closures/equation_of_state.hpp"
#include "continuum/exact/cooling_flow.hpp"
#include "continuum/exact/gas.hpp"
#include "continuum/exact/heated_layer.hpp"
#include "continuum/exact/riemann.hpp"
#include "continuum/kernels.hpp"
#include "continuum/method.hpp"
#include "continuum/resolve.hpp"
#include "scene/errors.hpp"

namespace shaken::continuum {

namespace {

using scene::GasState;
using scene::Kind;

EquationOfState state_of(const scene::Scene& scene) {
    return make_equation_of_state(scene.continuum.pair_correlation, scene.tube.restitution);
}

Setup empty_tube(const scene::Scene& scene) {
    Grid grid;
    grid.nz = std::llround(scene.tube.length / scene.continuum.spacing);
    grid.dz = scene.tube.length / static_cast<double>(grid.nz);
    Setup setup(grid);
    setup.choices = scene.continuum;
    setup.restitution = scene.tube.restitution;
    setup.sink = scene::RestitutionConstant{scene.tube.restitution};
    return setup;
}

void put(Setup& setup, std::int64_t cell, const GasState& gas) {
    const auto i = static_cast<std::size_t>(setup.grid.first(0) + cell);
    setup.flow.density[i] = gas.volume_fraction / sphere_volume;
    setup.flow.velocity_z[i] = gas.velocity;
    setup.flow.temperature[i] = gas.temperature;
}

double duration_of(const scene::Scene& scene) {
    return scene.kind == Kind::uniform ? scene.uniform.settle + scene.uniform.duration : scene.tube.time;
}

/// A case: how it starts, and what is known of its end.
struct Case {
    Setup setup;
    std::vector<GasState> exact;  // at the middles of the cells; empty where there is none
    std::string why_no_exact;
};

/// Whether the flow obeys Euler's equations; if not, says what keeps it from them.
std::string departure_from_euler(const scene::Scene& scene) {
    if (scene.continuum.transport.name != "inviscid")
        return "the exact solution has continuum.transport = \"inviscid\"";
    if (scene.tube.restitution < 1.0) return "the exact solution has tube.restitution = 1";
    return "";
}

/// The volume fraction at which the pressure is 4 % above n T: what is exact for a dilute gas is so to a few per cent.
constexpr double most_dilute = 0.01;

/// Whether the gas is thin enough for exact solutions of a dilute one; if not, says so.
std::string departure_from_dilute(const std::vector<double>& volume_fractions) {
    const double densest = *std::max_element(volume_fractions.begin(), volume_fractions.end());
    if (densest <= most_dilute) return "";
    return fmt::format("the exact solution is of a dilute gas, and the volume fraction reaches {:.3g} (at most {})",
                       densest, most_dilute);
}

/// The exact solution; where there is none, says why and leaves the case without.
std::optional<exact::Riemann> solve_exactly(const GasState& left, const GasState& right, const scene::Scene& scene,
                                            Case& c) {
    try {
        return exact::Riemann(left, right, state_of(scene));
    } catch (const std::domain_error& none) {
        c.why_no_exact = none.what();
        return std::nullopt;
    }
}

Case riemann(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, departure_from_euler(scene)};
    Setup& setup = c.setup;
    setup.boundaries = boundaries_of_tube(scene.tube);
    const bool piston = scene.tube.lower.name == "piston";
    GasState left = scene.tube.left, right = scene.tube.right;  // in the frame of the lower end
    for (GasState* gas : {&left, &right}) gas->velocity -= piston ? scene.tube.speed : 0.0;
    const double middle = 0.5 * scene.tube.length;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i) put(setup, i, setup.grid.centre(i) < middle ? left : right);
    if (piston) c.why_no_exact = "the piston sends a wave of its own (the kind piston knows it)";
    if (!c.why_no_exact.empty()) return c;
    const std::optional<exact::Riemann> solution = solve_exactly(left, right, scene, c);
    if (!solution) return c;
    const double reach = 0.5 * scene.tube.length / scene.tube.time;
    const GasState below = solution->at(-reach), above = solution->at(reach);
    if (below.volume_fraction != left.volume_fraction || above.volume_fraction != right.volume_fraction)
        c.why_no_exact = "a wave has reached an end of the tube";
    for (std::int64_t i = 0; i < setup.grid.nz; ++i)
        c.exact.push_back(solution->at((setup.grid.centre(i) - middle) / scene.tube.time));
    return c;
}

Case piston(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, departure_from_euler(scene)};
    Setup& setup = c.setup;
    setup.boundaries.upper.end = End::open;
    GasState gas = scene.tube.gas;  // in the frame of the piston
    gas.velocity = -scene.tube.speed;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i) put(setup, i, gas);
    if (!c.why_no_exact.empty()) return c;
    GasState image = gas;
    image.velocity = scene.tube.speed;
    const std::optional<exact::Riemann> solution = solve_exactly(image, gas, scene, c);
    if (!solution) return c;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i)
        c.exact.push_back(solution->at(setup.grid.centre(i) / scene.tube.time));
    return c;
}

Case column(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, ""};
    Setup& setup = c.setup;
    setup.gravity = 1.0;
    const EquationOfState state = state_of(scene);
    const double t = scene.tube.gas.temperature;
    if (!scene.tube.wall_temperature) {
        for (std::int64_t i = 0; i < setup.grid.nz; ++i) {
            c.exact.push_back({exact::isothermal_volume_fraction(state, scene.tube.gas.volume_fraction, t,
                                                                 setup.grid.centre(i), 20 * (1 + static_cast<int>(i))),
                               0.0, t});
            put(setup, i, c.exact.back());
        }
        if (scene.tube.restitution < 1.0) c.why_no_exact = "the exact column has tube.restitution = 1";
        return c;
    }
    const double heat = *scene.tube.wall_temperature, number = scene.tube.number_per_area;
    setup.boundaries.lower.temperature = heat;
    const double lightest = scene::exponential(-scene.tube.length / t);
    for (std::int64_t i = 0; i < setup.grid.nz; ++i) {
        const double from = scene::exponential(-setup.grid.dz * static_cast<double>(i) / t);
        const double to = scene::exponential(-setup.grid.dz * static_cast<double>(i + 1) / t);
        put(setup, i, {sphere_volume * number * (from - to) / (setup.grid.dz * (1.0 - lightest)), 0.0, t});
    }
    c.why_no_exact = "the exact temperature is a function of the weight above";
    return c;
}

Case wave(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, ""};
    Setup& setup = c.setup;
    setup.boundaries.lower.end = setup.boundaries.upper.end = End::periodic;
    const EquationOfState state = state_of(scene);
    const GasState gas = scene.tube.gas;
    const double speed = state.sound_speed(gas.volume_fraction, gas.temperature);
    const double chi = state.pressure(gas.volume_fraction, 1.0) * sphere_volume / gas.volume_fraction;
    for (std::int64_t i = 0; i < setup.grid.nz; ++i) {
        const double crest =
            scene.tube.amplitude * scene::sine_cosine_of_turns(setup.grid.centre(i) / scene.tube.length).cosine;
        put(setup, i,
            {gas.volume_fraction * (1.0 + crest), speed * crest, gas.temperature * (1.0 + 2.0 / 3.0 * chi * crest)});
    }
    c.why_no_exact = "the wave is compared by its speed and damping";
    return c;
}

/// A gas that only cools: any column of it, without ends. Haff's law where e is constant.
Case uniform(const scene::Scene& scene) {
    constexpr std::int64_t cells = 16;
    const double side = scene.box.x;
    Grid grid;
    grid.nz = cells;
    grid.dz = side / static_cast<double>(cells);
    Case c{Setup(grid), {}, ""};
    c.setup.choices = scene.continuum;
    c.setup.sink = sink_restitution(scene);
    c.setup.restitution = pressure_restitution(scene);
    c.setup.boundaries.lower.end = c.setup.boundaries.upper.end = End::periodic;
    const GasState gas{scene.initial.volume_fraction, 0.0, scene.initial.temperature};
    if (const double packing = choose_kernels(scene.continuum).packing; gas.volume_fraction >= packing)
        throw scene::SceneError({}, fmt::format("initial.volume_fraction = {} is not below {}, where {} packs",
                                                gas.volume_fraction, packing, scene.continuum.pair_correlation.name));
    for (std::int64_t i = 0; i < cells; ++i) put(c.setup, i, gas);
    const EquationOfState elastic = make_equation_of_state(scene.continuum.pair_correlation, 1.0);
    const double chi = elastic.pressure(gas.volume_fraction, 1.0) * sphere_volume / gas.volume_fraction;
    // G, from chi = 1 + 4 G; Garzo and Dufty's sink is that of their non-Maxwellian gas.
    const double cooling_share = scene.continuum.closure.name == GarzoDufty::name
                                     ? 1.0 + (3.0 / 32.0) * GarzoDufty::cumulant(c.setup.restitution)
                                     : 1.0;
    const double contact_rate = cooling_share * 0.25 * (chi - 1.0);
    c.exact.assign(cells, {gas.volume_fraction, 0.0,
                           exact::cooled_temperature(gas.temperature, c.setup.sink, contact_rate, duration_of(scene))});
    return c;
}

Case cooling_flow(const scene::Scene& scene) {
    Case c{empty_tube(scene), {}, ""};
    if (scene.tube.restitution == 1.0)
        throw scene::SceneError({}, "tube.restitution = 1: a gas that does not cool has no cooling flow");
    const exact::CoolingFlow flow(scene.tube.gas, scene.tube.restitution);
    if (scene.tube.time >= flow.longest_time())
        throw scene::SceneError({}, fmt::format("tube.time = {} is not below {:.6g}, when the density diverges",
                                                scene.tube.time, flow.longest_time()));
    if (scene.tube.length < flow.surface(0.0))
        throw scene::SceneError({}, fmt::format("tube.length = {} does not hold the warm gas, {:.6g} high",
                                                scene.tube.length, flow.surface(0.0)));
    c.setup.boundaries.lower.end = End::wall;
    c.setup.boundaries.upper.end = End::open;
    // Above the surface there should be nothing; so little does nothing to the flow below.
    constexpr double nothing = 1e-9;
    c.setup.floor_temperature = nothing * scene.tube.gas.temperature;
    for (std::int64_t i = 0; i < c.setup.grid.nz; ++i) {
        GasState gas = flow.at(c.setup.grid.centre(i), 0.0);
        gas.volume_fraction = std::max(gas.volume_fraction, nothing * scene.tube.gas.volume_fraction);
        gas.temperature = std::max(gas.temperature, c.setup.floor_temperature);
        put(c.setup, i, gas);
        c.exact.push_back(flow.at(c.setup.grid.centre(i), scene.tube.time));
    }
    std::vector<double> volume_fractions;
    for (const GasState& gas : c.exact) volume_fractions.push_back(gas.volume_fraction);
    c.why_no_exact = departure_from_dilute(volume_fractions);
    if (scene.continuum.transport.name != "inviscid")
        c.why_no_exact = "the exact solution has continuum.transport = \"inviscid\"";
    else if (scene.continuum.closure.name == GarzoDufty::name)
        c.why_no_exact = "the exact solution cools as a Maxwellian gas, and garzo_dufty does not";
    return c;
}

Case make_case(const scene::Scene& scene) {
    switch (scene.kind) {
        case Kind::riemann:
            return riemann(scene);
        case Kind::piston:
            return piston(scene);
        case Kind::column:
            return column(scene);
        case Kind::wave:
            return wave(scene);
        case Kind::cooling_flow:
            return cooling_flow(scene);
        case Kind::uniform:
            return uniform(scene);
        default:
            throw std::invalid_argument("continuum: this kind of scene has no exact solution");
    }
}

struct Inside {
    std::vector<double> volume_fraction, velocity, temperature;
};
Inside inside(const Method& method) {
    Inside r;
    for (std::int64_t k = 0; k < method.grid().nz; ++k) {
        const auto i = static_cast<std::size_t>(method.grid().first(0) + k);
        r.volume_fraction.push_back(sphere_volume * method.flow().density[i]);
        r.velocity.push_back(method.flow().velocity_z[i]);
        r.temperature.push_back(method.flow().temperature[i]);
    }
    return r;
}

/// Amplitude of one wavelength over the tube.
std::complex<double> mode(const std::vector<double>& field) {
    std::complex<double> sum = 0.0;
    const double cells = static_cast<double>(field.size());
    for (std::size_t i = 0; i < field.size(); ++i)
        sum += field[i] * std::polar(1.0, -2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / cells);
    return sum * (2.0 / cells);
}

/// Where there is no gas there is neither velocity nor temperature to compare.
double mean_difference(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& gas,
                       bool relative) {
    double difference = 0.0, size = 0.0, cells = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (gas[i] == 0.0) continue;
        difference += std::abs(a[i] - b[i]);
        size += std::abs(b[i]);
        cells += 1.0;
    }
    return difference / (relative ? size : cells);
}

using AskedToStop = std::function<bool()>;

/// False where it was asked to stop on the way.
bool check_wave(const scene::Scene& scene, Method& method, double shortest, const AskedToStop& asked_to_stop,
                Verification& v) {
    const EquationOfState state = state_of(scene);
    const double nu = scene.tube.gas.volume_fraction, temperature = scene.tube.gas.temperature;
    const double k = 2.0 * std::numbers::pi / scene.tube.length;
    const double speed = state.sound_speed(nu, temperature);
    const std::string why_no_exact = scene.tube.restitution < 1.0 ? "the exact wave has tube.restitution = 1" : "";
    const Transport transport = choose(Closures{}, "continuum.closure", scene.continuum.closure, [&](auto closure) {
        return choose(
            PairCorrelations{}, "continuum.pair_correlation", scene.continuum.pair_correlation, [&](auto pair) {
                return decltype(closure)::template transport<decltype(pair)>(nu / sphere_volume, temperature, 1.0);
            });
    });
    const double damping =
        scene.continuum.transport.name == "inviscid"
            ? 0.0
            : exact::sound_attenuation(nu / sphere_volume, transport, state.specific_heat_at_constant_pressure(nu));
    // The wave starts with the eigenvector of an undamped one; what is left of it as two others is gone or small after
    // a third of the time, and over a whole number of periods a wave the other way leaves no trace in the mean.
    const double period = scene.tube.length / speed;
    const double begin = std::max(1.0, std::round(scene.tube.time / (3.0 * period))) * period;
    const double end = begin + std::max(1.0, std::round((scene.tube.time - begin) / period)) * period;
    if (!advance(method, 0.0, begin, shortest, asked_to_stop)) return false;
    const std::complex<double> first = mode(inside(method).volume_fraction);
    constexpr int looks = 16;
    double turned = 0.0;
    std::complex<double> last = first;
    const int parts = looks * static_cast<int>(std::llround((end - begin) / period));
    for (int i = 1; i <= parts; ++i) {
        const double from = begin + (end - begin) * (i - 1) / parts, to = begin + (end - begin) * i / parts;
        if (!advance(method, from, to, shortest, asked_to_stop)) return false;
        const std::complex<double> now = mode(inside(method).volume_fraction);
        turned -= std::arg(now / last);
        last = now;
    }
    v.numbers.push_back({"sound_speed", turned / (k * (end - begin)), speed, why_no_exact});
    v.numbers.push_back(
        {"attenuation", -std::log(std::abs(last / first)) / (k * k * (end - begin)), damping, why_no_exact});
    return true;
}

/// What the closure of the scene becomes where the gas is so thin that n and T enter by their powers alone; nothing for
/// one that does not.
std::optional<exact::DiluteGas> dilute_gas(const scene::Scene& scene) {
    if (scene.continuum.closure.name == JenkinsRichmanDense::name) return std::nullopt;
    constexpr double density = 1e-12;
    const double e = scene.tube.restitution;
    return choose(Closures{}, "continuum.closure", scene.continuum.closure, [&](auto closure) {
        const Transport t = decltype(closure)::template transport<Goldshtein>(density, 1.0, e);
        const double rate = decltype(closure)::template cooling_rate<Goldshtein>(density, e);
        return std::optional<exact::DiluteGas>(
            {t.conductivity, density * t.density_conductivity, 1.5 * rate / density * (1.0 - e * e)});
    });
}

void check_heated(const scene::Scene& scene, const Method& method, Verification& v) {
    if (!scene.tube.wall_temperature) return;
    const Inside now = inside(method);
    const double heat = *scene.tube.wall_temperature;
    const std::optional<exact::DiluteGas> gas = dilute_gas(scene);
    std::string why_no_exact = departure_from_dilute(now.volume_fraction);
    if (scene.continuum.transport.name == "inviscid")
        why_no_exact = "the exact layer has continuum.transport = \"navier_stokes\"";
    else if (!gas)
        why_no_exact = "the exact layer has the conductivity of a dilute gas, which " + scene.continuum.closure.name +
                       " leaves out";
    if (!why_no_exact.empty()) {
        v.numbers.push_back({"top_temperature/bottom_temperature", now.temperature.back() / heat, 0.0, why_no_exact});
        return;
    }
    // The pressure, which at a lid is not yet zero.
    const double cell = method.grid().dz / sphere_volume;
    double above =
        now.volume_fraction.back() / sphere_volume * now.temperature.back() - 0.5 * now.volume_fraction.back() * cell;
    for (double nu : now.volume_fraction) above += nu * cell;
    const double all = above;
    double worst = 0.0, known = 0.0;
    for (std::size_t i = 0; i < now.temperature.size(); ++i) {
        const double weight = above - 0.5 * now.volume_fraction[i] * cell;
        above -= now.volume_fraction[i] * cell;
        known = exact::heated_layer_temperature(heat, all, *gas, weight);
        if (weight > 1e-3 * all) worst = std::max(worst, std::abs(now.temperature[i] / known - 1.0));
    }
    v.numbers.push_back({"top_temperature/bottom_temperature", now.temperature.back() / heat, known / heat});
    v.numbers.push_back({"largest_error_of_temperature", worst, 0.0});
}

}  // namespace

void refuse_unverifiable(const scene::Scene& scene) { make_method(make_case(resolve(scene)).setup); }

Verification verify(const scene::Scene& scene) { return *verify_unless({}, scene); }

std::optional<Verification> verify_unless(const std::function<bool()>& asked_to_stop, const scene::Scene& given) {
    const scene::Scene scene = resolve(given);
    Case c = make_case(scene);
    Verification v;
    v.why_no_exact = c.why_no_exact;
    const std::unique_ptr<Method> method = make_method(std::move(c.setup));
    // No flow with a known future ever asks for steps so far below its first.
    const double shortest = 1e-6 * std::min(method->longest_step(), duration_of(scene));
    const bool reached = scene.kind == Kind::wave ? check_wave(scene, *method, shortest, asked_to_stop, v)
                                                  : advance(*method, 0.0, duration_of(scene), shortest, asked_to_stop);
    if (!reached) return std::nullopt;
    if (scene.kind == Kind::column) check_heated(scene, *method, v);
    for (std::int64_t i = 0; i < method->grid().nz; ++i) v.height.push_back(method->grid().centre(i));
    const Inside now = inside(*method);
    v.volume_fraction = now.volume_fraction;
    v.velocity = now.velocity;
    v.temperature = now.temperature;
    v.steps = method->steps();
    v.volume_fraction_error = v.velocity_error = v.temperature_error = std::numeric_limits<double>::quiet_NaN();
    if (!v.why_no_exact.empty()) return v;
    for (const GasState& gas : c.exact) {
        v.exact_volume_fraction.push_back(gas.volume_fraction);
        v.exact_velocity.push_back(gas.velocity);
        v.exact_temperature.push_back(gas.temperature);
    }
    v.volume_fraction_error =
        mean_difference(v.volume_fraction, v.exact_volume_fraction, v.exact_volume_fraction, true);
    v.velocity_error = mean_difference(v.velocity, v.exact_velocity, v.exact_volume_fraction, false);
    v.temperature_error = mean_difference(v.temperature, v.exact_temperature, v.exact_volume_fraction, true);
    return v;
}

}  // namespace shaken::continuum
