// SPDX-License-Identifier: MIT
#include "continuum/closures/effective_dissipation.hpp"

#include <cmath>

namespace shaken::continuum {

namespace {

// Tanh-sinh quadrature of a function that is smooth inside its interval (Takahasi & Mori 1974). The law has a kink
// at v0, so its average is taken in pieces.
template <class Integrand>
double integral(const Integrand& f, double from, double to) {
    const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
    constexpr double step = 1.0 / 32.0;
    constexpr int points = 4 * 32;
    double sum = 0.0;
    for (int i = -points; i <= points; ++i) {
        const double s = i * step;
        const double grown = scene::exponential(s), shrunk = 1.0 / grown;
        const double inner = 0.78539816339744831 * (grown - shrunk);  // pi/2 sinh s
        const double square = scene::exponential(2.0 * inner);
        const double weight = 3.1415926535897932 * (grown + shrunk) * square / ((square + 1.0) * (square + 1.0));
        sum += weight * f(middle + half * (square - 1.0) / (square + 1.0));  // tanh(inner)
    }
    return half * step * sum;
}

double kink_of(const scene::Restitution& law) {
    const auto* velocity = std::get_if<scene::RestitutionVelocity>(&law);
    return velocity ? velocity->v0 : 0.0;
}

}  // namespace

double effective_dissipation(const scene::Restitution& law, double temperature) {
    if (const auto* constant = std::get_if<scene::RestitutionConstant>(&law)) return 1.0 - constant->e0 * constant->e0;
    const double root_t = std::sqrt(temperature);
    const auto lost = [&](double v) {  // v in sqrt(T)
        const double e = std::visit([&](const auto& l) { return l(v * root_t); }, law);
        return (1.0 - e * e) * v * v * v * scene::exponential(-0.25 * v * v);
    };
    constexpr double beyond = 40.0;  // exp(-400) of the Maxwellian lies above
    const double kink = std::min(kink_of(law) / root_t, beyond);
    const double all = 8.0;  // integral of v^3 exp(-v^2/4)
    double sum = integral(lost, 0.0, std::min(kink, 6.0));
    if (kink > 6.0) sum += integral(lost, 6.0, kink);
    if (kink < beyond) sum += integral(lost, kink, std::max(6.0, kink)) + integral(lost, std::max(6.0, kink), beyond);
    return sum / all;
}

EffectiveDissipation::EffectiveDissipation(const scene::Restitution& law) {
    if (std::holds_alternative<scene::RestitutionConstant>(law)) {
        constant_ = effective_dissipation(law, 1.0);
        return;
    }
    const int count = static_cast<int>((highest - lowest) * per_octave) + 1;
    table_.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        table_.push_back(effective_dissipation(law, scene::fast_exp2(lowest + i / per_octave)));
    constant_ = table_.back();
}

scene::Restitution sink_restitution(const scene::Scene& scene) {
    if (scene.continuum.restitution) return scene::RestitutionConstant{*scene.continuum.restitution};
    return scene.particles.restitution;
}

double pressure_restitution(const scene::Scene& scene) { return scene::fast_restitution(sink_restitution(scene)); }

}  // namespace shaken::continuum
