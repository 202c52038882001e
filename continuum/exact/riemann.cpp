// SPDX-License-Identifier: MIT
#include "continuum/exact/riemann.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "continuum/closures/pressure.hpp"

namespace shaken::continuum::exact {

namespace {

constexpr int isentrope_points = 4000;
constexpr double isentrope_span = 34.0;  // of ln n: down to 1e-15 of the density

template <class F>
double bisect(const F& above_zero_at_low, double low, double high) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (above_zero_at_low(middle) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

Riemann::Riemann(const scene::GasState& left, const scene::GasState& right, const EquationOfState& state)
    : state_(state) {
    left_ = make_side(left);
    right_ = make_side({right.volume_fraction, -right.velocity, right.temperature});
    // Closing speed of the two stars, falling with the pressure; positive while the star is too thin.
    const auto closing = [&](double log_pressure) {
        const double p = std::exp(log_pressure);
        return behind(left_, p).velocity + behind(right_, p).velocity;
    };
    const double closing_speed = left.velocity - right.velocity;
    const double largest =
        std::max({left_.gas_pressure, right_.gas_pressure, left.volume_fraction * closing_speed * closing_speed,
                  right.volume_fraction * closing_speed * closing_speed});
    const auto lowest = [&](const Side& side) {
        const Point& end = side.isentrope.back();
        return pressure_of(std::exp(end.log_density), std::exp(end.log_temperature));
    };
    const double low = std::log(std::max(lowest(left_), lowest(right_))), high = std::log(largest) + 27.6;
    if (!(closing(low) > 0.0)) throw std::domain_error("Riemann problem: a vacuum opens between the two states");
    if (!(closing(high) < 0.0)) throw std::domain_error("Riemann problem: the two states meet too fast");
    pressure_ = std::exp(bisect(closing, low, high));
    velocity_ = 0.5 * (behind(left_, pressure_).velocity - behind(right_, pressure_).velocity);
    for (Side* side : {&left_, &right_}) {
        const Behind star = behind(*side, pressure_);
        const double u0 = side->gas.velocity, n0 = side->gas.volume_fraction;
        side->shock = pressure_ > side->gas_pressure;
        side->star_density = star.density;
        side->star_temperature = star.temperature;
        if (side->shock) {
            // Mass through the shock: n0 (u0 - s) = n1 (u1 - s).
            side->head = side->tail = (star.density * star.velocity - n0 * u0) / (star.density - n0);
        } else {
            side->head = u0 - state_.sound_speed(n0, side->gas.temperature);
            side->tail = star.velocity - state_.sound_speed(star.density, star.temperature);
        }
    }
    right_.head = -right_.head;
    right_.tail = -right_.tail;
}

double Riemann::chi(double nu) const { return state_.pressure(nu, 1.0) / (nu / sphere_volume); }

double Riemann::sound(const Point& point) const {
    return state_.sound_speed(std::exp(point.log_density), std::exp(point.log_temperature));
}

Riemann::Point Riemann::follow(const Point& from, double log_density) const {
    const double h = log_density - from.log_density;
    struct Slope {
        double temperature, velocity;
    };
    const auto slope = [&](double x, double y) -> Slope {
        return {2.0 / 3.0 * chi(std::exp(x)), -state_.sound_speed(std::exp(x), std::exp(y))};
    };
    const double x = from.log_density, y = from.log_temperature;
    const Slope a = slope(x, y), b = slope(x + 0.5 * h, y + 0.5 * h * a.temperature),
                c = slope(x + 0.5 * h, y + 0.5 * h * b.temperature), d = slope(x + h, y + h * c.temperature);
    return {log_density, y + h / 6.0 * (a.temperature + 2.0 * b.temperature + 2.0 * c.temperature + d.temperature),
            from.velocity + h / 6.0 * (a.velocity + 2.0 * b.velocity + 2.0 * c.velocity + d.velocity)};
}

Riemann::Side Riemann::make_side(const scene::GasState& gas) const {
    Side side;
    side.gas = gas;
    side.gas_pressure = pressure_of(gas.volume_fraction, gas.temperature);
    side.isentrope.push_back({std::log(gas.volume_fraction), std::log(gas.temperature), 0.0});
    const double top = side.isentrope.front().log_density;
    for (int i = 1; i <= isentrope_points; ++i)
        side.isentrope.push_back(follow(side.isentrope.back(), top - isentrope_span * i / isentrope_points));
    return side;
}

Riemann::Behind Riemann::behind(const Side& side, double pressure) const {
    return pressure > side.gas_pressure ? behind_shock(side, pressure) : behind_rarefaction(side, pressure);
}

Riemann::Behind Riemann::behind_shock(const Side& side, double pressure) const {
    const double n0 = side.gas.volume_fraction, p0 = side.gas_pressure;
    const auto surplus = [&](double n) {
        return 1.5 * (pressure / (n * chi(n)) - side.gas.temperature) - 0.5 * (pressure + p0) * (1.0 / n0 - 1.0 / n);
    };
    const double n = bisect(surplus, n0, state_.packing_limit() * (1.0 - 1e-15));
    return {n, pressure / (n * chi(n)),
            side.gas.velocity - std::sqrt(std::max(0.0, (pressure - p0) * (1.0 / n0 - 1.0 / n)))};
}

Riemann::Behind Riemann::behind_rarefaction(const Side& side, double pressure) const {
    const auto pressure_at = [&](const Point& q) {
        return pressure_of(std::exp(q.log_density), std::exp(q.log_temperature));
    };
    const auto after = std::partition_point(side.isentrope.begin() + 1, side.isentrope.end() - 1,
                                            [&](const Point& q) { return pressure_at(q) > pressure; });
    const Point& from = *(after - 1);
    const double x = bisect([&](double s) { return pressure_at(follow(from, s)) > pressure ? -1.0 : 1.0; },
                            after->log_density, from.log_density);
    const Point q = follow(from, x);
    return {std::exp(q.log_density), std::exp(q.log_temperature), side.gas.velocity + q.velocity};
}

scene::GasState Riemann::sample(const Side& side, double speed) const {
    const double sign = &side == &right_ ? -1.0 : 1.0;
    const double head = sign * side.head, tail = sign * side.tail, star_velocity = sign * velocity_;
    if (speed <= head) return side.gas;
    if (speed >= tail) return {side.star_density, star_velocity, side.star_temperature};
    const auto wave = [&](const Point& q) { return side.gas.velocity + q.velocity - sound(q); };
    const auto after = std::partition_point(side.isentrope.begin() + 1, side.isentrope.end() - 1,
                                            [&](const Point& q) { return wave(q) < speed; });
    const Point& from = *(after - 1);
    const double x =
        bisect([&](double s) { return wave(follow(from, s)) - speed; }, after->log_density, from.log_density);
    const Point q = follow(from, x);
    return {std::exp(q.log_density), side.gas.velocity + q.velocity, std::exp(q.log_temperature)};
}

scene::GasState Riemann::at(double speed) const {
    if (speed < velocity_) return sample(left_, speed);
    scene::GasState mirrored = sample(right_, -speed);
    mirrored.velocity = -mirrored.velocity;
    return mirrored;
}

}  // namespace shaken::continuum::exact
