// SPDX-License-Identifier: MIT
// Ghost cells at both ends of a column.
#pragma once

#include "continuum/boundary/boundaries.hpp"
#include "continuum/boundary/wall.hpp"
#include "continuum/flow.hpp"

namespace shaken::continuum {

/// Periodic ends: the three cells beyond one end are the last three before the other.
inline void fill_periodic(double* first, std::int64_t cells) {
    for (std::int64_t k = 0; k < 3; ++k) {
        first[-1 - k] = first[cells - 1 - k];
        first[cells + k] = first[k];
    }
}

/// `first` is the index of the lowest cell of the column inside the arrays of the flow.
inline void fill_ghosts(Flow& flow, std::int64_t first, std::int64_t cells, const Boundaries& boundaries,
                        double packing_density) {
    double* const fields[] = {flow.density.data() + first, flow.velocity_x.data() + first,
                              flow.velocity_y.data() + first, flow.velocity_z.data() + first,
                              flow.temperature.data() + first};
    if (boundaries.lower.end == End::periodic) {
        for (double* field : fields) fill_periodic(field, cells);
        return;
    }
    const auto fill = [&](End end, std::int64_t cell, std::int64_t inward) {
        for (double* field : fields) fill_even(field + cell, inward);
        if (!reflects(end)) return;
        fill_odd(flow.velocity_z.data() + first + cell, inward);
        fill_density_at_wall(flow.density.data() + first + cell, inward, packing_density);
    };
    fill(boundaries.lower.end, 0, 1);
    fill(boundaries.upper.end, cells - 1, -1);
}

/// The same for the viscous stresses: across a stress-free end u_z goes on as it is, d u_z/dz = 0.
inline void fill_ghosts_of_stresses(Flow& flow, std::int64_t first, std::int64_t cells, const Boundaries& boundaries,
                                    double packing_density) {
    fill_ghosts(flow, first, cells, boundaries, packing_density);
    double* const velocity = flow.velocity_z.data() + first;
    if (boundaries.lower.end == End::stress_free) fill_even(velocity, 1);
    if (boundaries.upper.end == End::stress_free) fill_even(velocity + cells - 1, -1);
}

}  // namespace shaken::continuum
