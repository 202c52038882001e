// SPDX-License-Identifier: MIT
#include "compare/patterns/floquet.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shaken::compare {

CoherentPart coherent_part(std::span<const std::int64_t> cycles, std::span<const Amplitude> amplitudes) {
    constexpr std::size_t most_blocks = 10;
    const std::size_t count = amplitudes.size() / 2 * 2, first = amplitudes.size() - count;
    if (count == 0) return {Amplitude(std::nan(""), std::nan("")), std::nan("")};
    const auto signed_mean = [&](std::size_t from, std::size_t to) {
        Amplitude mean = 0.0;
        for (std::size_t i = from; i < to; ++i)
            mean += (cycles[i] % 2 == 0 ? amplitudes[i] : -amplitudes[i]) / static_cast<double>(to - from);
        return mean;
    };
    CoherentPart part{signed_mean(first, first + count), std::nan("")};
    const std::size_t blocks = std::min(most_blocks, count / 2);
    if (blocks < 2) return part;
    const std::size_t length = count / blocks / 2 * 2;
    std::vector<Amplitude> means(blocks);
    Amplitude mean = 0.0;
    for (std::size_t b = 0; b < blocks; ++b) {
        means[b] = signed_mean(first + b * length, first + (b + 1) * length);
        mean += means[b] / static_cast<double>(blocks);
    }
    double squares = 0.0;
    for (const Amplitude& block : means) squares += std::norm(block - mean);
    const double scatter = std::sqrt(squares / (static_cast<double>(blocks) * static_cast<double>(blocks - 1)));
    // What drifts leaves half its change a cycle, of the other sign in periods that begin a cycle later.
    const double drift = 0.5 * std::abs(part.mean - signed_mean(first + 1, first + count - 1));
    part.error = std::max(scatter, drift);
    return part;
}

Amplitude multiplier(std::span<const Amplitude> amplitudes) {
    if (amplitudes.size() < 2) throw std::invalid_argument("a multiplier needs two cycles");
    // The logarithm is taken around -1, where the waves of interest lie, so that its cut is far from them.
    Amplitude sum = 0.0;
    for (std::size_t i = 1; i < amplitudes.size(); ++i) sum += std::log(-amplitudes[i] / amplitudes[i - 1]);
    return -std::exp(sum / static_cast<double>(amplitudes.size() - 1));
}

double alternating_multiplier(std::span<const Amplitude> amplitudes) {
    if (amplitudes.size() < 4) throw std::invalid_argument("a multiplier of what alternates needs four cycles");
    std::vector<Amplitude> alternating;
    for (std::size_t i = 2; i < amplitudes.size(); ++i)
        alternating.push_back(0.25 * (amplitudes[i - 2] - 2.0 * amplitudes[i - 1] + amplitudes[i]));
    for (std::size_t i = 1; i < alternating.size(); ++i)
        if ((alternating[i] * std::conj(alternating[i - 1])).real() >= 0.0) return std::nan("");
    return -std::abs(multiplier(alternating));
}

double onset(std::span<const double> controls, std::span<const double> multipliers) {
    for (std::size_t i = 1; i < controls.size(); ++i) {
        const double before = std::log(multipliers[i - 1]), after = std::log(multipliers[i]);
        if (before < 0.0 && after >= 0.0)
            return controls[i - 1] - before * (controls[i] - controls[i - 1]) / (after - before);
    }
    return std::nan("");
}

}  // namespace shaken::compare
