// SPDX-License-Identifier: MIT
#include "compare/cycle_memory.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "fields/memory.hpp"

namespace shaken::compare {

double error_over_that_of_blocks(double tau, double block_length) {
    if (!(tau > 0.5)) return 1.0;
    const double r = (2.0 * tau - 1.0) / (2.0 * tau + 1.0);
    double within = 1.0;  // twice the autocorrelation time, of lags inside a block
    for (double k = 1.0; k < block_length; k += 1.0) within += 2.0 * (1.0 - k / block_length) * std::pow(r, k);
    return std::sqrt(2.0 * tau / within);
}

CycleMemory cycle_memory(const fields::PhaseMoments& moments, const Layout& layout) {
    double squared_errors = 0.0, of_independent = 0.0, cycles = 0.0;
    std::int64_t series = 0, long_enough = 0;
    for (const fields::Flow flow : {fields::Flow::first, fields::Flow::second}) {
        if (!layout.apart && flow == fields::Flow::second) continue;
        for (std::int64_t phase = 0; phase < moments.phases(); ++phase) {
            const std::vector<double> heights =
                moments.centres_of_mass(phase, layout.apart ? flow : fields::Flow::both);
            const fields::MeanWithMemory height = fields::mean_with_memory(heights);
            ++series;
            if (height.is_long_enough) ++long_enough;
            if (!std::isfinite(height.error) || height.error == 0.0) continue;
            squared_errors += height.error * height.error;
            of_independent += height.error * height.error / (2.0 * height.memory);
            cycles = static_cast<double>(heights.size());
        }
    }
    CycleMemory memory;
    if (moments.cycles() < 2) memory.cycles = std::nan("");
    if (of_independent > 0.0) {
        memory.cycles = 0.5 * squared_errors / of_independent;
        memory.factor = error_over_that_of_blocks(memory.cycles, cycles / static_cast<double>(moments.blocks()));
    }
    memory.is_long_enough = 2 * long_enough > series;
    return memory;
}

std::optional<std::string> note_of(const CycleMemory& memory, std::int64_t cycles) {
    if (memory.is_long_enough) return std::nullopt;
    return fmt::format(
        "The MD averages {} cycle{}: too few to tell how long the layer remembers itself, so that errors are "
        "lower bounds.",
        cycles, cycles == 1 ? "" : "s");
}

}  // namespace shaken::compare
