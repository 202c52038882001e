// SPDX-License-Identifier: MIT
// How far a run is, in a file that other programs may read. Says nothing that changes a result.
#pragma once

#include <filesystem>
#include <string>

namespace shaken::run {

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

}  // namespace shaken::run
