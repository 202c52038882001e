// SPDX-License-Identifier: MIT
// Even and odd cycles of phase averages, apart.
#include <array>
#include <cmath>
#include <string>

#include "fields/phase_moments.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace fields;

namespace {

const scene::PlateMotion motion = scene::PlateMotion::from_acceleration(4.5, 0.095);
const Bins bins{0.0, 1.0, 6};

PhaseMoments empty(Deposits deposits, std::int64_t cycles, std::int64_t blocks) {
    return {deposits, 2, bins, 25.0, cycles, blocks};
}

/// A layer that is higher and faster in cycles of one parity.
void sample(PhaseMoments& moments, std::int64_t cycle, bool is_high, Deposits deposits) {
    const double lift = is_high ? 2.0 : 0.0, t = 1.0 + 0.1 * static_cast<double>(cycle);
    for (std::int64_t phase = 0; phase < 2; ++phase) {
        moments.begin_sample(cycle, phase);
        moments.set_centre_of_mass(10.0 + 5.0 * lift + t);
        if (deposits == Deposits::cells) {
            moments.add_slab(0.2 + lift, 3.7 + lift, 0.5 * t, {0.0, 0.0, 3.0 * lift + t}, 0.3 * t);
        } else {
            for (int i = 0; i < 60; ++i) {
                const double x = std::sin(7.0 * i + t);
                moments.add_particle(lift + 1.5 + 1.4 * x, {x * t, -x, 3.0 * lift + x});
            }
        }
    }
}

PhaseMoments run(Deposits deposits, std::int64_t cycles, std::int64_t blocks, bool starts_high = true) {
    PhaseMoments moments = empty(deposits, cycles, blocks);
    for (std::int64_t c = 0; c < cycles; ++c) sample(moments, c, (c % 2 == 0) == starts_high, deposits);
    return moments;
}

/// Round-off: of the sum of both flows, where one of them is their difference.
void check_alike(const Profile& one, const Profile& other, double round_off) {
    for (std::size_t i = 0; i < one.density.size(); ++i) {
        INFO("bin " << i);
        CHECK(one.density[i] == Approx(other.density[i]).epsilon(round_off));
        CHECK(std::isnan(one.temperature[i]) == std::isnan(other.temperature[i]));
        if (std::isnan(one.temperature[i])) continue;
        CHECK(one.velocity[i] == Approx(other.velocity[i]).margin(round_off));
        CHECK(one.temperature[i] == Approx(other.temperature[i]).margin(10.0 * round_off));
    }
}

}  // namespace

TEST_CASE("each flow is that of its own cycles, and both together are all") {
    const Deposits deposits = GENERATE(Deposits::particles, Deposits::cells);
    const std::int64_t blocks = GENERATE(1, 3, 10, 11);
    const PhaseMoments all = run(deposits, 11, blocks);
    PhaseMoments even = empty(deposits, 11, blocks), odd = even;
    for (std::int64_t c = 0; c < 11; ++c) sample(c % 2 == 0 ? even : odd, c, c % 2 == 0, deposits);
    check_alike(all.profile(1, motion, {}, Flow::first), even.profile(1, motion), 1e-12);
    check_alike(all.profile(1, motion, {}, Flow::second), odd.profile(1, motion), 1e-12);
    CHECK(all.mean_centre_of_mass(1, {}, Flow::first).first == Approx(even.mean_centre_of_mass(1).first));
    CHECK(all.mean_centre_of_mass(1, {}, Flow::second).first == Approx(odd.mean_centre_of_mass(1).first));
    // The flows are 6 apart in u and not in T: averaged together, T of a bin that both visit holds the difference.
    const double apart = all.profile(1, motion, {}, Flow::second).temperature_z[2];
    CHECK(all.profile(1, motion).temperature_z[2] > apart + 2.0);
}

TEST_CASE("exchanged flows are the same two, the other way round") {
    PhaseMoments moments = run(Deposits::particles, 12, 3);
    const PhaseMoments given = moments;
    moments.exchange_flows();
    check_alike(moments.profile(0, motion, all_but(1, 3), Flow::first),
                given.profile(0, motion, all_but(1, 3), Flow::second), 1e-12);
    check_alike(moments.profile(0, motion, all_but(1, 3), Flow::second),
                given.profile(0, motion, all_but(1, 3), Flow::first), 1e-12);
    CHECK(moments.mean_centre_of_mass(0, {}, Flow::first) == given.mean_centre_of_mass(0, {}, Flow::second));
    check_alike(moments.profile(0, motion), given.profile(0, motion), 0.0);
}

TEST_CASE("runs are averaged flow by flow, whichever cycle each of them began with") {
    for (const std::int64_t cycles : {9, 12}) {
        PhaseMoments one = run(Deposits::cells, cycles, 3, true), other = run(Deposits::cells, cycles, 3, false);
        other.exchange_flows();
        one.append(other);
        // Each flow has one speed and one height in both runs, so that nothing is mixed into its T.
        CHECK(one.profile(0, motion, {}, Flow::first).velocity[3] > 6.0);
        CHECK(one.profile(0, motion, {}, Flow::second).velocity[1] < 3.0);
        CHECK(std::isnan(one.profile(0, motion, {}, Flow::first).velocity[1]));
        CHECK(std::isnan(one.profile(0, motion, {}, Flow::second).velocity[4]));
        const double between =
            one.mean_centre_of_mass(0, {}, Flow::first).first - one.mean_centre_of_mass(0, {}, Flow::second).first;
        CHECK(between == Approx(10.0).margin(0.06));  // the drift of 0.1 a cycle, where cycles are odd in number
    }
}

TEST_CASE("leaving a block out leaves out whole periods where blocks are single cycles") {
    const PhaseMoments joined = run(Deposits::cells, 10, 10).in_whole_periods();
    CHECK(joined.blocks() == 5);
    const auto all = run(Deposits::cells, 10, 5);
    for (const Flow flow : {Flow::both, Flow::first, Flow::second}) {
        check_alike(joined.profile(1, motion, all_but(2, 5), flow), all.profile(1, motion, all_but(2, 5), flow), 1e-12);
        CHECK(joined.mean_centre_of_mass(1, all_but(2, 5), flow) == all.mean_centre_of_mass(1, all_but(2, 5), flow));
    }
    CHECK(run(Deposits::cells, 11, 10).in_whole_periods().blocks() == 5);
    CHECK(run(Deposits::cells, 20, 10).in_whole_periods().blocks() == 10);
}

TEST_CASE("flows come back from files and checkpoints; files of earlier versions have them where a block is a cycle") {
    const std::int64_t blocks = GENERATE(4, 8);
    const support::TemporaryFolder folder;
    const PhaseMoments straight = run(Deposits::particles, 8, blocks);
    PhaseMoments resumed = empty(Deposits::particles, 8, blocks);
    {
        PhaseMoments begun = resumed;
        for (std::int64_t c = 0; c < 3; ++c) sample(begun, c, c % 2 == 0, Deposits::particles);
        files::CheckpointWriter out;
        begun.save(out, "moments/");
        out.commit(folder / "a");
    }
    resumed.restore(files::CheckpointReader(folder / "a"), "moments/");
    for (std::int64_t c = 3; c < 8; ++c) sample(resumed, c, c % 2 == 0, Deposits::particles);
    {
        files::Hdf5File file(folder / "a.h5", files::Open::create);
        resumed.write(file, "/profiles");
        CHECK(file.has("/profiles/odd_sums") == (blocks < 8));
        for (const char* name : {"/sums", "/centre_of_mass"})
            file.write<double>("/earlier" + std::string(name), file.read<double>("/profiles" + std::string(name)),
                               file.shape("/profiles" + std::string(name)));
        file.write<std::int64_t>("/earlier/samples", file.read<std::int64_t>("/profiles/samples"),
                                 file.shape("/profiles/samples"));
        for (const char* name : {"/bin_lower", "/bin_width", "/area"})
            file.write("/earlier" + std::string(name), file.read_number("/profiles" + std::string(name)));
        file.write_text("/earlier/deposits", "particles");
    }
    const files::Hdf5File file(folder / "a.h5", files::Open::read);
    const PhaseMoments read = PhaseMoments::read(file, "/profiles"), earlier = PhaseMoments::read(file, "/earlier");
    for (const Flow flow : {Flow::both, Flow::first, Flow::second})
        CHECK(read.profile(1, motion, all_but(0, blocks), flow).density ==
              straight.profile(1, motion, all_but(0, blocks), flow).density);
    CHECK(earlier.keeps_flows_apart() == (blocks == 8));
    check_alike(earlier.profile(1, motion), straight.profile(1, motion), 0.0);
    if (blocks < 8) CHECK_THROWS_AS(earlier.profile(1, motion, {}, Flow::first), std::invalid_argument);
}
