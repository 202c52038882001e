// SPDX-License-Identifier: MIT
// What is measured of a shaken layer of grains: profiles by phase, totals, maps and whole states, into md.h5.
#pragma once

#include "compare/md_sampler.hpp"
#include "run/engine_run.hpp"
#include "scene/scene.hpp"

namespace shaken::run {

class MdLayerRecord {
  public:
    explicit MdLayerRecord(const scene::Scene& scene);

    void sample(const md::Simulation& simulation, const scene::Instant& at, const Emit& emit);
    void save(files::CheckpointWriter& out) const { sampler_.save(out); }
    void restore(const files::CheckpointReader& in) { sampler_.restore(in); }
    /// md.h5: H5MD frames, profiles, maps, observables, provenance. Written aside and renamed.
    void write(const Output& output) const;

    const compare::MdSampler& sampler() const { return sampler_; }

  private:
    scene::Scene scene_;
    scene::Schedule schedule_;
    compare::MdSampler sampler_;
};

using MdLayer = MeasuredRun<md::Simulation, MdLayerRecord>;

}  // namespace shaken::run
