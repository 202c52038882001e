// SPDX-License-Identifier: MIT
#include "compare/independence.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "files/errors.hpp"

namespace shaken::compare {

namespace {

/// z_cm of every sample: its phase and its bits.
using Samples = std::set<std::pair<std::size_t, std::uint64_t>>;

Samples samples_of(const AveragedRun& run) {
    const auto phases = static_cast<std::size_t>(run.scene.sample.phases);
    Samples samples;
    for (std::size_t i = 0; i < run.centre_of_mass.size(); ++i)
        if (const double height = run.centre_of_mass[i]; !std::isnan(height))
            samples.emplace(i % phases, std::bit_cast<std::uint64_t>(height));
    return samples;
}

bool start_alike(const scene::Scene& one, const scene::Scene& other) {
    return one.initial.file.empty() && other.initial.file.empty() && one.md.seed == other.md.seed &&
           one.initial.seed == other.initial.seed;
}

/// In cycles, wherever they stand in either run.
double shared_by(const Samples& one, const Samples& other, std::int64_t phases) {
    double shared = 0.0;
    for (const auto& sample : other) shared += one.contains(sample) ? 1.0 : 0.0;
    return shared / static_cast<double>(phases);
}

}  // namespace

void refuse_dependent(const std::vector<AveragedRun>& runs) {
    constexpr double chance = 0.1;  // of a cycle
    std::vector<Samples> samples;
    for (const AveragedRun& run : runs) {
        samples.push_back(samples_of(run));
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            const AveragedRun& earlier = runs[i];
            const auto refuse = [&](const std::string& common) {
                throw files::Damaged(
                    fmt::format("{} and {} are not independent: {}; an average is over runs of other "
                                "seeds, or from other states",
                                earlier.path.string(), run.path.string(), common));
            };
            std::error_code ignored;
            if (std::filesystem::equivalent(earlier.path, run.path, ignored)) refuse("they are one file");
            if (start_alike(earlier.scene, run.scene))
                refuse(fmt::format("they start alike, md.seed = {} and initial.seed = {}", run.scene.md.seed,
                                   run.scene.initial.seed));
            const double shared = shared_by(samples[i], samples.back(), run.scene.sample.phases);
            if (shared >= chance) refuse(fmt::format("they share {:.3g} cycles bit for bit", shared));
        }
    }
}

}  // namespace shaken::compare
