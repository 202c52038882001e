// SPDX-License-Identifier: MIT
// The pattern of one run in numbers, from its maps at one phase of the cycle. A pattern at half the plate's frequency
// comes back after two cycles: averages, and the ten blocks of cycles from which standard errors are, hold whole pairs.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "compare/patterns/fluctuations.hpp"
#include "compare/patterns/power_spectrum.hpp"
#include "fields/height_maps.hpp"

namespace shaken::compare {

struct PatternWindow {
    double phase = 0.25;      // the source's: the plate at its mean height, moving upwards
    std::int64_t first = 0;   // cycle
    std::int64_t cycles = 1;  // so many from it on
};

/// A quantity and its standard error; NaN where fewer than two blocks could be made.
struct Measure {
    double value = 0.0, error = 0.0;
};

struct WaveSummary {
    PlaneWave wave;
    double coherent = 0.0, coherent_error = 0.0;  // |mean of (-1)^cycle a|, sigma, and its error
    double root_mean_square = 0.0;                // of |a|, sigma
    double multiplier = 0.0;  // from cycle to cycle of the whole window: modulus, negative at half the frequency
    double alternating_multiplier = 0.0;          // of the part that alternates; NaN where none does
};

/// Mean spectrum of one block of cycles, as far as the onset of a pattern needs it.
struct PatternBlock {
    double mean_square = 0.0;      // <psi^2>, sigma^2
    std::vector<double> by_angle;  // power for each direction, PowerSpectrum::power_by_angle
};

struct PatternSummary {
    PatternWindow window;  // of the averages: of an odd number of cycles, from three on, the first is left out
    std::int64_t maps = 0;
    Measure mean_square;           // <psi^2>, sigma^2
    double mean_height = 0.0;      // <z_cm>, sigma, laboratory frame
    Measure relative_mean_square;  // <psi^2>/<z_cm>^2
    Measure order;                 // P_max of the mean spectrum
    Measure interpolated_order;    // the same by interpolation, polar_spectrum.hpp
    double wavelength = 0.0;       // sigma
    double angle = 0.0;            // of the wavevector, [0, pi)
    double coherent_share = 0.0;  // of <psi^2> in the waves' alternating means, less what noise alone would leave there
    std::vector<WaveSummary> waves;         // the strongest, by power
    std::vector<Fluctuation> fluctuations;  // of the longest waves, by wavelength; none for fewer than forty maps
    std::vector<PatternBlock> blocks;       // at most ten, equally long to two cycles, in order
};

/// Throws std::invalid_argument where the window holds no map.
PatternSummary summarise_pattern(const fields::HeightMaps& maps, const PatternWindow& window,
                                 std::size_t strongest = 5);

/// Every number of the summary by name; errors as NAME_error.
nlohmann::ordered_json to_json(const PatternSummary& summary);

}  // namespace shaken::compare
