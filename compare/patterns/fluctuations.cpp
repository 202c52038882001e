// SPDX-License-Identifier: MIT
#include "compare/patterns/fluctuations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "compare/jackknife.hpp"

namespace shaken::compare {

namespace {

constexpr std::size_t looked_at = 9, fewest_cycles = 40, most_blocks = 8;
constexpr double lowest_factor = 0.2, highest_factor = 1.05;  // what remembers less looks like the noise of a map

/// Best parts for given factors, and the squares that they leave.
struct Trial {
    TwoDecays decays;
    double squares;
};

Trial best_parts(std::span<const double> covariance, double p, double q) {
    double pp = 0.0, qq = 0.0, pq = 0.0, pc = 0.0, qc = 0.0;
    for (std::size_t l = 1; l < covariance.size(); ++l) {
        const double lasts = std::pow(p, static_cast<double>(l)), turns = std::pow(-q, static_cast<double>(l));
        pp += lasts * lasts;
        qq += turns * turns;
        pq += lasts * turns;
        pc += lasts * covariance[l];
        qc += turns * covariance[l];
    }
    const double determinant = pp * qq - pq * pq;
    double persistent = determinant > 0.0 ? (pc * qq - qc * pq) / determinant : -1.0;
    double alternating = determinant > 0.0 ? (qc * pp - pc * pq) / determinant : -1.0;
    if (persistent < 0.0 || alternating < 0.0) {
        const double alone_p = pp > 0.0 ? std::max(pc / pp, 0.0) : 0.0,
                     alone_q = qq > 0.0 ? std::max(qc / qq, 0.0) : 0.0;
        const bool lasts = alone_p * pc >= alone_q * qc;  // what each takes off the squares
        persistent = lasts ? alone_p : 0.0;
        alternating = lasts ? 0.0 : alone_q;
    }
    double squares = 0.0;
    for (std::size_t l = 1; l < covariance.size(); ++l) {
        const double left = covariance[l] - persistent * std::pow(p, static_cast<double>(l)) -
                            alternating * std::pow(-q, static_cast<double>(l));
        squares += left * left;
    }
    return {{persistent, p, alternating, q}, squares};
}

/// Waves by wavelength, the longest first; equal to round-off counts as equal.
std::map<std::int64_t, std::vector<std::size_t>> by_wavelength(std::span<const PlaneWave> waves) {
    std::map<std::int64_t, std::vector<std::size_t>> classes;
    for (std::size_t w = 0; w < waves.size(); ++w)
        classes[std::llround(1e9 * std::hypot(waves[w].kx, waves[w].ky))].push_back(w);
    return classes;
}

}  // namespace

std::vector<double> autocovariance(std::span<const Amplitude> amplitudes, std::size_t lags) {
    if (amplitudes.size() <= lags) throw std::invalid_argument("more lags than cycles");
    std::vector<double> covariance(lags);
    for (std::size_t l = 0; l < lags; ++l) {
        for (std::size_t c = 0; c + l < amplitudes.size(); ++c)
            covariance[l] += (amplitudes[c + l] * std::conj(amplitudes[c])).real();
        covariance[l] /= static_cast<double>(amplitudes.size() - l);
    }
    return covariance;
}

TwoDecays fit_two_decays(std::span<const double> covariance) {
    // A grid finds the basin, a search among eight neighbours its floor, which is a narrow valley where a factor is
    // small.
    constexpr int across = 12;
    constexpr double finest = 1e-5;
    const auto inside = [](double factor) { return lowest_factor <= factor && factor <= highest_factor; };
    double step = (highest_factor - lowest_factor) / across;
    Trial best = best_parts(covariance, lowest_factor, lowest_factor);
    const auto look = [&](double p, double q) {
        if (!inside(p) || !inside(q)) return false;
        const Trial trial = best_parts(covariance, p, q);
        const bool better = trial.squares < best.squares;
        if (better) best = trial;
        return better;
    };
    for (int i = 0; i <= across; ++i)
        for (int j = 0; j <= across; ++j) look(lowest_factor + step * i, lowest_factor + step * j);
    while (step > finest) {
        const TwoDecays middle = best.decays;
        bool better = false;
        for (const int i : {-1, 0, 1})
            for (const int j : {-1, 0, 1})
                better |= look(middle.persistent_factor + step * i, middle.alternating_factor + step * j);
        if (!better) step *= 0.5;
    }
    return best.decays;
}

MemoryError memory_error(double factor, double waves, double cycles) {
    const double longest = 1.0 - 1.0 / cycles;  // a longer memory than the run is not told from that
    const double square = std::pow(std::min(std::abs(factor), longest), 2), count = waves * cycles;
    return {std::sqrt((1.0 + square) / ((1.0 - square) * count)), std::sqrt((1.0 - square) / count)};
}

bool tells_its_factor(const Fluctuation& wave) {
    constexpr double uncertain = 0.15;
    const double factor = wave.decays.alternating_factor;
    return wave.errors.alternating_factor < uncertain && factor > lowest_factor + 0.01 &&
           factor < highest_factor - 0.001;
}

std::vector<Fluctuation> fluctuations(std::span<const PlaneWave> waves,
                                      const std::vector<std::vector<Amplitude>>& amplitudes, std::size_t most) {
    std::vector<Fluctuation> found;
    if (amplitudes.size() < fewest_cycles) return found;
    const std::size_t blocks = std::min(most_blocks, amplitudes.size() / (2 * looked_at));
    // Even: products of what lasts with what alternates then cancel at every lag.
    const std::size_t length = amplitudes.size() / blocks / 2 * 2;
    for (const auto& [wavenumber, members] : by_wavelength(waves)) {
        if (found.size() == most) break;
        std::vector<std::vector<double>> of_block(blocks, std::vector<double>(looked_at));
        for (std::size_t b = 0; b < blocks; ++b)
            for (const std::size_t w : members) {
                std::vector<Amplitude> series;
                for (std::size_t c = b * length; c < (b + 1) * length; ++c) series.push_back(amplitudes[c][w]);
                const std::vector<double> covariance = autocovariance(series, looked_at);
                for (std::size_t l = 0; l < looked_at; ++l) of_block[b][l] += waves[w].share * covariance[l];
            }
        const auto mean_without = [&](std::size_t left_out) {
            std::vector<double> mean(looked_at);
            const auto count = static_cast<double>(blocks - (left_out < blocks ? 1 : 0));
            for (std::size_t b = 0; b < blocks; ++b)
                for (std::size_t l = 0; l < looked_at && b != left_out; ++l) mean[l] += of_block[b][l] / count;
            return mean;
        };
        const std::vector<double> whole = mean_without(blocks);
        Fluctuation wave{2.0 * std::numbers::pi / (1e-9 * static_cast<double>(wavenumber)),
                         static_cast<std::int64_t>(members.size()),
                         whole[0],
                         fit_two_decays(whole),
                         {}};
        std::vector<TwoDecays> without;
        for (std::size_t b = 0; b < blocks; ++b) without.push_back(fit_two_decays(mean_without(b)));
        for (double TwoDecays::*part : {&TwoDecays::persistent, &TwoDecays::persistent_factor, &TwoDecays::alternating,
                                        &TwoDecays::alternating_factor}) {
            std::vector<double> values;
            for (const TwoDecays& decays : without) values.push_back(decays.*part);
            wave.errors.*part = jackknife_error(values);
        }
        const auto members_of = static_cast<double>(members.size()), cycles = static_cast<double>(amplitudes.size());
        for (const auto& [size, factor] : {std::pair{&TwoDecays::persistent, &TwoDecays::persistent_factor},
                                           std::pair{&TwoDecays::alternating, &TwoDecays::alternating_factor}}) {
            const MemoryError memory = memory_error(wave.decays.*factor, members_of, cycles);
            wave.errors.*size = std::max(wave.errors.*size, memory.relative * wave.decays.*size);
            wave.errors.*factor = std::max(wave.errors.*factor, memory.factor);
        }
        found.push_back(wave);
    }
    return found;
}

}  // namespace shaken::compare
