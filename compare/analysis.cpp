// SPDX-License-Identifier: MIT
#include "compare/analysis.hpp"

#include <cmath>
#include <cstddef>

#include "compare/jackknife.hpp"

namespace shaken::compare {

Analysis analyse(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium,
                 std::optional<std::int64_t> left_out_block) {
    Analysis analysis;
    for (std::int64_t phase = 0; phase < moments.phases(); ++phase) {
        analysis.profiles.push_back(moments.profile(phase, motion, left_out_block));
        analysis.measures.push_back(measure_phase(analysis.profiles.back(), medium));
        analysis.centre_of_mass.push_back(moments.mean_centre_of_mass(phase, left_out_block).first);
    }
    analysis.history = follow_shock(analysis.measures, motion.frequency);
    return analysis;
}

Measured measure(const fields::PhaseMoments& moments, const scene::PlateMotion& motion, const Medium& medium) {
    Measured measured{analyse(moments, motion, medium), {}};
    if (moments.blocks() < 2) return measured;
    for (std::int64_t block = 0; block < moments.blocks(); ++block) {
        measured.without_block.push_back(analyse(moments, motion, medium, block));
    }
    return measured;
}

Estimate Measured::estimate(const std::function<double(const Analysis&)>& number) const {
    std::vector<double> replicas;
    for (const Analysis& analysis : without_block) replicas.push_back(number(analysis));
    return {number(all), jackknife_error(replicas)};
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

std::size_t nearest_phase(double phase, std::size_t phases) {
    return static_cast<std::size_t>(std::lround(phase * static_cast<double>(phases))) % phases;
}

}  // namespace shaken::compare
