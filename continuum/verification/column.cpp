// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "continuum/closures/closures.hpp"
#include "continuum/exact/gas.hpp"
#include "continuum/exact/heated_layer.hpp"
#include "continuum/verification/case.hpp"

namespace shaken::continuum {

using scene::GasState;

Case column_case(const scene::Scene& scene) {
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

namespace {

/// What the closure of the scene becomes where the gas is so thin that n and T enter by their powers alone; nothing for
/// one that does not.
std::optional<exact::DiluteGas> dilute_gas(const scene::Scene& scene) {
    if (!traits_of(scene.continuum.closure).carries_between_contacts) return std::nullopt;
    constexpr double density = 1e-12;
    const double e = scene.tube.restitution;
    return choose(Closures{}, "continuum.closure", scene.continuum.closure, [&](auto closure) {
        const Transport t = decltype(closure)::template transport<Goldshtein>(density, 1.0, e);
        const double rate = decltype(closure)::template cooling_rate<Goldshtein>(density, e);
        return std::optional<exact::DiluteGas>(
            {t.conductivity, density * t.density_conductivity, 1.5 * rate / density * (1.0 - e * e)});
    });
}

}  // namespace

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

}  // namespace shaken::continuum
