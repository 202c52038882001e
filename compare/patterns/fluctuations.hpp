// SPDX-License-Identifier: MIT
// How long the waves of a layer remember themselves from cycle to cycle, below an onset: each wave of a fluctuating
// layer holds what lasts (terraces, drifts), what changes sign every cycle (a damped pattern at half the plate's
// frequency), and the noise of its maps, which remembers nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/patterns/floquet.hpp"
#include "compare/patterns/power_spectrum.hpp"

namespace shaken::compare {

/// Covariance C(l) of a wave with itself l cycles later, l >= 1: persistent p^l + alternating (-q)^l.
struct TwoDecays {
    double persistent = 0.0, persistent_factor = 0.0;
    double alternating = 0.0, alternating_factor = 0.0;  // q: the growth a cycle of a small alternating wave
};

/// Mean of Re a(c + l) conj a(c) for l = 0 .. lags - 1, over cycles that follow one another. Throws
/// std::invalid_argument for no more amplitudes than lags.
std::vector<double> autocovariance(std::span<const Amplitude> amplitudes, std::size_t lags);

/// Least squares in C(1) .. C(L - 1); C(0), which holds the noise, is not looked at. Parts are not negative, factors
/// from 0.2 to 1.05. A part that is zero has a factor that says nothing.
TwoDecays fit_two_decays(std::span<const double> covariance);

/// Standard error of a mean square <|a|^2> and of a factor f, for `waves` independent waves seen over so many cycles,
/// if each is kicked at random and fades by f: relative sqrt((1 + f^2)/((1 - f^2) N)), and sqrt((1 - f^2)/N), N = waves
/// times cycles (Bartlett 1946). Blocks of cycles cannot tell them where a wave remembers itself for longer than a
/// block.
struct MemoryError {
    double relative = 0.0, factor = 0.0;
};
MemoryError memory_error(double factor, double waves, double cycles);

/// All waves of one wavelength. Powers are shares of <psi^2> in sigma^2. Errors: what leaving blocks of cycles out says
/// or memory_error, whichever is more.
struct Fluctuation {
    double wavelength = 0.0;  // sigma
    std::int64_t waves = 0;   // so many wavevectors, each and its opposite counted once
    double power = 0.0;
    TwoDecays decays, errors;
};

/// Whether the factor of what alternates says something: told to 0.15, and inside the ends of fit_two_decays.
bool tells_its_factor(const Fluctuation& wave);

/// The longest `most` wavelengths, the longest first; none for fewer cycles than errors need (forty).
/// amplitudes: [map][wave], of cycles that follow one another.
std::vector<Fluctuation> fluctuations(std::span<const PlaneWave> waves,
                                      const std::vector<std::vector<Amplitude>>& amplitudes, std::size_t most);

}  // namespace shaken::compare
