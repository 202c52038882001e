// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "continuum/advance.hpp"
#include "continuum/closures/pressure.hpp"
#include "continuum/closures/values.hpp"
#include "continuum/exact/gas.hpp"
#include "continuum/verification/case.hpp"

namespace shaken::continuum {

using scene::GasState;

Case wave_case(const scene::Scene& scene) {
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

namespace {

/// Amplitude of one wavelength over the tube.
std::complex<double> mode(const std::vector<double>& field) {
    std::complex<double> sum = 0.0;
    const double cells = static_cast<double>(field.size());
    for (std::size_t i = 0; i < field.size(); ++i)
        sum += field[i] * std::polar(1.0, -2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / cells);
    return sum * (2.0 / cells);
}

}  // namespace

// The wave starts with the eigenvector of an undamped one; what is left of it as two others is gone or small after a
// third of the time, and over a whole number of periods a wave the other way leaves no trace in the mean.
PeriodsOfWave periods_of_wave(double time, double period) {
    const double begin = std::max(1.0, std::round(time / (3.0 * period))) * period;
    return {begin, begin + std::max(1.0, std::round((time - begin) / period)) * period};
}

bool check_wave(const scene::Scene& scene, Method& method, double shortest, const AskedToStop& asked_to_stop,
                Verification& v) {
    const EquationOfState state = state_of(scene);
    const double nu = scene.tube.gas.volume_fraction, temperature = scene.tube.gas.temperature;
    const double k = 2.0 * std::numbers::pi / scene.tube.length;
    const double speed = state.sound_speed(nu, temperature);
    const std::string why_no_exact = scene.tube.restitution < 1.0 ? "the exact wave has tube.restitution = 1" : "";
    const Transport transport =
        closure_values(scene.continuum.closure, scene.continuum.pair_correlation, nu, temperature, 1.0).transport;
    const double damping =
        scene.continuum.transport.name == "inviscid"
            ? 0.0
            : exact::sound_attenuation(nu / sphere_volume, transport, state.specific_heat_at_constant_pressure(nu));
    const double period = scene.tube.length / speed;
    const auto [begin, end] = periods_of_wave(scene.tube.time, period);
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

}  // namespace shaken::continuum
