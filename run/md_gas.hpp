// SPDX-License-Identifier: MIT
// What is measured of a homogeneous gas of grains, into md.h5 and summary.json.
#pragma once

#include <array>
#include <vector>

#include "run/engine_run.hpp"
#include "run/gas_results.hpp"
#include "scene/scene.hpp"

namespace shaken::run {

class MdGasRecord {
  public:
    explicit MdGasRecord(const scene::Scene& scene);

    void sample(const md::Simulation& simulation, const scene::Instant& at, const Emit& emit);
    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);
    /// md.h5 (frames and observables) and summary.json beside it, both written aside and renamed.
    void write(const Output& output) const;

  private:
    /// Mean square displacement since the start of the present window; NaN where particles are not followed.
    double displacement(const md::Snapshot& snapshot, std::int64_t sample);

    scene::Scene scene_;
    scene::Schedule schedule_;
    // Of a gas in equilibrium, whose particles are followed through the box.
    std::int64_t window_;  // intervals after which displacements are counted anew; 0: they are not followed
    std::vector<std::array<double, 3>> last_, moved_;
};

using MdGas = MeasuredRun<md::Simulation, MdGasRecord>;

/// What the md.h5 of a gas says, averaged.
std::vector<Measured> gas_results(const scene::Scene& scene, const std::filesystem::path& file);

}  // namespace shaken::run
