// SPDX-License-Identifier: MIT
#include "continuum/closures/values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "continuum/closures/closures.hpp"

namespace shaken::continuum {

namespace {

void refuse_outside(double volume_fraction, double packing, double temperature, double restitution) {
    if (!(volume_fraction > 0.0 && volume_fraction < packing))
        throw std::invalid_argument(
            fmt::format("a volume fraction of {} is not between 0 and {}, where the pair correlation packs",
                        volume_fraction, packing));
    if (!(temperature > 0.0 && std::isfinite(temperature)))
        throw std::invalid_argument(fmt::format("a temperature of {} is not a number above 0", temperature));
    if (!(restitution >= 0.0 && restitution <= 1.0))
        throw std::invalid_argument(fmt::format("a restitution of {} is not between 0 and 1", restitution));
}

}  // namespace

ClosureValues closure_values(const scene::Choice& closure, const scene::Choice& pair_correlation,
                             double volume_fraction, double temperature, double restitution) {
    const double density = volume_fraction / sphere_volume, e = restitution;
    return choose(Closures{}, "continuum.closure", closure, [&](auto chosen) {
        return choose(PairCorrelations{}, "continuum.pair_correlation", pair_correlation,
                      [&](auto pair) -> ClosureValues {
                          using Closure = decltype(chosen);
                          using Pair = decltype(pair);
                          refuse_outside(volume_fraction, Pair::packing, temperature, e);
                          const PressurePoint point = pressure_point<Pair>(density, temperature, 2.0 * (1.0 + e));
                          const double rate = Closure::template cooling_rate<Pair>(density, e);
                          return {point.pressure, std::sqrt(point.sound_speed_squared),
                                  Closure::template transport<Pair>(density, temperature, e),
                                  1.5 * density * rate * (1.0 - e * e) * temperature * std::sqrt(temperature)};
                      });
    });
}

}  // namespace shaken::continuum
