// SPDX-License-Identifier: MIT
// A continuum run of a scene with an exact solution, in one piece: it hears a wish to stop, and begins anew when it is
// resumed.
#pragma once

#include <optional>
#include <string>

#include "continuum/verification.hpp"
#include "run/engine_run.hpp"
#include "scene/scene.hpp"

namespace shaken::run {

class VerificationRun {
  public:
    /// Throws scene::SceneError for wrong names.
    explicit VerificationRun(const scene::Scene& scene);

    std::string engine() const { return "continuum"; }
    std::int64_t next_sample() const { return found_ ? 1 : 0; }
    std::int64_t samples() const { return 1; }
    std::int64_t phases() const { return 1; }
    double work() const { return found_ ? static_cast<double>(found_->steps) : 0.0; }
    std::string work_unit() const { return "steps/s"; }
    bool advance_and_sample(const AskedToStop& stop, const Emit&);
    bool advance_to_end(const AskedToStop&) { return true; }
    void save_state(files::CheckpointWriter&) const {}
    void save_record(files::CheckpointWriter&) const {}
    void restore(const files::CheckpointReader&, std::int64_t) {}

    /// continuum.h5 (profiles and provenance), verification.csv and summary.json, all written aside and renamed.
    void write(const Output& output) const;

    const continuum::Verification& found() const { return *found_; }

  private:
    scene::Scene scene_;
    std::optional<continuum::Verification> found_;
};

}  // namespace shaken::run
