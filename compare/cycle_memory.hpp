// SPDX-License-Identifier: MIT
// How long a layer remembers itself, from the centre of mass of every cycle, and what that does to errors from blocks
// of cycles: blocks shorter than the memory are not independent, and their scatter says too little.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "compare/layout.hpp"
#include "fields/phase_moments.hpp"

namespace shaken::compare {

struct CycleMemory {
    double cycles = 0.5;  // integrated autocorrelation time (fields/memory.hpp), mean over the phases; 1/2: none
    double factor = 1.0;  // errors from blocks are multiplied by it; never below 1
    bool is_long_enough = false;  // to tell, at most of the phases
};

/// Of cycles of one flow where they are averaged apart. NaN cycles where there are fewer than two.
CycleMemory cycle_memory(const fields::PhaseMoments& moments, const Layout& layout);

/// Where the averaged cycles are too few to tell, the sentence that says so.
std::optional<std::string> note_of(const CycleMemory& memory, std::int64_t cycles);

/// What the error of a mean is over what blocks of so many samples say, for samples with an autocorrelation time tau
/// that is forgotten evenly: rho_k = r^k.
double error_over_that_of_blocks(double tau, double block_length);

}  // namespace shaken::compare
