// SPDX-License-Identifier: MIT
#include "compare/patterns/pattern_summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "compare/jackknife.hpp"
#include "compare/patterns/floquet.hpp"
#include "compare/patterns/polar_spectrum.hpp"

namespace shaken::compare {

namespace {

/// The maps of a window as amplitudes: [map][wave].
struct Observed {
    std::vector<std::int64_t> cycles;
    std::vector<std::vector<Amplitude>> amplitudes;
    std::vector<double> mean_height;

    std::vector<Amplitude> of_wave(std::size_t wave) const {
        std::vector<Amplitude> series;
        for (const auto& map : amplitudes) series.push_back(map[wave]);
        return series;
    }
};

Observed observe(const fields::HeightMaps& maps, const PatternWindow& window, MapTransform& transform) {
    Observed seen;
    for (const std::size_t row : maps.rows_at(window.phase, window.first)) {
        if (maps.cycle(row) >= window.first + window.cycles) break;
        const std::vector<double> map = maps.row(row);
        seen.cycles.push_back(maps.cycle(row));
        seen.amplitudes.push_back(transform.amplitudes(map));
        seen.mean_height.push_back(std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size()));
    }
    return seen;
}

/// Without the first map where their number is odd, so that they are whole periods of what alternates.
Observed whole_periods(Observed seen) {
    if (seen.cycles.size() > 1 && seen.cycles.size() % 2 == 1) {
        seen.cycles.erase(seen.cycles.begin());
        seen.amplitudes.erase(seen.amplitudes.begin());
        seen.mean_height.erase(seen.mean_height.begin());
    }
    return seen;
}

constexpr std::size_t most_blocks = 10, longest_waves = 16;

/// Where each block of whole periods begins, and the last one ends; one block of a single map.
std::vector<std::size_t> block_edges(std::size_t maps) {
    const std::size_t periods = maps / 2, blocks = std::clamp(periods, std::size_t{1}, most_blocks);
    std::vector<std::size_t> edges;
    for (std::size_t b = 0; b < blocks; ++b) edges.push_back(2 * (b * periods / blocks));
    edges.push_back(maps);
    return edges;
}

PowerSpectrum spectrum_without(const Observed& seen, const MapTransform& transform, std::size_t from, std::size_t to) {
    PowerSpectrum spectrum(transform);
    for (std::size_t i = 0; i < seen.amplitudes.size(); ++i)
        if (i < from || i >= to) spectrum.add(seen.amplitudes[i]);
    return spectrum;
}

std::vector<PatternBlock> blocks_of(const Observed& seen, const MapTransform& transform) {
    const std::vector<std::size_t> edges = block_edges(seen.amplitudes.size());
    std::vector<PatternBlock> found;
    for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
        PowerSpectrum spectrum(transform);
        for (std::size_t i = edges[b]; i < edges[b + 1]; ++i) spectrum.add(seen.amplitudes[i]);
        found.push_back({spectrum.mean_square(), spectrum.power_by_angle()});
    }
    return found;
}

/// A function of the mean spectrum with the error that leaving out blocks of cycles gives.
Measure measure(const Observed& seen, const MapTransform& transform,
                const std::function<double(const PowerSpectrum&)>& quantity) {
    const std::vector<std::size_t> edges = block_edges(seen.amplitudes.size());
    std::vector<double> without;
    for (std::size_t b = 0; b + 1 < edges.size() && edges.size() > 2; ++b)
        without.push_back(quantity(spectrum_without(seen, transform, edges[b], edges[b + 1])));
    return {quantity(spectrum_without(seen, transform, 0, 0)), jackknife_error(without)};
}

}  // namespace

PatternSummary summarise_pattern(const fields::HeightMaps& maps, const PatternWindow& window, std::size_t strongest) {
    MapTransform transform(maps.grid());
    const Observed all = observe(maps, window, transform), seen = whole_periods(all);
    if (seen.cycles.empty()) throw std::invalid_argument("no map at this phase in these cycles");
    const PowerSpectrum spectrum = spectrum_without(seen, transform, 0, 0);

    PatternSummary summary;
    summary.window = {window.phase, seen.cycles.front(), static_cast<std::int64_t>(seen.cycles.size())};
    summary.maps = spectrum.maps();
    summary.mean_square = measure(seen, transform, [](const PowerSpectrum& s) { return s.mean_square(); });
    summary.order = measure(seen, transform, [](const PowerSpectrum& s) { return s.order(); });
    summary.interpolated_order = measure(seen, transform, interpolated_order);
    const double height = std::accumulate(seen.mean_height.begin(), seen.mean_height.end(), 0.0) /
                          static_cast<double>(seen.mean_height.size());
    summary.mean_height = height;
    summary.relative_mean_square = {summary.mean_square.value / (height * height),
                                    summary.mean_square.error / (height * height)};
    summary.wavelength = spectrum.dominant_wavelength();
    summary.angle = spectrum.angle();

    double coherent = 0.0;
    std::vector<CoherentPart> parts;
    for (std::size_t w = 0; w < transform.waves().size(); ++w) {
        parts.push_back(coherent_part(seen.cycles, seen.of_wave(w)));
        const CoherentPart& part = parts.back();
        coherent += transform.waves()[w].share * (std::norm(part.mean) - part.error * part.error);
    }
    summary.coherent_share = coherent / summary.mean_square.value;

    const std::vector<double> power = spectrum.power();
    std::vector<std::size_t> by_power(power.size());
    std::iota(by_power.begin(), by_power.end(), std::size_t{0});
    std::stable_sort(by_power.begin(), by_power.end(), [&](auto a, auto b) { return power[a] > power[b]; });
    by_power.resize(std::min(strongest, by_power.size()));
    for (const std::size_t w : by_power) {
        WaveSummary wave{transform.waves()[w], std::abs(parts[w].mean), parts[w].error};
        wave.root_mean_square = std::sqrt(power[w] / wave.wave.share);
        wave.multiplier = wave.alternating_multiplier = std::nan("");
        if (all.cycles.size() > 1) {
            const Amplitude mu = multiplier(all.of_wave(w));
            wave.multiplier = std::copysign(std::abs(mu), mu.real());
        }
        if (all.cycles.size() > 3) wave.alternating_multiplier = alternating_multiplier(all.of_wave(w));
        summary.waves.push_back(wave);
    }
    summary.fluctuations = fluctuations(transform.waves(), seen.amplitudes, longest_waves);
    summary.blocks = blocks_of(seen, transform);
    return summary;
}

nlohmann::ordered_json to_json(const PatternSummary& s) {
    nlohmann::ordered_json json{{"phase", s.window.phase},
                                {"first_cycle", s.window.first},
                                {"maps", s.maps},
                                {"mean_square", s.mean_square.value},
                                {"mean_square_error", s.mean_square.error},
                                {"relative_mean_square", s.relative_mean_square.value},
                                {"relative_mean_square_error", s.relative_mean_square.error},
                                {"order", s.order.value},
                                {"order_error", s.order.error},
                                {"interpolated_order", s.interpolated_order.value},
                                {"interpolated_order_error", s.interpolated_order.error},
                                {"wavelength", s.wavelength},
                                {"angle", s.angle},
                                {"coherent_share", s.coherent_share},
                                {"mean_height", s.mean_height},
                                {"waves", nlohmann::ordered_json::array()},
                                {"fluctuations", nlohmann::ordered_json::array()},
                                {"blocks", nlohmann::ordered_json::array()}};
    for (const WaveSummary& w : s.waves) {
        json["waves"].push_back({{"waves_x", w.wave.mx},
                                 {"waves_y", w.wave.my},
                                 {"root_mean_square", w.root_mean_square},
                                 {"coherent", w.coherent},
                                 {"coherent_error", w.coherent_error},
                                 {"multiplier", w.multiplier},
                                 {"alternating_multiplier", w.alternating_multiplier}});
    }
    for (const Fluctuation& f : s.fluctuations) {
        json["fluctuations"].push_back({{"wavelength", f.wavelength},
                                        {"waves", f.waves},
                                        {"power", f.power},
                                        {"persistent", f.decays.persistent},
                                        {"persistent_error", f.errors.persistent},
                                        {"persistent_factor", f.decays.persistent_factor},
                                        {"persistent_factor_error", f.errors.persistent_factor},
                                        {"alternating", f.decays.alternating},
                                        {"alternating_error", f.errors.alternating},
                                        {"alternating_factor", f.decays.alternating_factor},
                                        {"alternating_factor_error", f.errors.alternating_factor}});
    }
    for (const PatternBlock& b : s.blocks)
        json["blocks"].push_back({{"mean_square", b.mean_square}, {"power_by_angle", b.by_angle}});
    return json;
}

}  // namespace shaken::compare
