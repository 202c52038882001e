// SPDX-License-Identifier: MIT
#include "continuum/exact/heated_layer.hpp"

#include <cmath>
#include <numbers>

namespace shaken::continuum::exact {

namespace {

/// x^b I_-b(x) Gamma(1 - b) 2^-b, by its series, all of one sign for b < 1: 1 + (x/2)^2/(1 - b) + ...
double bessel_sum(double b, double x) {
    double sum = 1.0, term = 1.0;
    for (int k = 1; term > 1e-17 * sum; ++k) {
        term *= 0.25 * x * x / (k * (k - b));
        sum += term;
    }
    return sum;
}

}  // namespace

DiluteGas dilute_jenkins_richman(double restitution) {
    const double root_pi = std::sqrt(std::numbers::pi);
    return {75.0 / (64.0 * root_pi), 0.0, 2.0 * root_pi * (1.0 - restitution * restitution)};
}

double heated_layer_temperature(double bottom_temperature, double number_per_area, const DiluteGas& gas,
                                double weight_above) {
    const double left = gas.conductivity - gas.density_conductivity;
    const double a = std::sqrt(0.5 * gas.cooling / left), b = 0.25 * gas.density_conductivity / left;
    const double ratio = std::pow(weight_above / number_per_area, -2.0 * b) * bessel_sum(b, a * weight_above) /
                         bessel_sum(b, a * number_per_area);
    return bottom_temperature * ratio * ratio;
}

}  // namespace shaken::continuum::exact
