// SPDX-License-Identifier: MIT
// How far a run is: one rewritten line an engine on a terminal, a plain line now and then elsewhere.
#pragma once

#include <chrono>
#include <vector>

#include "run/status.hpp"

namespace shaken::app {

/// Draws the lines of one or more engines on stderr.
class ProgressDisplay {
  public:
    explicit ProgressDisplay(bool quiet);
    /// True when enough time has passed since the last drawing.
    bool is_due() const;
    void draw(const std::vector<run::Status>& engines);
    /// Leaves the last lines standing and goes below them.
    void finish(const std::vector<run::Status>& engines);

  private:
    using Clock = std::chrono::steady_clock;
    void rewrite(const std::vector<run::Status>& engines);
    bool quiet_, terminal_;
    Clock::time_point last_;
    std::size_t drawn_lines_ = 0;
};

}  // namespace shaken::app
