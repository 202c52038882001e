// SPDX-License-Identifier: MIT
#include "continuum/advance.hpp"

#include <fmt/format.h>

#include <cmath>

#include "continuum/closures/pressure.hpp"
#include "continuum/errors.hpp"

namespace shaken::continuum {

namespace {

constexpr std::int64_t steps_between_looks = 100;

/// The fastest, the hottest and the densest cell, of which one asks for the shortest step.
std::string extremes(const Method& method) {
    const Grid& grid = method.grid();
    const Flow& flow = method.flow();
    struct Extreme {
        double value = -1.0;
        std::int64_t column = 0, iz = 0;
    } fastest, hottest, densest;
    for (std::int64_t column = 0; column < grid.columns(); ++column)
        for (std::int64_t iz = 0; iz < grid.nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid.first(column) + iz);
            const auto take = [&](Extreme& most, double value) {
                if (!std::isnan(most.value) && !(value <= most.value)) most = {value, column, iz};
            };
            take(fastest, std::hypot(flow.velocity_x[i], flow.velocity_y[i], flow.velocity_z[i]));
            take(hottest, flow.temperature[i]);
            take(densest, sphere_volume * flow.density[i]);
        }
    const auto place = [&](const Extreme& at) {
        return fmt::format("{:.4g} at height {:.4g} of column ({}, {})", at.value, grid.centre(at.iz),
                           at.column % grid.nx, at.column / grid.nx);
    };
    return fmt::format("the fastest flow is {}, the highest temperature {}, the largest volume fraction {}",
                       place(fastest), place(hottest), place(densest));
}

void refuse_unsound(const Method& method, double t) {
    const double held = method.mass_share_at_temperature_floor();
    if (!(held <= most_mass_at_floor))
        throw RunFailed(
            fmt::format("continuum: at time {:.6g} in the cycle {:.0f} % of the mass is held at the temperature floor "
                        "{:.3g} (at most {:.0f} % is allowed): the gas has frozen; lower continuum.floor_temperature, "
                        "or raise the restitution; {}",
                        t, 100.0 * held, method.floor_temperature(), 100.0 * most_mass_at_floor, extremes(method)),
            t);
    const Drift made = method.drift();
    if (!(std::abs(made.mass) <= most_mass_made))
        throw RunFailed(
            fmt::format(
                "continuum: at time {:.6g} in the cycle the method has made {:.3g} % of the mass (at most {:.0f} % is "
                "allowed): its differences do not resolve the flow; {}",
                t, 100.0 * made.mass, 100.0 * most_mass_made, extremes(method)),
            t);
    if (!(std::abs(made.energy) <= most_energy_made))
        throw RunFailed(
            fmt::format(
                "continuum: at time {:.6g} in the cycle the method has made {:.3g} % of the energy that there was and "
                "that "
                "collisions have taken (at most {:.0f} % is allowed): its differences do not resolve the flow, or are "
                "unstable; {}",
                t, 100.0 * made.energy, 100.0 * most_energy_made, extremes(method)),
            t);
}

void refuse_instability(const Method& method, double t, double dt) {
    const double unstable = method.unstable_share(dt);
    if (!(unstable <= most_mass_unstable))
        throw RunFailed(
            fmt::format(
                "continuum: at time {:.6g} in the cycle a step of {:.3g} is unstable where {:.0f} % of the mass is "
                "(at most {:.0f} % is allowed): lower continuum.diffusion_factor, artificial_dissipation or "
                "spacing; {}",
                t, dt, 100.0 * unstable, 100.0 * most_mass_unstable, extremes(method)),
            t);
}

}  // namespace

bool advance(Method& method, double from, double to, double shortest, const std::function<bool()>& asked_to_stop) {
    const double interval = to - from;
    double done = 0.0;
    for (std::int64_t step = 1; done < interval; ++step) {
        const double left = interval - done;
        const double pieces = std::ceil(left / method.longest_step() * (1.0 - 1e-12));
        const double dt = left / pieces;
        if (!(dt >= shortest) && pieces != 1.0)
            throw RunFailed(fmt::format("continuum: a step of {:.3g} is asked for at time {:.6g} in the cycle, below "
                                        "the shortest one of {:.2g}: {}",
                                        dt, from + done, shortest, extremes(method)),
                            from + done);
        if (step % steps_between_looks == 1) refuse_instability(method, from + done, dt);
        method.step(from + done, dt);
        done = pieces <= 1.0 ? interval : done + dt;
        if (step % steps_between_looks == 0) refuse_unsound(method, from + done);
        if (asked_to_stop && asked_to_stop()) return false;
    }
    refuse_unsound(method, to);
    return true;
}

}  // namespace shaken::continuum
