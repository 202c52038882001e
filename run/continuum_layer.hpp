// SPDX-License-Identifier: MIT
// What is measured of a shaken layer of the continuum: profiles by phase, totals, maps, cell fields, and where the
// equations hold, into continuum.h5.
#pragma once

#include "compare/continuum_sampler.hpp"
#include "compare/validity.hpp"
#include "continuum/closures/equation_of_state.hpp"
#include "run/engine_run.hpp"
#include "run/notes.hpp"
#include "scene/scene.hpp"

namespace shaken::run {

class ContinuumLayerRecord {
  public:
    /// scene: resolved (continuum/resolve.hpp).
    explicit ContinuumLayerRecord(const scene::Scene& scene);

    void sample(const continuum::Solver& solver, const scene::Instant& at, const Emit& emit);
    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);
    /// continuum.h5 and continuum.xdmf: frames, profiles, maps, observables, validity, notes, provenance.
    void write(const Output& output) const;

    /// Over the averaged cycles so far; NaN before them.
    compare::ValidityOfRun validity() const;
    Notes notes() const;
    const compare::ContinuumSampler& sampler() const { return sampler_; }

  private:
    /// What a run's notes are made from, summed up as it goes; in the checkpoint as it is.
    struct Books {
        compare::ValidityOfRun validity;  // means weighted by what a whole run has
        std::int64_t samples = 0;         // averaged
        double first_time = 0.0, first_lid_impulse = 0.0;
        double last_time = 0.0, last_lid_impulse = 0.0, last_mass = 0.0;
    };

    void book(const continuum::Solver& solver, const scene::Instant& at, const compare::Validity& now);
    std::int64_t first_sample() const { return schedule_.sample(scene::start_of(scene_)); }
    std::int64_t samples_to_average() const;
    /// Mean normal force on the upper end over the cycles averaged, per weight of the layer; 0 before the second
    /// sample.
    double force_on_upper_end() const;

    scene::Scene scene_;
    scene::Schedule schedule_;
    continuum::EquationOfState gas_;
    compare::ContinuumSampler sampler_;
    Books books_;
};

using ContinuumLayer = MeasuredRun<continuum::Solver, ContinuumLayerRecord>;

}  // namespace shaken::run
