// SPDX-License-Identifier: MIT
// What one plane wave does from cycle to cycle, seen once a cycle at one phase: the part that alternates, as a pattern
// at half the plate's frequency does, and the factor by which a small wave grows.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace shaken::compare {

using Amplitude = std::complex<double>;

/// The mean of (-1)^cycle a over whole periods of two cycles, in which what does not alternate cancels, and its error:
/// the standard error of the modulus from at most ten blocks of whole periods, or what a drift would leave, if that is
/// more. Noise alone gives a mean of the size of its error.
struct CoherentPart {
    Amplitude mean;
    double error = 0.0;
};

/// cycles, which follow one another, and amplitudes: one each; of an odd number the first is left out. The mean is NaN
/// for fewer than two cycles, the error for fewer than four.
CoherentPart coherent_part(std::span<const std::int64_t> cycles, std::span<const Amplitude> amplitudes);

/// The multiplier mu of a(c + 1) = mu a(c) over cycles that follow one another, as the geometric mean of the ratios, so
/// that each cycle weighs alike however much the wave grows: -|mu| for one at half the plate's frequency. Throws
/// std::invalid_argument for fewer than two.
Amplitude multiplier(std::span<const Amplitude> amplitudes);

/// The same of the part that alternates, where something that lasts or drifts lies beneath it: of the second
/// differences, from which what is constant or linear in the cycle is gone. -|mu|; NaN where not every one of them
/// changes sign, so that nothing alternates. Throws std::invalid_argument for fewer than four.
double alternating_multiplier(std::span<const Amplitude> amplitudes);

/// Where |multiplier| crosses 1, by linear interpolation of its logarithm in the control (the plate's acceleration);
/// NaN where it does not. Controls ascend.
double onset(std::span<const double> controls, std::span<const double> multipliers);

}  // namespace shaken::compare
