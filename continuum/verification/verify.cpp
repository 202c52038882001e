// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "continuum/advance.hpp"
#include "continuum/resolve.hpp"
#include "continuum/verification.hpp"
#include "continuum/verification/case.hpp"

namespace shaken::continuum {

using scene::GasState;
using scene::Kind;

namespace {

Case make_case(const scene::Scene& scene) {
    switch (scene.kind) {
        case Kind::riemann:
            return riemann_case(scene);
        case Kind::piston:
            return piston_case(scene);
        case Kind::column:
            return column_case(scene);
        case Kind::wave:
            return wave_case(scene);
        case Kind::cooling_flow:
            return cooling_flow_case(scene);
        case Kind::uniform:
            return uniform_case(scene);
        default:
            throw std::invalid_argument("continuum: this kind of scene has no exact solution");
    }
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

}  // namespace

void refuse_unverifiable(const scene::Scene& scene) { make_method(make_case(resolve(scene)).setup); }

Verification verify(const scene::Scene& scene) { return *verify_unless({}, scene); }

std::optional<Verification> verify_unless(const AskedToStop& asked_to_stop, const scene::Scene& given) {
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
