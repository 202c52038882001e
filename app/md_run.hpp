// SPDX-License-Identifier: MIT
// One run of the MD engine with everything measured of it: engine, binning, time series, frames.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/engine_loop.hpp"
#include "compare/md_sampler.hpp"
#include "fields/time_series.hpp"
#include "md/simulation.hpp"
#include "scene/scene.hpp"
#include "scene/schedule.hpp"

namespace shaken::app {

/// The knobs of the method, from [md].
md::Options md_options_of(const scene::Scene& scene);

/// A kept frame in a checkpoint.
void save_frame(files::CheckpointWriter& out, std::size_t number, const md::Snapshot& frame);
md::Snapshot restore_frame(const files::CheckpointReader& in, std::size_t number);

class MdRun {
  public:
    explicit MdRun(const scene::Scene& scene);

    std::string name() const { return "md"; }
    std::int64_t next_sample() const { return next_; }
    std::int64_t samples() const { return schedule_.samples(); }
    std::int64_t phases() const { return schedule_.phases(); }
    double work() const { return static_cast<double>(simulation_.counters().pair_collisions); }
    std::string work_unit() const { return "collisions/s"; }
    bool advance_and_sample(const AskedToStop& asked_to_stop);
    bool advance_to_end(const AskedToStop& asked_to_stop);

    void save(files::CheckpointWriter& out, const Spent& spent) const;
    void restore(const files::CheckpointReader& in);

    /// md.h5: H5MD frames of the last cycle, profiles, observables, provenance. Written aside and renamed.
    void write(const std::filesystem::path& path, const Spent& spent, const std::string& parent) const;
    std::uint64_t state_hash() const { return simulation_.state_hash(); }
    md::Counters counters() const { return simulation_.counters(); }

  private:
    scene::Scene scene_;
    scene::Schedule schedule_;
    std::string scene_text_;  // as printed when the run began
    md::Simulation simulation_;
    compare::MdSampler sampler_;
    fields::TimeSeries series_;
    std::vector<md::Snapshot> frames_;  // of the last cycle, at equal phases
    std::int64_t next_ = 0;
};

}  // namespace shaken::app
