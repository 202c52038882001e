// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "continuum/closures/closures.hpp"
#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/exact/gas.hpp"
#include "continuum/kernels.hpp"
#include "continuum/verification/case.hpp"
#include "scene/errors.hpp"

namespace shaken::continuum {

using scene::GasState;

/// A gas that only cools: any column of it, without ends. Haff's law where e is constant.
Case uniform_case(const scene::Scene& scene) {
    constexpr std::int64_t cells = 16;
    const double side = scene.box.x;
    Grid grid;
    grid.nz = cells;
    grid.dz = side / static_cast<double>(cells);
    Case c{Setup(grid), {}, ""};
    c.setup.choices = scene.continuum;
    c.setup.sink = sink_restitution(scene);
    c.setup.restitution = pressure_restitution(scene);
    c.setup.boundaries.lower.end = c.setup.boundaries.upper.end = End::periodic;
    const GasState gas{scene.initial.volume_fraction, 0.0, scene.initial.temperature};
    if (const double packing = choose_kernels(scene.continuum).packing; gas.volume_fraction >= packing)
        throw scene::SceneError({}, fmt::format("initial.volume_fraction = {} is not below {}, where {} packs",
                                                gas.volume_fraction, packing, scene.continuum.pair_correlation.name));
    for (std::int64_t i = 0; i < cells; ++i) put(c.setup, i, gas);
    const EquationOfState elastic = make_equation_of_state(scene.continuum.pair_correlation, 1.0);
    const double chi = elastic.pressure(gas.volume_fraction, 1.0) * sphere_volume / gas.volume_fraction;
    // G, from chi = 1 + 4 G, and what the closure makes of the sink of a Maxwellian gas.
    const double contact_rate =
        traits_of(scene.continuum.closure).cooling_share(c.setup.restitution) * 0.25 * (chi - 1.0);
    c.exact.assign(cells, {gas.volume_fraction, 0.0,
                           exact::cooled_temperature(gas.temperature, c.setup.sink, contact_rate, duration_of(scene))});
    return c;
}

}  // namespace shaken::continuum
