// SPDX-License-Identifier: MIT
// Short runs of a scene on this machine: columns of the continuum, one MD, and a patch of the continuum's full grid.
// Times are CPU seconds of this process, with what a run of the command samples.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "plan/heights.hpp"
#include "scene/scene.hpp"

namespace shaken::plan {

/// CPU seconds of this process.
double cpu_seconds();

/// The continuum's one column.
struct Column {
    Heights heights;
    double seconds_per_cycle = 0.0, steps_per_cycle = 0.0;
    double seconds_to_begin = 0.0;  // the solver, with its tables
    double seconds_to_leave = 0.0;  // two checkpoints and a file of averages, which grow with the lid
};

/// The MD in the cell of the scene that it was given.
struct Grains {
    Heights heights;
    std::int64_t settled = 0;     // cycles left out of the spread
    std::vector<double> seconds;  // of each cycle: the first ones, from a warm start, take more
    double seconds_once = 0.0;    // of every run: its particles, two checkpoints and a file of averages
    std::int64_t particles = 0;
    double bytes_per_particle = 0.0;
    double ceiling_contacts = 0.0;  // of each particle in a cycle
};

/// Of so many cycles from the start; those beyond the trial as its second half.
double seconds_of(const Grains& grains, std::int64_t cycles);

class Trials {
  public:
    /// budget: CPU seconds for the MD, and for the columns that are not needed.
    Trials(const scene::Scene& scene, double budget) : scene_(scene), budget_(budget) {}

    /// A run of at least so many cycles; nothing where the method fails on this grid, or, unless needed, the budget is
    /// used up.
    const Column* column(const std::string& scheme, double spacing, double lid, std::size_t cycles, bool needed);
    /// z_cm of a run of 48 cycles at twenty samples a cycle, for comparison with other lids and for the settling time.
    const Heights* under_lid(const std::string& scheme, double spacing, double lid);
    /// Of the planned scene: its particles and cell; settle cycles, then up to 96, at least 16. Where the grains
    /// collapse, nothing, or, if needed, the MD's own error.
    const Grains* grains(const scene::Scene& planned, std::int64_t settle, bool needed);
    /// CPU seconds to take one cell of the planned grid through one step, from a patch of at most 8 x 8 columns.
    double seconds_per_update(const scene::Scene& planned);

    /// CPU seconds before the first trial: what every run of the program takes to begin.
    double start_of_program() const { return begun_; }
    double spent() const { return cpu_seconds() - begun_; }
    const scene::Scene& scene() const { return scene_; }

  private:
    scene::Scene scene_;
    double budget_;
    double begun_ = cpu_seconds();
    double spent_columns_ = 0.0;
    std::map<std::tuple<std::string, double, double>, std::optional<Column>> columns_;
    std::map<std::tuple<std::string, double, double>, std::optional<Heights>> lids_;
    std::map<std::int64_t, std::optional<Grains>> grains_;  // by number of particles
    std::map<int, double> updates_;
};

}  // namespace shaken::plan
