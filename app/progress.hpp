// SPDX-License-Identifier: MIT
// How far a run is: one rewritten line an engine on a terminal, a plain line now and then elsewhere, and a status file
// that other programs may read. Says nothing that changes a result.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace shaken::app {

/// What is known of an engine's run at one instant; the content of DIR/ENGINE.status.json.
struct Status {
    std::string engine;
    std::string state = "running";  // running, finished, stopped, failed
    double cycle = 0.0;             // cycles done
    double cycles = 0.0;            // cycles wanted
    double rate = 0.0;              // work a second of wall time
    std::string rate_unit;          // "collisions/s", "steps/s"
    double elapsed = 0.0;           // seconds
    double remaining = 0.0;         // seconds, estimated

    std::string line() const;
    std::string json() const;
    static Status from_json(const std::string& text);  // throws std::exception on damage
};

/// Replaced by a rename; failing to write it is not an error of the run.
void write_status(const std::filesystem::path& path, const Status& status);

/// Draws the lines of one or more engines on stderr.
class ProgressDisplay {
  public:
    explicit ProgressDisplay(bool quiet);
    /// True when enough time has passed since the last drawing.
    bool is_due() const;
    void draw(const std::vector<Status>& engines);
    /// Leaves the last lines standing and goes below them.
    void finish(const std::vector<Status>& engines);

  private:
    using Clock = std::chrono::steady_clock;
    void rewrite(const std::vector<Status>& engines);
    bool quiet_, terminal_;
    Clock::time_point last_;
    std::size_t drawn_lines_ = 0;
};

}  // namespace shaken::app
