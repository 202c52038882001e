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

fields::PhaseMoments scene_moments(const scene::Scene& scene, fields::Deposits deposits) {
    const scene::Sample& sample = scene.sample;
    return {deposits,          sample.phases,
            scene_bins(scene), scene.box.x * scene.box.y,
            sample.average,    std::min(sample.average, most_blocks)};
}

fields::HorizontalGrid scene_map_grid(const scene::Scene& scene) {
    const double bin = scene.sample.map_bin;
    if (bin == 0.0) return {};
    const auto bins = [&](double length) { return std::max<std::int64_t>(1, std::llround(length / bin)); };
    return {bins(scene.box.x), bins(scene.box.y), scene.box.x, scene.box.y};
}

bool is_map(const scene::Sample& sample, std::int64_t phase) {
    return sample.map_bin > 0.0 && phase % (sample.phases / sample.maps) == 0;
}

MdSampler::MdSampler(const scene::Scene& scene)
    : motion_(scene.motion),
      times_(scene.sample),
      moments_(scene_moments(scene, fields::Deposits::particles)),
      maps_(scene_map_grid(scene)) {}

void MdSampler::sample(const md::Snapshot& snapshot, std::int64_t cycle, std::int64_t phase) {
    if (is_map(times_, phase)) {
        maps_.begin(cycle, static_cast<double>(phase) / static_cast<double>(times_.phases));
        for (const auto& at : snapshot.position) maps_.add_point(at[0], at[1], 1.0, at[2]);
        maps_.end();
    }
    if (cycle < times_.settle || cycle >= times_.settle + times_.average) return;
    moments_.begin_sample(cycle - times_.settle, phase);
    const double time = static_cast<double>(phase) / static_cast<double>(moments_.phases()) * motion_.period();
    const double plate = motion_.position(time);
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
