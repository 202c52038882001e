// SPDX-License-Identifier: MIT
#include "continuum/step/fluid.hpp"

#include <omp.h>

#include <algorithm>

#include "continuum/closures/pressure.hpp"

namespace shaken::continuum {

namespace {

// Where the total energy leaves less heat than this share of n (jump of u)^2 its truncation error may exceed it.
constexpr double trust_total_energy = 1e-3;

bool is_moving(const std::vector<double>& velocity) {
    return std::any_of(velocity.begin(), velocity.end(), [](double u) { return u != 0.0; });
}

}  // namespace

Fluid::Fluid(Setup given)
    : setup(std::move(given)),
      kernels(choose_kernels(setup.choices)),
      dissipation(setup.sink),
      books(static_cast<std::size_t>(setup.grid.columns())) {
    constants.restitution = setup.restitution;
    constants.virial = 2.0 * (1.0 + setup.restitution);
    constants.packing_density = kernels.packing / sphere_volume;
    constants.floor_temperature = setup.floor_temperature;
    constants.trust = trust_total_energy;
    moves_along_x = grid().nx > 1 || is_moving(setup.flow.velocity_x);
    moves_along_y = grid().ny > 1 || is_moving(setup.flow.velocity_y);
    const std::vector<double> zero(grid().size(), 0.0);
    rates = {zero, zero, zero, zero, zero, zero, zero, zero};
}

int Fluid::threads() const { return static_cast<int>(std::min<std::int64_t>(omp_get_max_threads(), grid().columns())); }

std::size_t thread() { return static_cast<std::size_t>(omp_get_thread_num()); }

void copy_column(const Grid& grid, const Flow& from, Flow& to, std::int64_t column) {
    const std::int64_t begin = grid.first(column), end = begin + grid.nz;
    const auto source = from.fields();
    const auto target = to.fields();
    for (std::size_t k = 0; k < source.size(); ++k)
        std::copy(source[k]->begin() + begin, source[k]->begin() + end, target[k]->begin() + begin);
}

}  // namespace shaken::continuum
