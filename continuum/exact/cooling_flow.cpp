// SPDX-License-Identifier: MIT
#include "continuum/exact/cooling_flow.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "continuum/closures/pressure.hpp"

namespace shaken::continuum::exact {

namespace {

constexpr double adiabatic_exponent = 5.0 / 3.0;

}  // namespace

CoolingFlow::CoolingFlow(const scene::GasState& wall, double restitution)
    : density_(wall.volume_fraction / sphere_volume), pressure_(density_ * wall.temperature) {
    if (!(restitution < 1.0)) throw std::domain_error("a gas that does not cool has no cooling flow");
    const double loss = 4.0 * std::sqrt(std::numbers::pi) / 3.0 * (1.0 - restitution * restitution);
    kappa_ = loss / (std::numbers::sqrt2 * adiabatic_exponent);
    rate_ = loss / (2.0 * adiabatic_exponent);
    mass_ = 0.5 * std::numbers::pi / kappa_;
    integral_ = integral_of_root(mass_);
}

double CoolingFlow::integral_of_root(double mass) const {
    // With kappa m = pi/2 - s^2 the root at the surface becomes smooth: sqrt(cos) dm = -2 s sqrt(sin s^2) ds / kappa.
    const double far = std::sqrt(0.5 * std::numbers::pi);
    const double near = std::sqrt(std::max(0.0, 0.5 * std::numbers::pi - kappa_ * mass));
    const auto integrand = [](double s) { return 2.0 * s * std::sqrt(std::sin(s * s)); };
    return boost::math::quadrature::gauss<double, 30>::integrate(integrand, near, far) / kappa_;
}

double CoolingFlow::height_of(double mass, double time) const {
    // The integral of 1/n = (n0^(-1/2) - rate sqrt(p) t)^2 over m.
    const double swept = rate_ * time, root = std::sqrt(pressure_ / density_);
    return mass / density_ - 2.0 * swept * root * integral_of_root(mass) +
           swept * swept * pressure_ * std::sin(kappa_ * mass) / kappa_;
}

double CoolingFlow::surface(double time) const { return height_of(mass_, time); }

double CoolingFlow::longest_time() const { return 1.0 / (rate_ * std::sqrt(density_ * pressure_)); }

scene::GasState CoolingFlow::at(double height, double time) const {
    const auto velocity_of = [&](double mass, double integral) {
        return -2.0 * rate_ *
               (std::sqrt(pressure_ / density_) * integral -
                rate_ * time * pressure_ * std::sin(kappa_ * mass) / kappa_);
    };
    if (height >= surface(time)) return {0.0, velocity_of(mass_, integral_), 0.0};
    std::uintmax_t most = 100;
    const auto [low, high] =
        boost::math::tools::toms748_solve([&](double mass) { return height_of(mass, time) - height; }, 0.0, mass_,
                                          boost::math::tools::eps_tolerance<double>(50), most);
    const double mass = 0.5 * (low + high), pressure = pressure_ * std::cos(kappa_ * mass);
    const double width = 1.0 / std::sqrt(density_) - rate_ * std::sqrt(pressure) * time,
                 density = 1.0 / (width * width);
    return {density * sphere_volume, velocity_of(mass, integral_of_root(mass)), pressure / density};
}

}  // namespace shaken::continuum::exact
