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

fields::PhaseMoments scene_moments(const scene::Scene& scene, fields::Deposits deposits, fields::Heights heights) {
    const scene::Sample& sample = scene.sample;
    return {deposits,
            sample.phases,
            scene_bins(scene),
            scene.box.x * scene.box.y,
            sample.average,
            std::min(sample.average, most_blocks),
            heights};
}

fields::HorizontalGrid scene_map_grid(const scene::Scene& scene) {
    const double bin = scene.sample.map_bin;
    if (bin == 0.0) return {};
    const auto bins = [&](double length) { return std::max<std::int64_t>(1, std::llround(length / bin)); };
    return {bins(scene.box.x), bins(scene.box.y), scene.box.x, scene.box.y};
}

MdSampler::MdSampler(const scene::Scene& scene, fields::Heights heights)
    : motion_(scene.motion),
      schedule_(scene),
      moments_(scene_moments(scene, fields::Deposits::particles, heights)),
      maps_(scene_map_grid(scene)) {}

void MdSampler::sample(const md::Snapshot& snapshot, const scene::Instant& at) {
    if (schedule_.is_map(at)) {
        maps_.begin(at.cycle, schedule_.phase(at));
        for (const auto& r : snapshot.position) maps_.add_point(r[0], r[1], 1.0, r[2]);
        maps_.end();
    }
    if (!schedule_.is_averaged(at.cycle)) return;
    moments_.begin_sample(schedule_.averaged_cycle(at.cycle), at.phase_index);
    const double plate = motion_.position(schedule_.time_in_cycle(at));
    double sum = 0.0;
    for (std::size_t i = 0; i < snapshot.position.size(); ++i) {
        moments_.add_particle(snapshot.position[i][2] - plate, snapshot.velocity[i]);
        sum += snapshot.position[i][2];
    }
    moments_.set_centre_of_mass(sum / static_cast<double>(snapshot.position.size()));
}

void MdSampler::save(files::CheckpointWriter& out) const {
    moments_.save(out, "compare/md/");
    maps_.save(out, "compare/md/maps/");
}

void MdSampler::restore(const files::CheckpointReader& in) {
    moments_.restore(in, "compare/md/");
    maps_.restore(in, "compare/md/maps/");
}

}  // namespace shaken::compare
