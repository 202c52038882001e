// SPDX-License-Identifier: MIT
// One run of the continuum engine with everything measured of it: solver, binning, time series, frames.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/continuum_notes.hpp"
#include "app/engine_loop.hpp"
#include "compare/continuum_sampler.hpp"
#include "compare/validity.hpp"
#include "continuum/closures/equation_of_state.hpp"
#include "continuum/solver.hpp"
#include "fields/time_series.hpp"
#include "scene/scene.hpp"
#include "scene/schedule.hpp"

namespace shaken::app {

/// Cell fields at one sample instant, arrays (nz, ny, nx).
struct ContinuumFrame {
    std::int64_t sample = 0;
    std::vector<double> density, velocity_x, velocity_y, velocity_z, temperature;  // lab-frame velocity
};

class ContinuumRun {
  public:
    /// Throws scene::SceneError for a scene that cannot be resolved (continuum/resolve.hpp).
    explicit ContinuumRun(const scene::Scene& scene);

    std::string name() const { return "continuum"; }
    std::int64_t next_sample() const { return next_; }
    std::int64_t samples() const { return schedule_.samples(); }
    std::int64_t phases() const { return schedule_.phases(); }
    double work() const { return static_cast<double>(solver_.steps()); }
    std::string work_unit() const { return "steps/s"; }
    bool advance_and_sample(const AskedToStop& asked_to_stop);
    bool advance_to_end(const AskedToStop&) { return true; }

    void save(files::CheckpointWriter& out, const Spent& spent) const;
    void restore(const files::CheckpointReader& in);

    /// continuum.h5 and continuum.xdmf: frames of the last cycle, profiles, observables, provenance.
    void write(const std::filesystem::path& path, const Spent& spent, const std::string& parent) const;
    std::uint64_t state_hash() const { return solver_.state_hash(); }
    std::int64_t steps() const { return solver_.steps(); }
    /// Over the averaged cycles.
    compare::ValidityOfRun validity() const;
    Notes notes() const;

  private:
    ContinuumFrame frame() const;
    compare::Validity validity_now() const;
    /// Mean normal force on the upper end over the cycles averaged, per weight of the layer; 0 before the second
    /// sample.
    double force_on_upper_end() const;

    scene::Scene scene_;
    scene::Schedule schedule_;
    continuum::Solver solver_;
    continuum::EquationOfState gas_;
    compare::ContinuumSampler sampler_;
    fields::TimeSeries series_;
    std::vector<ContinuumFrame> frames_;  // of the last cycle, at equal phases
    std::int64_t next_ = 0;
};

}  // namespace shaken::app
