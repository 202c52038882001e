// SPDX-License-Identifier: MIT
// One MD run of a homogeneous gas: temperature, fourth cumulant, pressure, collision rate and (of an elastic gas)
// self-diffusion, with standard errors that know how long the gas remembers, beside what the literature says.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/engine_loop.hpp"
#include "fields/time_series.hpp"
#include "md/simulation.hpp"
#include "scene/scene.hpp"
#include "scene/schedule.hpp"

namespace shaken::app {

/// A mean over the averaging time beside its reference.
struct Measured {
    std::string name;
    double value = 0.0, error = 0.0;  // standard error; NaN of a single sample
    double independent = 0.0;         // samples that would have this error without memory (fields/memory.hpp)
    bool is_too_short = false;        // to tell the error: it is what the memory found gives, at least
    std::optional<double> reference;
    std::string source;  // of the reference
};

class UniformRun {
  public:
    explicit UniformRun(const scene::Scene& scene);

    std::string name() const { return "md"; }
    std::int64_t next_sample() const { return next_; }
    /// The start and the end of the run are both sampled.
    std::int64_t samples() const { return schedule_.samples(); }
    std::int64_t phases() const { return schedule_.phases(); }
    double work() const { return static_cast<double>(simulation_.counters().pair_collisions); }
    std::string work_unit() const { return "collisions/s"; }
    bool advance_and_sample(const AskedToStop& asked_to_stop);
    bool advance_to_end(const AskedToStop&) { return true; }

    void save(files::CheckpointWriter& out, const Spent& spent) const;
    void restore(const files::CheckpointReader& in);

    /// md.h5 (frames and observables) and summary.json beside it, both written aside and renamed.
    void write(const std::filesystem::path& path, const Spent& spent, const std::string& parent) const;
    std::uint64_t state_hash() const { return simulation_.state_hash(); }
    md::Counters counters() const { return simulation_.counters(); }
    /// Of the averaging time so far.
    std::vector<Measured> results() const;

  private:
    void follow(const md::Snapshot& snapshot);

    scene::Scene scene_;
    scene::Schedule schedule_;
    md::Simulation simulation_;
    fields::TimeSeries series_;
    std::vector<md::Snapshot> frames_;
    // Of a gas in equilibrium, whose particles are followed through the box.
    std::int64_t window_ = 0;  // intervals after which displacements are counted anew; 0: they are not followed
    std::vector<std::array<double, 3>> last_, moved_;
    std::int64_t next_ = 0;
};

}  // namespace shaken::app
