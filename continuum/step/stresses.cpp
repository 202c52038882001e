// SPDX-License-Identifier: MIT
#include "continuum/step/stresses.hpp"

#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

void stresses_between(const Neighbourhood& at, double dz, double dt, std::int64_t nz, const Carried& out) {
    const Neighbourhood n = at;
    double* __restrict normal = out.normal;
    double* __restrict lateral = out.lateral;
    double* __restrict vertical = out.vertical;
    double* __restrict energy = out.energy;
    const double across = 1.0 / n.width, along = 0.25 / n.lateral_width, upward = 0.25 / dz;
    const double cap = n.share * n.width * n.width / dt;
    const double mixed_cap = n.share * n.width * dz / dt;
#pragma omp simd
    for (std::int64_t k = 0; k < nz; ++k) {
        const double thinner = smaller(n.left.density[k], n.right.density[k]);
        const double most = cap * thinner;
        const double left = 0.5 * n.left.thermal_speed[k], right = 0.5 * n.right.thermal_speed[k];
        const double mean_shear = left * n.left.shear[k] + right * n.right.shear[k];
        const double mean_bulk = left * n.left.bulk[k] + right * n.right.bulk[k];
        const double shear = smaller(mean_shear, most), axial = smaller(mean_bulk + (4.0 / 3.0) * mean_shear, most);
        const double bulk = smaller(mean_bulk, most);
        const double most_mixed =
            mean_bulk + (4.0 / 3.0) * mean_shear <= most ? most : smaller(most, mixed_cap * thinner);
        const double mixed_shear = smaller(mean_shear, most_mixed), mixed_bulk = smaller(mean_bulk, most_mixed);
        const double mean_conductivity = left * n.left.conductivity[k] + right * n.right.conductivity[k];
        const double conductivity = smaller(mean_conductivity, 1.5 * most);

        const double normal_across = across * (n.right.normal[k] - n.left.normal[k]);
        const double lateral_across = across * (n.right.lateral[k] - n.left.lateral[k]);
        const double vertical_across = across * (n.right.vertical[k] - n.left.vertical[k]);
        const double normal_along = along * ((n.left_after.normal[k] - n.left_before.normal[k]) +
                                             (n.right_after.normal[k] - n.right_before.normal[k]));
        const double lateral_along = along * ((n.left_after.lateral[k] - n.left_before.lateral[k]) +
                                              (n.right_after.lateral[k] - n.right_before.lateral[k]));
        const double normal_upward =
            upward * ((n.left.normal[k + 1] - n.left.normal[k - 1]) + (n.right.normal[k + 1] - n.right.normal[k - 1]));
        const double vertical_upward = upward * ((n.left.vertical[k + 1] - n.left.vertical[k - 1]) +
                                                 (n.right.vertical[k + 1] - n.right.vertical[k - 1]));

        // Heat along the density gradient, as in heat_of_density.hpp; less of it where there is less conduction.
        const double left_heat = left * n.left.temperature[k] * (n.left.density[k] * n.left.density_conductivity[k]);
        const double right_heat =
            right * n.right.temperature[k] * (n.right.density[k] * n.right.density_conductivity[k]);
        const double jump = 2.0 * (n.right.density[k] - n.left.density[k]);
        const double density_heat = (left_heat + right_heat) * (across * jump) *
                                    (conductivity / (mean_conductivity * (n.right.density[k] + n.left.density[k])));

        const double stress_normal = axial * normal_across + (bulk - (2.0 / 3.0) * shear) * lateral_along +
                                     (mixed_bulk - (2.0 / 3.0) * mixed_shear) * vertical_upward;
        const double stress_lateral = shear * lateral_across + shear * normal_along;
        const double stress_vertical = shear * vertical_across + mixed_shear * normal_upward;
        normal[k] = stress_normal;
        lateral[k] = stress_lateral;
        vertical[k] = stress_vertical;
        energy[k] = 0.5 * (stress_vertical * (n.left.vertical[k] + n.right.vertical[k]) +
                           (stress_normal * (n.left.normal[k] + n.right.normal[k]) +
                            stress_lateral * (n.left.lateral[k] + n.right.lateral[k]))) +
                    conductivity * (across * (n.right.temperature[k] - n.left.temperature[k])) + density_heat;
    }
}

}  // namespace shaken::continuum
