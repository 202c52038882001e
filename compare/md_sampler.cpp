// SPDX-License-Identifier: MIT
#include "compare/md_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shaken::compare {

namespace {

constexpr std::int64_t most_blocks = 10;

}  // namespace

fields::Bins scene_bins(const scene::Scene& scene) {
    const double width = scene.sample.bin;
    return {0.0, width, static_cast<std::int64_t>(std::ceil(scene.continuum.lid / width - 1e-9))};
}

fields::PhaseMoments scene_moments(const scene::Scene& scene) {
    const scene::Sample& sample = scene.sample;
    return {sample.phases, scene_bins(scene), scene.box.x * scene.box.y, sample.average,
            std::min(sample.average, most_blocks)};
}

MdSampler::MdSampler(const scene::Scene& scene)
    : motion_(scene.motion),
      settle_(scene.sample.settle),
      average_(scene.sample.average),
      moments_(scene_moments(scene)) {}

void MdSampler::sample(const md::Snapshot& snapshot, std::int64_t cycle, std::int64_t phase) {
    if (cycle < settle_ || cycle >= settle_ + average_) return;
    moments_.begin_sample(cycle - settle_, phase);
    const double time = static_cast<double>(phase) / static_cast<double>(moments_.phases()) * motion_.period();
    const double plate = motion_.position(time);
    double sum = 0.0;
    for (std::size_t i = 0; i < snapshot.position.size(); ++i) {
        moments_.add_particle(snapshot.position[i][2] - plate, snapshot.velocity[i]);
        sum += snapshot.position[i][2];
    }
    moments_.set_centre_of_mass(sum / static_cast<double>(snapshot.position.size()));
}

void MdSampler::save(files::CheckpointWriter& out) const { moments_.save(out, "compare/md/"); }

void MdSampler::restore(const files::CheckpointReader& in) { moments_.restore(in, "compare/md/"); }

}  // namespace shaken::compare
