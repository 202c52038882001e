// SPDX-License-Identifier: MIT
// How far a run stays inside what the continuum's equations assume: gradients over a mean free path (Knudsen number),
// the plate's motion over the time between collisions, packed mass. Means of states at the sample instants; nothing
// here changes one.
//   Kn        = l |dT/dz| / T,  l = sqrt(pi/8) / (n pi sigma^2)
//   omega tau = 2 pi f tau,      1/tau = (24/sqrt(pi)) G sqrt(T)
// l has no dense correction, as in docs/formats.md; tau has the scene's contact value, G = nu g0.
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
/// One state more, its means with this share.
void add(ValidityOfRun& run, const Validity& state, double share);
ValidityOfRun over_run(std::span<const Validity> states);

/// Name and value of each number, as files have them.
std::vector<std::pair<std::string, double>> named(const ValidityOfRun& run);

/// Limits on the means of a run (docs/choosing.md, `scripts/validity_study.py`). Below the first two, the mean T of
/// eight measured layers is 0.98 to 1.18 times that of grains; above, 1.01 to 4.4 times (omega tau), 1.07 to 1.50 times
/// (Kn, of which 0.1 is also the usual limit of Navier and Stokes' equations: Bird 1994).
inline constexpr double omega_tau_limit = 2.5;
inline constexpr double knudsen_limit = 0.1;
/// The least share, 0.11, at which it is known that what a closure does where mass is packed decides when waves begin.
inline constexpr double packed_share_limit = 0.1;

/// One sentence for each limit that a run is above.
std::vector<std::string> warnings(const ValidityOfRun& run);

/// One line for the terminal.
std::string in_words(const ValidityOfRun& run);

}  // namespace shaken::compare
