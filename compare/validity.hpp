// SPDX-License-Identifier: MIT
// How far a run stays inside what the continuum's equations assume: gradients over a mean free path (Knudsen number),
// the plate's motion over the time between collisions, packed mass. Means of states at the sample instants; nothing
// here changes one.
//   Kn        = l |dT/dz| / T,  l = sqrt(pi/8) / (n pi sigma^2)      no dense correction: what a particle flies in a
//   gas omega tau = 2 pi f / nu_c,  nu_c = (24/sqrt(pi)) G sqrt(T)       G = nu g0 of the scene's pair correlation
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "continuum/closures/equation_of_state.hpp"
#include "continuum/closures/pressure.hpp"
#include "continuum/solver.hpp"

namespace shaken::compare {

/// Volume fraction above which mass counts as packed: hard spheres freeze at 0.494, melt at 0.545 and jam at 0.64; the
/// closures, which diverge at packing, are extrapolated there.
inline constexpr double packed_volume_fraction = 0.6;

/// Of one state. Means are weighted by mass over the layer; a gas that is nowhere dense enough to be a layer counts
/// where it has more than half its greatest density. Packed share: of all mass.
struct Validity {
    double knudsen = 0.0, knudsen_largest = 0.0;
    double omega_tau = 0.0, omega_tau_largest = 0.0;
    double packed_share = 0.0;
};

/// columns: equal areas, cells of height spacing (sigma); at least one. Throws nothing.
Validity validity_of(std::span<const continuum::ColumnView> columns, double spacing,
                     const continuum::EquationOfState& gas, double omega);

/// Of a run: the means of the states' means, the largest of their largest.
struct ValidityOfRun {
    Validity mean;
    double packed_share_largest = 0.0;
};
ValidityOfRun over_run(std::span<const Validity> states);

/// Name and value of each number, as files have them.
std::vector<std::pair<std::string, double>> named(const ValidityOfRun& run);

/// One line for the terminal.
std::string in_words(const ValidityOfRun& run);

}  // namespace shaken::compare
