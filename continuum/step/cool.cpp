// SPDX-License-Identifier: MIT
// Cooling of the cells of a column by themselves, dT/dt = -rate D T^(3/2).
#include <cmath>

#include "continuum/flux/wave_speeds.hpp"
#include "continuum/step/relax_column.hpp"
#include "continuum/step/sum_in_lanes.hpp"

namespace shaken::continuum {

void RelaxColumn::cool(std::int64_t column, double dt) {
    const std::int64_t nz = fluid_.grid().nz, first = fluid_.grid().first(column);
    const double* density = fluid_.flow().density.data() + first;
    double* __restrict temperature = fluid_.flow().temperature.data() + first;
    const double* rate = coefficients_.from(first).cooling;
    const double floor = fluid_.constants.floor_temperature;
    const EffectiveDissipation& dissipation = fluid_.dissipation;
    double* __restrict lost = scratch().lost;
    double* __restrict floored = scratch().floored;
    // d(T^(-1/2))/dt = rate D / 2 while D stays the same: exact for constant restitution, and second order in dt with D
    // taken at the middle of the step for the others.
    const auto cooled = [](double t, double half_rate) {
        const double root = 1.0 + half_rate * std::sqrt(t);
        return t / (root * root);
    };
    if (dissipation.is_constant()) {
        const double half_step = 0.5 * dt * dissipation.constant();
#pragma omp simd
        for (std::int64_t i = 0; i < nz; ++i) {
            const double new_temperature = cooled(temperature[i], half_step * rate[i]);
            const double kept = larger(floor, new_temperature);
            lost[i] = density[i] * (temperature[i] - new_temperature);
            floored[i] = density[i] * (kept - new_temperature);
            temperature[i] = kept;
        }
    } else {
        const double* table = dissipation.table();
#pragma omp simd
        for (std::int64_t i = 0; i < nz; ++i) {
            const double t = temperature[i];
            const EffectiveDissipation::Local d = EffectiveDissipation::interpolate(table, t);
            // ln(T_middle/T) = -2 ln(1 + x), x over a quarter of the step's exponent, by its Pade approximant.
            const double x = (0.25 * dt * rate[i]) * (d.value * std::sqrt(t));
            const double at_middle = larger(d.value - d.slope * (4.0 * x / (2.0 + x)), 0.0);
            const double new_temperature = cooled(t, (0.5 * dt * rate[i]) * at_middle);
            const double kept = larger(floor, new_temperature);
            lost[i] = density[i] * (t - new_temperature);
            floored[i] = density[i] * (kept - new_temperature);
            temperature[i] = kept;
        }
    }
    Ledger& books = fluid_.books_of(column);
    books.collisional_loss += 1.5 * fluid_.grid().dz * sum_in_lanes(lost, nz);
    books.floor_gain += 1.5 * fluid_.grid().dz * sum_in_lanes(floored, nz);
}

}  // namespace shaken::continuum
