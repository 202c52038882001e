// SPDX-License-Identifier: MIT
// What the driver needs of a run, and the run that both engines have: an engine, led from sample instant to sample
// instant, and a record of what is measured there.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>

#include "files/checkpoint.hpp"
#include "run/engines.hpp"
#include "run/output.hpp"
#include "run/stream.hpp"
#include "scene/schedule.hpp"

namespace shaken::run {

template <class Run>
concept EngineRun = requires(Run run, const Run& as_is, const AskedToStop& stop, const Emit& emit,
                             files::CheckpointWriter& out, const files::CheckpointReader& in, const Output& output) {
    { as_is.engine() } -> std::convertible_to<std::string>;
    { as_is.next_sample() } -> std::same_as<std::int64_t>;  // number of the sample instant to come
    { as_is.samples() } -> std::same_as<std::int64_t>;
    { as_is.phases() } -> std::same_as<std::int64_t>;  // sample instants a cycle
    { as_is.work() } -> std::same_as<double>;
    { as_is.work_unit() } -> std::convertible_to<std::string>;
    // To the next sample instant, and measure there; false where it stopped short of it, from where it goes on when
    // called again.
    { run.advance_and_sample(stop, emit) } -> std::same_as<bool>;
    { run.advance_to_end(stop) } -> std::same_as<bool>;
    as_is.save_state(out);   // where the engine stands: what another run may start from
    as_is.save_record(out);  // what is measured and not yet written
    run.restore(in, std::int64_t{});
    as_is.write(output);
};

template <class Engine, class Record>
class MeasuredRun {
    using Traits = EngineTraits<Engine>;

  public:
    /// Throws scene::SceneError, md::CannotSetUp, files::NoInput or Damaged.
    explicit MeasuredRun(const scene::Scene& scene)
        : scene_(Traits::resolved(scene)),
          schedule_(scene_),
          engine_(Traits::made(scene_)),
          record_(scene_),
          next_(schedule_.sample(scene::start_of(scene_))) {}

    std::string engine() const { return Traits::name; }
    std::int64_t next_sample() const { return next_; }
    std::int64_t samples() const { return schedule_.samples(); }
    std::int64_t phases() const { return schedule_.phases(); }
    double work() const { return Traits::work(engine_); }
    std::string work_unit() const { return Traits::work_unit; }

    bool advance_and_sample(const AskedToStop& stop, const Emit& emit) {
        const scene::Instant now = schedule_.instant(next_);
        if (!Traits::reach(engine_, schedule_, now, stop)) return false;
        record_.sample(engine_, now, emit);
        ++next_;
        return true;
    }
    bool advance_to_end(const AskedToStop& stop) { return Traits::reach_end(engine_, schedule_, stop); }

    void save_state(files::CheckpointWriter& out) const { engine_.save(out); }
    void save_record(files::CheckpointWriter& out) const { record_.save(out); }
    void restore(const files::CheckpointReader& in, std::int64_t next_sample) {
        next_ = next_sample;
        engine_.restore(in);
        record_.restore(in);
    }
    void write(const Output& output) const { record_.write(output); }

    const scene::Scene& scene() const { return scene_; }
    const Engine& state() const { return engine_; }
    const Record& record() const { return record_; }

  private:
    scene::Scene scene_;
    scene::Schedule schedule_;
    Engine engine_;
    Record record_;
    std::int64_t next_ = 0;
};

}  // namespace shaken::run
