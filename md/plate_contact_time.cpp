// SPDX-License-Identifier: MIT
#include "md/plate_contact_time.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "md/contact_time.hpp"

namespace shaken::md {

namespace {

/// Gap between particle and plate as a function of time, with its derivatives.
struct Gap {
    const scene::PlateMotion& plate;
    double height, velocity, start;

    double value(double t) const {
        const double flight = t - start;
        return height + flight * (velocity - 0.5 * flight) - plate.position(t);
    }
    double rate(double t) const { return velocity - (t - start) - plate.velocity(t); }
    double acceleration(double t) const { return -1.0 - plate.acceleration(t); }
};

/// Root of f on [a, b] where f(a) and f(b) differ in sign: Newton, and bisection wherever Newton leaves the bracket
/// or gains less than half. Returns the end of the last bracket at which f has the sign of f(b) or is zero.
template <class F, class D>
double bracketed_root(F f, D derivative, double a, double b, double f_a, double f_b) {
    if (f_a == 0.0) return a;
    if (f_b == 0.0) return b;
    double t = a + (b - a) * (f_a / (f_a - f_b));
    double step_before = b - a;
    constexpr int enough = 200;  // bisection alone needs 60 from any bracket in a cycle
    for (int i = 0; i < enough; ++i) {
        if (!(t > a && t < b)) t = 0.5 * (a + b);
        if (!(t > a && t < b)) break;  // a and b are neighbours
        const double f_t = f(t);
        if (f_t == 0.0) return t;
        if ((f_t > 0.0) == (f_b > 0.0))
            b = t;
        else
            a = t;
        const double slope = derivative(t);
        const double step = slope == 0.0 ? b - a : -f_t / slope;
        if (std::abs(step) > 0.5 * std::abs(step_before)) {
            step_before = b - a;
            t = 0.5 * (a + b);
            continue;
        }
        step_before = step;
        if (t + step == t) return t;
        t += step;
    }
    return b;
}

/// One piece [a, b] on which the gap's acceleration has one sign.
double contact_in_piece(const Gap& gap, double a, double b) {
    const double rate_a = gap.rate(a), rate_b = gap.rate(b);
    double fall = a, rest = b;  // the part of the piece on which the gap falls
    const auto rate = [&](double t) { return gap.rate(t); };
    const auto acceleration = [&](double t) { return gap.acceleration(t); };
    if (rate_a >= 0.0 && rate_b >= 0.0) return never;
    if (rate_a >= 0.0) fall = bracketed_root(rate, acceleration, a, b, rate_a, rate_b);
    if (rate_b > 0.0) rest = bracketed_root(rate, acceleration, a, b, rate_a, rate_b);
    const double at_fall = gap.value(fall), at_rest = gap.value(rest);
    if (at_fall <= 0.0) return fall;
    if (at_rest > 0.0) return never;
    return bracketed_root([&](double t) { return gap.value(t); }, rate, fall, rest, at_fall, at_rest);
}

/// The next instant after t at which the gap's acceleration may change sign, or at which a cycle ends.
double next_sign_change(const scene::PlateMotion& plate, double t) {
    const double period = plate.period();
    const double cycle_start = std::floor(t / period) * period;
    const double omega = plate.angular_frequency();
    const double angle = plate.peak_acceleration() > 1.0
                             ? 0.5 * std::numbers::pi + scene::arc_sine(1.0 / plate.peak_acceleration())
                             : std::numbers::pi;
    for (const double turn : {angle, 2.0 * std::numbers::pi - angle})
        if (cycle_start + turn / omega > t) return cycle_start + turn / omega;
    return cycle_start + period > t ? cycle_start + period : cycle_start + 2.0 * period;
}

}  // namespace

double plate_contact_time(const scene::PlateMotion& plate, double height, double velocity, double now, double until) {
    if (!(until >= now)) return never;
    const Gap gap{plate, height, velocity, now};
    const double duration = until - now;
    // Closer than the plate at its fastest and the particle at its fastest could come: no root to look for.
    const double fastest_plate = plate.amplitude * plate.angular_frequency();
    if (gap.value(now) > duration * (fastest_plate - velocity + duration) && fastest_plate - velocity + duration >= 0.0)
        return never;

    double from = now;
    while (true) {
        const double to = std::min(until, next_sign_change(plate, from));
        const double t = contact_in_piece(gap, from, to);
        if (t != never || to >= until) return t;
        from = to;
    }
}

}  // namespace shaken::md
