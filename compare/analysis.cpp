// SPDX-License-Identifier: MIT
#include "compare/analysis.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "compare/halves.hpp"
#include "compare/jackknife.hpp"

namespace shaken::compare {

bool Analysis::follows(std::int64_t phase) const {
    const auto count = static_cast<std::int64_t>(measures.size());
    const auto does = [&](const auto& shock) { return shock && shock->follows(phase, count); };
    return does(history) || does(second_history);
}

bool Analysis::follows_fully_formed(std::int64_t phase) const {
    const auto count = static_cast<std::int64_t>(measures.size());
    const auto does = [&](const auto& shock) {
        return shock && !std::isnan(shock->fully_formed_phase) && shock->follows_fully_formed(phase, count);
    };
    return does(history) || does(second_history);
}

Analysis analyse(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium,
                 const Layout& layout, const std::vector<bool>& kept_blocks) {
    Analysis analysis;
    for (std::int64_t cycle = 0; cycle < layout.cycles; ++cycle) {
        const fields::Flow flow = !layout.apart ? fields::Flow::both
                                  : cycle == 0  ? fields::Flow::first
                                                : fields::Flow::second;
        for (std::int64_t phase = 0; phase < moments.phases(); ++phase) {
            fields::Profile profile = moments.profile(phase, motion, kept_blocks, flow);
            profile.phase += static_cast<double>(cycle);
            analysis.measures.push_back(measure_phase(profile, medium));
            analysis.profiles.push_back(std::move(profile));
            analysis.centre_of_mass.push_back(moments.mean_centre_of_mass(phase, kept_blocks, flow).first);
        }
    }
    analysis.history = follow_shock(analysis.measures, motion.frequency, layout.cycles, 0);
    if (layout.cycles > 1)
        analysis.second_history = follow_shock(analysis.measures, motion.frequency, layout.cycles, 1);
    return analysis;
}

Measured measure(const fields::PhaseMoments& given, const scene::PlateMotion& motion, const Medium& medium,
                 const Layout& layout) {
    const fields::PhaseMoments moments = layout.apart ? given.in_whole_periods() : given;
    Measured measured{analyse(moments, motion, medium, layout), {}, layout, cycle_memory(moments, layout)};
    if (moments.blocks() < 2) return measured;
    for (std::int64_t block = 0; block < moments.blocks(); ++block)
        measured.without_block.push_back(
            analyse(moments, motion, medium, layout, fields::all_but(block, moments.blocks())));
    measured.halves = halves_of_blocks(static_cast<std::size_t>(moments.blocks()));
    for (const std::vector<bool>& half : measured.halves)
        measured.of_halves.push_back(analyse(moments, motion, medium, layout, half));
    return measured;
}

Estimate Measured::estimate(const std::function<double(const Analysis&)>& number) const {
    std::vector<double> replicas;
    for (const Analysis& analysis : without_block) replicas.push_back(number(analysis));
    return {number(all), memory.factor * jackknife_error(replicas)};
}

Estimate Measured::estimate_from_halves(const std::function<double(const Analysis&)>& number) const {
    std::vector<double> replicas;
    for (const Analysis& analysis : of_halves) replicas.push_back(number(analysis));
    return {number(all), memory.factor * error_from_halves(replicas, halves)};
}

std::vector<double> at_equal_phases(const std::vector<double>& values, std::int64_t wanted) {
    const auto count = static_cast<std::int64_t>(values.size());
    std::vector<double> picked;
    for (std::int64_t k = 0; k < wanted; ++k) {
        const std::int64_t below = k * count / wanted;
        const double share = static_cast<double>(k * count % wanted) / static_cast<double>(wanted);
        const double lower = values[static_cast<std::size_t>(below)];
        const double upper = values[static_cast<std::size_t>((below + 1) % count)];
        picked.push_back(share == 0.0 ? lower : (1.0 - share) * lower + share * upper);
    }
    return picked;
}

std::size_t nearest_phase(double phase, std::size_t phases, std::int64_t cycles) {
    return static_cast<std::size_t>(std::lround(phase * static_cast<double>(phases) / static_cast<double>(cycles))) %
           phases;
}

}  // namespace shaken::compare
