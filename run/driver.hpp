// SPDX-License-Identifier: MIT
// The one driver of every run: leads it from sample instant to sample instant, keeps what it lets go of in its stream,
// shows progress, keeps checkpoints, stops when asked, and writes its output at the end. Nothing here can change a
// trajectory.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "files/checkpoint_file.hpp"
#include "files/record_log.hpp"
#include "run/engine_run.hpp"
#include "run/folder.hpp"
#include "run/status.hpp"

namespace shaken::run {

/// Seconds this process has computed.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

enum class Outcome { finished, stopped };

/// What its surroundings want of a run, and are told.
struct Controls {
    AskedToStop asked_to_stop = [] { return false; };
    std::function<bool()> asked_for_checkpoint = [] { return false; };
    std::function<void(const Status&, bool last)> show = [](const Status&, bool) {};
    double max_walltime = std::numeric_limits<double>::infinity();  // seconds
    double checkpoint_every = 300.0;                                // seconds of wall time
};

/// Leads a run through its sample instants; false where it stopped. `after_sample` says whether to go on.
template <EngineRun Run>
bool lead(Run& run, const AskedToStop& stop, const Emit& emit, const std::function<bool()>& after_sample) {
    while (run.next_sample() < run.samples())
        if (!run.advance_and_sample(stop, emit) || !after_sample()) return false;
    return run.advance_to_end(stop);
}

/// What a run is that begins, or goes on from a checkpoint.
struct Origin {
    std::string scene_text;           // as printed when it began
    std::string parent;               // the checkpoint, or empty
    Spent before;                     // until then
    std::uint64_t stream_length = 0;  // bytes that the checkpoint vouches for
};

template <EngineRun Run>
class Driver {
  public:
    /// Cuts the stream back to where the run goes on from. Throws files::CannotCreate or Damaged.
    Driver(Run& run, const EngineFiles& files, const Controls& controls, Origin origin)
        : run_(run),
          files_(files),
          controls_(controls),
          origin_(std::move(origin)),
          stream_(files.stream(), origin_.stream_length) {
        std::filesystem::remove(files.output());  // of an earlier part of this run
    }

    Outcome go() {
        first_sample_ = run_.next_sample();
        first_work_ = run_.work();
        checkpoint();
        const auto must_stop = [this] { return controls_.asked_to_stop() || elapsed() >= controls_.max_walltime; };
        const auto emit = [this](Stream kind, std::span<const double> values) {
            stream_.append(static_cast<std::uint64_t>(kind), values);
        };
        const auto after_sample = [&] {
            report("running");
            if (must_stop()) return false;
            if (controls_.asked_for_checkpoint() || seconds_since(last_checkpoint_) >= controls_.checkpoint_every)
                checkpoint();
            return true;
        };
        const bool reached = lead(run_, must_stop, emit, after_sample);
        const std::uint64_t length = checkpoint();
        if (!reached) {
            report("stopped", true);
            return Outcome::stopped;
        }
        run_.write({files_.output(), files_.stream(), length, origin_.scene_text, origin_.parent, spent()});
        finish_checkpoint();
        std::filesystem::remove(files_.stream());
        return Outcome::finished;
    }

    Spent spent() const { return {origin_.before.wall + elapsed(), origin_.before.cpu + cpu_seconds()}; }

    /// Where a run has failed but the state is the last sound one.
    void keep_last_state() { checkpoint(); }

    /// The last word on the run.
    void finish(const std::string& state) { report(state, true); }

  private:
    using Clock = std::chrono::steady_clock;
    static double seconds_since(Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    }
    double elapsed() const { return seconds_since(start_); }

    void put_head(files::CheckpointWriter& out) const {
        out.put_text("scene", origin_.scene_text);
        out.put_text("engine", run_.engine());
        out.put("next_sample", run_.next_sample());
        out.put("spent", spent());
        run_.save_state(out);
    }

    /// The stream first: a checkpoint vouches for what is safe on the disk. Length of the stream.
    std::uint64_t checkpoint() {
        const std::uint64_t length = stream_.sync();
        files::CheckpointFile out(files_.checkpoint());
        put_head(out);
        run_.save_record(out);
        out.put("stream_length", length);
        out.commit();
        last_checkpoint_ = Clock::now();
        return length;
    }

    /// The end of one run may be the start of another; what was measured is in its output.
    void finish_checkpoint() const {
        files::CheckpointFile out(files_.checkpoint());
        put_head(out);
        out.commit();
    }

    void report(const std::string& state, bool last = false) {
        constexpr double status_interval = 0.5;  // seconds
        Status status;
        status.engine = run_.engine();
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
        if (last || seconds_since(last_status_) >= status_interval) {
            write_status(files_.status(), status);
            last_status_ = Clock::now();
        }
        controls_.show(status, last);
    }

    Run& run_;
    const EngineFiles& files_;
    const Controls& controls_;
    Origin origin_;
    files::RecordLog stream_;
    std::int64_t first_sample_ = 0;
    double first_work_ = 0.0;
    Clock::time_point start_ = Clock::now(), last_checkpoint_ = start_, last_status_ = start_;
};

}  // namespace shaken::run
