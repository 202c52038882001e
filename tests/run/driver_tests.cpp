// SPDX-License-Identifier: MIT
// The driver with a run of its own kind, whose state is a sum: what is kept where, and what a resumed run goes on from.
#include "run/driver.hpp"

#include <fstream>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using run::Outcome;

namespace {

/// Adds up the numbers of its samples; its output is the sum and the rows.
class Sum {
  public:
    explicit Sum(std::int64_t samples) : samples_(samples) {}
    std::string engine() const { return "md"; }
    std::int64_t next_sample() const { return next_; }
    std::int64_t samples() const { return samples_; }
    std::int64_t phases() const { return 1; }
    double work() const { return static_cast<double>(next_); }
    std::string work_unit() const { return "sums/s"; }
    bool advance_and_sample(const run::AskedToStop&, const run::Emit& emit) {
        sum_ += next_;
        const double row[]{static_cast<double>(next_), 0.0, static_cast<double>(sum_)};
        emit(run::Stream::row, row);
        ++next_;
        return true;
    }
    bool advance_to_end(const run::AskedToStop&) { return true; }
    void save_state(files::CheckpointWriter& out) const { out.put("sum", sum_); }
    void save_record(files::CheckpointWriter& out) const { out.put("record", sum_); }
    void restore(const files::CheckpointReader& in, std::int64_t next_sample) {
        next_ = next_sample;
        sum_ = in.take_one<std::int64_t>("record");
    }
    void write(const run::Output& output) const {
        files::Hdf5File file(output.path, files::Open::create);
        run::write_streams(file, output, {{{"sum", "1"}}, [](std::span<const double>) {}});
    }

  private:
    std::int64_t samples_, next_ = 0, sum_ = 0;
};

static_assert(run::EngineRun<Sum>);

/// Stops after so many samples.
run::Controls stopping_after(int samples) {
    run::Controls controls;
    controls.asked_to_stop = [samples]() mutable { return --samples <= 0; };
    return controls;
}

Outcome begin(const run::EngineFiles& files, const run::Controls& controls, std::int64_t samples = 10) {
    Sum sum(samples);
    return run::Driver(sum, files, controls, {"a scene", "", {}, 0}).go();
}

Outcome resume(const run::EngineFiles& files, const run::Controls& controls, std::int64_t samples = 10) {
    const files::CheckpointReader in(files.checkpoint());
    Sum sum(samples);
    sum.restore(in, in.take_one<std::int64_t>("next_sample"));
    return run::Driver(sum, files, controls,
                       {in.take_text("scene"), files.checkpoint().string(), in.take_one<run::Spent>("spent"),
                        in.take_one<std::uint64_t>("stream_length")})
        .go();
}

std::vector<double> sums_of(const run::EngineFiles& files) {
    return files::Hdf5File(files.output(), files::Open::read).read<double>("/observables/sum/value");
}

const std::vector<double> all{0, 1, 3, 6, 10, 15, 21, 28, 36, 45};

}  // namespace

TEST_CASE("a run that ends leaves its output, and a checkpoint without what the output has") {
    const support::TemporaryFolder folder;
    const run::EngineFiles files{folder.path(), "md"};
    REQUIRE(begin(files, {}) == Outcome::finished);
    CHECK(sums_of(files) == all);
    const files::CheckpointReader in(files.checkpoint());
    CHECK(in.take_one<std::int64_t>("sum") == 45);
    CHECK_FALSE(in.has("record"));
    CHECK_FALSE(in.has("stream_length"));
    CHECK_FALSE(std::filesystem::exists(files.stream()));
}

TEST_CASE("a stopped run goes on where it stopped, and loses and repeats no row") {
    const support::TemporaryFolder folder;
    const run::EngineFiles files{folder.path(), "md"};
    REQUIRE(begin(files, stopping_after(4)) == Outcome::stopped);
    CHECK_FALSE(std::filesystem::exists(files.output()));
    CHECK(files::CheckpointReader(files.checkpoint()).take_one<std::int64_t>("next_sample") == 4);
    REQUIRE(resume(files, stopping_after(3)) == Outcome::stopped);
    REQUIRE(resume(files, {}) == Outcome::finished);
    CHECK(sums_of(files) == all);
}

TEST_CASE("what a killed run had written behind its checkpoint is not read") {
    const support::TemporaryFolder folder;
    const run::EngineFiles files{folder.path(), "md"};
    REQUIRE(begin(files, stopping_after(4)) == Outcome::stopped);
    std::ofstream(files.stream(), std::ios::app | std::ios::binary) << "half a record";
    std::ofstream(files.output()) << "what somebody made of a part of the run";
    REQUIRE(resume(files, stopping_after(1)) == Outcome::stopped);
    CHECK_FALSE(std::filesystem::exists(files.output()));
    REQUIRE(resume(files, {}) == Outcome::finished);
    CHECK(sums_of(files) == all);
}

TEST_CASE("a stream shorter than its checkpoint says is refused") {
    const support::TemporaryFolder folder;
    const run::EngineFiles files{folder.path(), "md"};
    REQUIRE(begin(files, stopping_after(4)) == Outcome::stopped);
    std::filesystem::resize_file(files.stream(), std::filesystem::file_size(files.stream()) - 1);
    CHECK_THROWS_AS(resume(files, {}), files::Damaged);
}

TEST_CASE("a run stops at its time limit, keeps a checkpoint when asked, and shows how far it is") {
    const support::TemporaryFolder folder;
    const run::EngineFiles files{folder.path(), "md"};
    run::Controls controls;
    controls.max_walltime = 0.0;
    CHECK(begin(files, controls) == Outcome::stopped);
    controls = {};
    std::vector<std::int64_t> kept;
    std::vector<double> shown;
    controls.asked_for_checkpoint = [&] { return shown.size() == 5; };
    controls.show = [&](const run::Status& status, bool) {
        shown.push_back(status.cycle);
        kept.push_back(files::CheckpointReader(files.checkpoint()).take_one<std::int64_t>("next_sample"));
    };
    REQUIRE(begin(files, controls) == Outcome::finished);
    CHECK(shown == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    CHECK(kept == std::vector<std::int64_t>{0, 0, 0, 0, 0, 5, 5, 5, 5, 5});
}

TEST_CASE("checkpoint and stream grow by rows alone") {
    const support::TemporaryFolder folder;
    const run::EngineFiles few{folder / "few", "md"}, many{folder / "many", "md"};
    for (const auto& files : {few, many}) std::filesystem::create_directory(files.folder);
    REQUIRE(begin(few, stopping_after(10), 100'000) == Outcome::stopped);
    REQUIRE(begin(many, stopping_after(10'000), 100'000) == Outcome::stopped);
    CHECK(std::filesystem::file_size(many.checkpoint()) == std::filesystem::file_size(few.checkpoint()));
    const auto grown = std::filesystem::file_size(many.stream()) - std::filesystem::file_size(few.stream());
    CHECK(grown == 9'990 * (24 + 3 * 8));
}
