// SPDX-License-Identifier: MIT
// The mean of samples that remember each other, and its standard error. N samples of variance s^2 and integrated
// autocorrelation time tau (in samples, 1/2 where they are independent) have a mean of variance 2 tau s^2 / N (Sokal
// 1997). The samples are gathered in at most a hundred blocks, which forget more quickly; what the blocks still
// remember is taken from an autoregression fitted to them (Yule and Walker), of the order that the corrected criterion
// of Akaike wants (Hurvich and Tsai 1989): none of independent samples, whose error stays the usual one. A window over
// the autocorrelations does as well on long series, and scatters twice as much on those of ten to fifty samples.
#pragma once

#include <span>

namespace shaken::fields {

struct MeanWithMemory {
    double mean = 0.0;
    double error = 0.0;           // standard error with the memory found; NaN of fewer than two samples
    double memory = 0.0;          // tau, in samples
    bool is_long_enough = false;  // to tell: ten samples, and thirty tau of blocks where there is memory
};

/// NaN where a sample is not finite. The root mean square of the error over many series is right to a tenth from N = 20
/// tau on; of shorter ones the error is too small, and most of them say so.
MeanWithMemory mean_with_memory(std::span<const double> samples);

}  // namespace shaken::fields
