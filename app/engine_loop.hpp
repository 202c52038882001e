// SPDX-License-Identifier: MIT
// The one loop that drives either engine from sample instant to sample instant: measure, show progress, keep
// checkpoints, stop when asked. Nothing here can change a trajectory.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>

#include "app/options.hpp"
#include "app/progress.hpp"
#include "app/run_folder.hpp"
#include "app/signals.hpp"
#include "files/checkpoint.hpp"

namespace shaken::app {

/// Seconds this process has computed.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Wall and CPU seconds spent on a run, over all its restarts.
struct Spent {
    double wall = 0.0, cpu = 0.0;
};

enum class Outcome { finished, stopped };

/// Whether the user wants the run to end: a signal, or the limit of time.
using AskedToStop = std::function<bool()>;

/// An MD run looks for it so often between sample instants, some tenth of a second; counted by the engine's work, for
/// there may be few contacts between grains, or none.
inline constexpr std::int64_t predictions_between_looks = 300'000;

/// What the loop needs of an engine's run:
///   std::int64_t next_sample() const          number of the sample instant to come; phases of them a cycle
///   std::int64_t samples() const, phases() const
///   bool advance_and_sample(AskedToStop)      to that instant, measure there; false where it stopped short of it, from
///                                             where it goes on when called again
///   bool advance_to_end(AskedToStop)          from the last sample instant to the end of the last cycle, so that a run
///                                             ends in the same state however finely it is sampled; false as above
///   double work() const; std::string work_unit() const; std::string name() const
///   void save(files::CheckpointWriter&, const Spent&) const
template <class Run>
class EngineLoop {
  public:
    EngineLoop(Run& run, const EngineFiles& files, const EngineOptions& options, Spent before)
        : run_(run), files_(files), options_(options), before_(before), display_(options.quiet) {}

    Outcome go() {
        first_sample_ = run_.next_sample();
        first_work_ = run_.work();
        checkpoint();
        const auto must_stop = [this] { return stop_requested() || elapsed() >= options_.max_walltime; };
        while (run_.next_sample() < run_.samples()) {
            const bool reached = run_.advance_and_sample(must_stop);
            report("running");
            if (!reached || must_stop()) return stopped();
            if (take_checkpoint_request() || seconds_since(last_checkpoint_) >= options_.checkpoint_every) checkpoint();
        }
        if (!run_.advance_to_end(must_stop)) return stopped();
        checkpoint();  // the end of one run may be the start of another
        return Outcome::finished;
    }

    Spent spent() const { return {before_.wall + elapsed(), before_.cpu + cpu_seconds()}; }

    /// Where a run has failed but the state is the last sound one.
    void keep_last_state() { checkpoint(); }

    /// The last word on the run, after its files are written.
    void finish(const std::string& state) { report(state, true); }

  private:
    using Clock = std::chrono::steady_clock;
    static double seconds_since(Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    }
    double elapsed() const { return seconds_since(start_); }

    Outcome stopped() {
        checkpoint();
        report("stopped", true);
        return Outcome::stopped;
    }

    void checkpoint() {
        files::CheckpointWriter out;
        run_.save(out, spent());
        out.commit(files_.checkpoint());
        last_checkpoint_ = Clock::now();
    }

    void report(const std::string& state, bool last = false) {
        constexpr double status_interval = 0.5;  // seconds
        const bool status_due = last || seconds_since(last_status_) >= status_interval;
        if (!status_due && !display_.is_due()) return;
        Status status;
        status.engine = run_.name();
        status.state = state;
        const double phases = static_cast<double>(run_.phases());
        status.cycle = static_cast<double>(run_.next_sample()) / phases;
        status.cycles = static_cast<double>(run_.samples()) / phases;
        status.elapsed = elapsed();
        status.rate = (run_.work() - first_work_) / status.elapsed;
        status.rate_unit = run_.work_unit();
        const auto done = static_cast<double>(run_.next_sample() - first_sample_);
        const auto left = static_cast<double>(run_.samples() - run_.next_sample());
        status.remaining = done > 0.0 ? status.elapsed * left / done : HUGE_VAL;
        if (status_due) {
            write_status(files_.status(), status);
            last_status_ = Clock::now();
        }
        last ? display_.finish({status}) : display_.draw({status});
    }

    Run& run_;
    const EngineFiles& files_;
    const EngineOptions& options_;
    Spent before_;
    ProgressDisplay display_;
    std::int64_t first_sample_ = 0;
    double first_work_ = 0.0;
    Clock::time_point start_ = Clock::now(), last_checkpoint_ = start_, last_status_ = start_;
};

}  // namespace shaken::app
