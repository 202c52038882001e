// SPDX-License-Identifier: MIT
#include "fields/phase_moments.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "files/errors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

using namespace fields;

namespace {

const scene::PlateMotion motion = scene::PlateMotion::from_acceleration(3.0, 0.095);
constexpr double roundoff = 1e-12;

struct Particle {
    double height;
    std::array<double, 3> velocity;
};

std::vector<Particle> random_particles(int count, unsigned seed) {
    std::mt19937_64 engine(seed);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
    std::vector<Particle> particles(static_cast<std::size_t>(count));
    for (Particle& p : particles) p = {9.0 * uniform(), {uniform() - 0.5, 4.0 * uniform(), 3.0 + 2.0 * uniform()}};
    return particles;
}

}  // namespace

TEST_CASE("profiles equal the naive double loop over bins and particles") {
    const Bins bins{0.0, 0.5, 20};
    PhaseMoments moments(Deposits::particles, 4, bins, 25.0, 3, 3);
    std::vector<Particle> all;
    for (std::int64_t cycle = 0; cycle < 3; ++cycle) {
        moments.begin_sample(cycle, 2);
        for (const Particle& p : random_particles(500, 10 + static_cast<unsigned>(cycle))) {
            moments.add_particle(p.height, p.velocity);
            all.push_back(p);
        }
    }
    const Profile profile = moments.profile(2, motion);
    for (std::int64_t b = 0; b < bins.count; ++b) {
        double count = 0;
        std::array<double, 3> mean{}, variance{};
        for (const Particle& p : all) {
            if (p.height < bins.edge(b) || p.height >= bins.edge(b + 1)) continue;
            ++count;
            for (std::size_t d = 0; d < 3; ++d) mean[d] += p.velocity[d];
        }
        for (double& m : mean) m /= count;
        for (const Particle& p : all) {
            if (p.height < bins.edge(b) || p.height >= bins.edge(b + 1)) continue;
            for (std::size_t d = 0; d < 3; ++d)
                variance[d] += (p.velocity[d] - mean[d]) * (p.velocity[d] - mean[d]) / (count - 1);
        }
        const auto i = static_cast<std::size_t>(b);
        CHECK(profile.density[i] == Approx(count / (25.0 * 0.5 * 3)).margin(roundoff));
        if (count == 0) {
            CHECK(std::isnan(profile.velocity[i]));
            continue;
        }
        REQUIRE(count > 1);
        CHECK(profile.velocity[i] == Approx(mean[2]).margin(roundoff));
        CHECK(profile.temperature[i] == Approx((variance[0] + variance[1] + variance[2]) / 3).margin(roundoff));
        CHECK(profile.temperature_z[i] == Approx(variance[2]).margin(roundoff));
        CHECK(profile.temperature_x[i] == Approx((variance[0] + variance[1]) / 2).margin(roundoff));
        CHECK(3.0 * profile.temperature[i] ==
              Approx(2.0 * profile.temperature_x[i] + profile.temperature_z[i]).margin(roundoff));
    }
}

TEST_CASE("slabs deposit all their mass, whatever the grids") {
    const double spacing = GENERATE(0.2, 0.37, 1.0, 3.1);
    PhaseMoments moments(Deposits::cells, 1, Bins{0.0, 0.5, 40}, 4.0, 1, 1);
    moments.begin_sample(0, 0);
    double deposited = 0.0;
    for (double z = 0.0; z + spacing <= 20.0; z += spacing) {
        const double density = 1.0 + std::sin(z);
        moments.add_slab(z, z + spacing, density, {0, 0, 1}, 0.5);
        deposited += density * spacing;
    }
    const Profile p = moments.profile(0, motion);
    double found = 0.0;
    for (const double n : p.density) found += 0.5 * n;
    CHECK(found == Approx(deposited).epsilon(roundoff));
}

TEST_CASE("a uniform slab gives its own density, velocity and temperature") {
    PhaseMoments moments(Deposits::cells, 1, Bins{0.0, 0.5, 10}, 9.0, 1, 1);
    moments.begin_sample(0, 0);
    for (double z = 0.0; z < 4.95; z += 0.1) moments.add_slab(z, z + 0.1, 0.8, {0.1, 0.2, -4.0}, 2.5);
    const Profile p = moments.profile(0, motion);
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(p.density[i] == Approx(0.8).epsilon(roundoff));
        CHECK(p.velocity[i] == Approx(-4.0).epsilon(roundoff));
        CHECK(p.temperature[i] == Approx(2.5).epsilon(1e-11));  // round-off of second moment minus square
    }
}

TEST_CASE("a velocity gradient inside a bin adds its spread to T_z alike for slabs and particles") {
    // u = s z over a bin of width w: the spread is (s w)^2/12; 200 sublayers leave a relative truncation of 1/200^2.
    const double slope = 3.0, width = 2.0;
    PhaseMoments cells(Deposits::cells, 1, Bins{0.0, width, 1}, 1.0, 1, 1),
        grains(Deposits::particles, 1, Bins{0.0, width, 1}, 1.0, 1, 1);
    cells.begin_sample(0, 0);
    grains.begin_sample(0, 0);
    for (int i = 0; i < 200; ++i) {
        const double z = (i + 0.5) * width / 200;
        cells.add_slab(z - width / 400, z + width / 400, 1.0, {0, 0, slope * z}, 0.0);
        grains.add_particle(z, {0, 0, slope * z});
    }
    const double spread = slope * width * slope * width / 12;
    CHECK(cells.profile(0, motion).temperature_z[0] == Approx(spread).epsilon(1e-4));
    CHECK(grains.profile(0, motion).temperature_z[0] == Approx(spread * 200 / 199).epsilon(1e-4));
}

TEST_CASE("T of particles is the true one in bins that few of them visit") {
    // A uniform deviate of width 1 has the variance 1/12, and its fourth moment gives that of T from M of them:
    // (1/80 - (M - 3)/(M - 1)/144)/M a component. Bins of one particle say nothing.
    const int visitors = GENERATE(1, 2, 3, 10);
    constexpr std::int64_t bins = 4000;
    PhaseMoments moments(Deposits::particles, 1, Bins{0.0, 1.0, bins}, 1.0, 1, 1);
    moments.begin_sample(0, 0);
    std::mt19937_64 engine(7);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
    for (std::int64_t b = 0; b < bins; ++b)
        for (int i = 0; i < visitors; ++i)
            moments.add_particle(static_cast<double>(b) + 0.5, {uniform(), uniform(), 5.0 + uniform()});
    const Profile p = moments.profile(0, motion);
    double mean = 0.0, mean_z = 0.0;
    for (std::size_t b = 0; b < bins; ++b) {
        mean += p.temperature[b] / bins;
        mean_z += p.temperature_z[b] / bins;
    }
    INFO(visitors << " particles a bin");
    if (visitors == 1) {
        CHECK(std::all_of(p.temperature.begin(), p.temperature.end(), [](double t) { return std::isnan(t); }));
        CHECK(p.velocity[0] > 5.0);
        return;
    }
    const double m = visitors, of_one = std::sqrt((1.0 / 80 - (m - 3) / (m - 1) / 144) / m);
    CHECK(std::abs(mean_z - 1.0 / 12) < 4.0 * of_one / std::sqrt(bins));  // statistics: four standard errors
    CHECK(std::abs(mean - 1.0 / 12) < 4.0 * of_one / std::sqrt(3.0 * bins));
}

TEST_CASE("what is not known is not a number: empty bins, and phases that were never sampled") {
    PhaseMoments moments(Deposits::particles, 2, Bins{0.0, 1.0, 2}, 1.0, 1, 1);
    moments.begin_sample(0, 1);
    moments.add_particle(0.5, {0.0, 0.0, 1.0});
    moments.add_particle(0.5, {0.0, 0.0, 1.0});
    const Profile sampled = moments.profile(1, motion), never = moments.profile(0, motion);
    CHECK(sampled.temperature[0] == 0.0);  // two of one velocity
    CHECK(sampled.density[1] == 0.0);      // that nothing was there is known
    CHECK(std::isnan(sampled.velocity[1]));
    CHECK(std::isnan(sampled.temperature[1]));
    CHECK(std::isnan(sampled.temperature_x[1]));
    CHECK(std::isnan(never.density[0]));
    CHECK(std::isnan(moments.profile(1, motion, all_but(0, 1)).temperature[0]));
    CHECK(std::isnan(moments.mean_centre_of_mass(1).second));
}

TEST_CASE("leaving out a block equals never having sampled it") {
    PhaseMoments all(Deposits::particles, 1, Bins{0.0, 1.0, 9}, 25.0, 4, 2),
        half(Deposits::particles, 1, Bins{0.0, 1.0, 9}, 25.0, 4, 2);
    for (std::int64_t cycle = 0; cycle < 4; ++cycle) {
        all.begin_sample(cycle, 0);
        all.set_centre_of_mass(static_cast<double>(cycle));
        if (cycle < 2) half.begin_sample(cycle, 0);
        for (const Particle& p : random_particles(100, static_cast<unsigned>(cycle))) {
            all.add_particle(p.height, p.velocity);
            if (cycle < 2) half.add_particle(p.height, p.velocity);
        }
    }
    CHECK(all.profile(0, motion, all_but(1, 2)).density == half.profile(0, motion).density);
    CHECK(all.profile(0, motion, all_but(1, 2)).temperature == half.profile(0, motion).temperature);
    CHECK(all.mean_centre_of_mass(0).first == 1.5);
    CHECK(all.mean_centre_of_mass(0).second == 1.0);  // blocks 0.5 and 2.5: spread sqrt(2), over sqrt(2)
    CHECK(all.mean_centre_of_mass(0, all_but(1, 2)).first == 0.5);
}

TEST_CASE("sums go on from a checkpoint and from a file as if never put down") {
    const support::TemporaryFolder folder;
    const auto fill = [](PhaseMoments& m, std::int64_t cycle) {
        m.begin_sample(cycle, 1);
        m.set_centre_of_mass(3.0 + static_cast<double>(cycle));
        for (const Particle& p : random_particles(50, static_cast<unsigned>(cycle)))
            m.add_particle(p.height, p.velocity);
    };
    PhaseMoments straight(Deposits::particles, 2, Bins{0.0, 1.0, 9}, 25.0, 2, 2), first = straight, second = straight;
    fill(straight, 0);
    fill(straight, 1);
    fill(first, 0);
    files::CheckpointWriter out;
    first.save(out, "moments/");
    out.commit(folder / "a");
    second.restore(files::CheckpointReader(folder / "a"), "moments/");
    fill(second, 1);
    CHECK(second.profile(1, motion).temperature == straight.profile(1, motion).temperature);

    {
        files::Hdf5File file(folder / "a.h5", files::Open::create);
        second.write(file, "/profiles");
    }
    const PhaseMoments read = PhaseMoments::read(files::Hdf5File(folder / "a.h5", files::Open::read), "/profiles");
    CHECK(read.profile(1, motion).density == straight.profile(1, motion).density);
    CHECK(read.profile(1, motion).temperature == straight.profile(1, motion).temperature);
    CHECK(read.mean_centre_of_mass(1) == straight.mean_centre_of_mass(1));
}

TEST_CASE("a file that holds what is not a number is refused") {
    const support::TemporaryFolder folder;
    PhaseMoments moments(Deposits::particles, 1, Bins{0.0, 1.0, 10}, 25.0, 1, 1);
    moments.begin_sample(0, 0);
    moments.add_particle(1.5, {0.0, std::nan(""), 0.0});
    {
        files::Hdf5File file(folder / "a.h5", files::Open::create);
        moments.write(file, "/profiles");
    }
    CHECK_THROWS_AS(PhaseMoments::read(files::Hdf5File(folder / "a.h5", files::Open::read), "/profiles"),
                    files::Damaged);
}

TEST_CASE("impossible averages are refused") {
    CHECK_THROWS_AS(PhaseMoments(Deposits::particles, 0, Bins{0, 1, 1}, 1.0, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(PhaseMoments(Deposits::particles, 1, Bins{0, 1, 1}, 1.0, 1, 2), std::invalid_argument);
    PhaseMoments moments(Deposits::particles, 2, Bins{0, 1, 1}, 1.0, 1, 1);
    CHECK_THROWS_AS(moments.begin_sample(1, 0), std::out_of_range);
    CHECK_THROWS_AS(moments.begin_sample(0, 2), std::out_of_range);
}

TEST_CASE("averaging over two runs is averaging over all their cycles, with the errors of all their blocks") {
    const Bins bins{0.0, 0.5, 18};
    PhaseMoments one(Deposits::particles, 2, bins, 25.0, 4, 2), other(Deposits::particles, 2, bins, 25.0, 2, 1),
        all(Deposits::particles, 2, bins, 25.0, 6, 3);
    for (std::int64_t cycle = 0; cycle < 6; ++cycle) {
        PhaseMoments& own = cycle < 4 ? one : other;
        own.begin_sample(cycle % 4, 1);
        all.begin_sample(cycle, 1);
        for (const Particle& p : random_particles(50, 20 + static_cast<unsigned>(cycle))) {
            own.add_particle(p.height, p.velocity);
            all.add_particle(p.height, p.velocity);
        }
        own.set_centre_of_mass(static_cast<double>(cycle));
        all.set_centre_of_mass(static_cast<double>(cycle));
    }
    one.append(other);
    CHECK(one.blocks() == 3);
    CHECK(one.cycles() == 6);
    CHECK(one.mean_centre_of_mass(1).first == 2.5);
    CHECK(one.mean_centre_of_mass(1).second == all.mean_centre_of_mass(1).second);
    for (const std::vector<bool>& kept : {std::vector<bool>{}, all_but(2, 3)}) {
        CHECK(one.profile(1, motion, kept).density == all.profile(1, motion, kept).density);
        CHECK(one.profile(1, motion, kept).temperature == all.profile(1, motion, kept).temperature);
    }
    CHECK_THROWS_AS(one.append(PhaseMoments(Deposits::particles, 4, bins, 25.0, 2, 1)), std::invalid_argument);
    CHECK_THROWS_AS(one.append(PhaseMoments(Deposits::particles, 2, bins, 25.0, 3, 1)), std::invalid_argument);
}

TEST_CASE("the first cycle of a run that began in its middle has every phase once, the earliest") {
    const Bins bins{0.0, 0.5, 20};
    PhaseMoments moments(Deposits::particles, 4, bins, 25.0, 2, 2);
    const auto sample = [&](std::int64_t cycle, std::int64_t phase) {
        moments.begin_sample(cycle, phase);
        moments.add_particle(1.0, {0.0, 0.0, static_cast<double>(10 * cycle + phase)});
        moments.set_centre_of_mass(static_cast<double>(10 * cycle + phase));
    };
    for (std::int64_t phase = 2; phase < 4; ++phase) sample(0, phase);
    for (std::int64_t phase = 0; phase < 4; ++phase) sample(1, phase);
    const PhaseMoments first = moments.first_cycle();
    const std::vector<double> expected{10.0, 11.0, 2.0, 3.0};
    CHECK(first.centre_of_mass() == expected);
    for (std::int64_t phase = 0; phase < 4; ++phase)
        CHECK(first.profile(phase, motion).velocity[2] == expected[static_cast<std::size_t>(phase)]);
    CHECK_THROWS_AS(PhaseMoments(Deposits::particles, 4, bins, 25.0, 20, 10).first_cycle(), std::invalid_argument);
}

TEST_CASE("what a stopped run has reached is its whole blocks, or its whole cycles before the first block ends") {
    const auto after = [](std::int64_t samples) {
        PhaseMoments moments(Deposits::particles, 4, {0.0, 0.5, 20}, 25.0, 12, 4);
        for (std::int64_t sample = 0; sample < samples; ++sample) {
            moments.begin_sample(sample / 4, sample % 4);
            moments.add_particle(0.25, {0.0, 0.0, static_cast<double>(sample / 4)});
            moments.set_centre_of_mass(static_cast<double>(sample));
        }
        return moments;
    };
    CHECK_FALSE(after(3).reached());
    const PhaseMoments early = *after(9).reached();  // two cycles and a piece of the first block of three
    CHECK(early.cycles() == 2);
    CHECK(early.blocks() == 1);
    CHECK(early.centre_of_mass().back() == 7.0);
    const PhaseMoments later = *after(4 * 8 + 1).reached();
    CHECK(later.cycles() == 6);
    CHECK(later.blocks() == 2);
    CHECK(later.profile(1, motion).velocity[0] == Approx(2.5).epsilon(roundoff));  // of cycles 0 to 5
    CHECK(later.profile(1, motion, {}, Flow::second).velocity[0] == Approx(3.0).epsilon(roundoff));
    CHECK(after(48).reached()->cycles() == 12);
}

TEST_CASE("heights that are passed on are known at their instant, and neither kept nor written") {
    const support::TemporaryFolder folder;
    PhaseMoments moments(Deposits::particles, 4, {0.0, 0.5, 20}, 25.0, 12, 4, Heights::passed_on);
    moments.begin_sample(3, 1);
    moments.set_centre_of_mass(7.5);
    CHECK(moments.latest_centre_of_mass() == 7.5);
    CHECK(moments.centre_of_mass().empty());
    files::Hdf5File file(folder / "a.h5", files::Open::create);
    moments.write(file, "/profiles");
    CHECK(file.has("/profiles/sums"));
    CHECK_FALSE(file.has("/profiles/centre_of_mass"));
}
