// SPDX-License-Identifier: MIT
#include "continuum/verification/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "continuum/closures/pressure.hpp"

namespace shaken::continuum {

using scene::GasState;

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
    return scene.kind == scene::Kind::uniform ? scene.uniform.settle + scene.uniform.duration : scene.tube.time;
}

std::string departure_from_euler(const scene::Scene& scene) {
    if (scene.continuum.transport.name != "inviscid")
        return "the exact solution has continuum.transport = \"inviscid\"";
    if (scene.tube.restitution < 1.0) return "the exact solution has tube.restitution = 1";
    return "";
}

namespace {

/// The volume fraction at which the pressure is 4 % above n T: what is exact for a dilute gas is so to a few per cent.
constexpr double most_dilute = 0.01;

}  // namespace

std::string departure_from_dilute(const std::vector<double>& volume_fractions) {
    const double densest = *std::max_element(volume_fractions.begin(), volume_fractions.end());
    if (densest <= most_dilute) return "";
    return fmt::format("the exact solution is of a dilute gas, and the volume fraction reaches {:.3g} (at most {})",
                       densest, most_dilute);
}

std::optional<exact::Riemann> solve_exactly(const GasState& left, const GasState& right, const scene::Scene& scene,
                                            Case& c) {
    try {
        return exact::Riemann(left, right, state_of(scene));
    } catch (const std::domain_error& none) {
        c.why_no_exact = none.what();
        return std::nullopt;
    }
}

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

}  // namespace shaken::continuum
