// SPDX-License-Identifier: MIT
// The spectrum carried over to polar coordinates by interpolation, as the source writes it (Bougie 2004, section
// 6.3.3): S(kx, ky) between the waves of the box is bilinear in theirs, and S(theta) its integral over k_r dk_r. Few
// waves of the box lie at the pattern's wavenumber, so that this spreads one wave over several directions: of a plane
// wave with two wavelengths along the box the strongest of 21 directions keeps 0.28.
#pragma once

#include <vector>

#include "compare/patterns/power_spectrum.hpp"

namespace shaken::compare {

/// Share of the power in each of PowerSpectrum::angles directions, bins as power_by_angle; NaN for a flat map.
std::vector<double> interpolated_by_angle(const PowerSpectrum& spectrum);

/// P_max by that measure.
double interpolated_order(const PowerSpectrum& spectrum);

}  // namespace shaken::compare
