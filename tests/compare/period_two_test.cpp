// SPDX-License-Identifier: MIT
// What is made of a layer whose cycles alternate.
#include <cmath>
#include <filesystem>

#include "compare/compare_file.hpp"
#include "compare/layout.hpp"
#include "compare/summary.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

const scene::PlateMotion motion{5.0, 0.1};
constexpr std::int64_t phases = 40;
enum class Which { both, high, low };

/// Every other cycle is high: its shock forms at ft = 0.2, that of a low one at 0.5. Either may be left away.
fields::PhaseMoments run(std::int64_t cycles, std::int64_t blocks, Which which = Which::both) {
    fields::PhaseMoments moments(fields::Deposits::cells, phases, {0.0, 0.5, 80}, 1.0, cycles, blocks);
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
        const bool is_high = cycle % 2 == 0;
        if (which == (is_high ? Which::low : Which::high)) continue;
        synthetic::Normal normal(static_cast<std::uint64_t>(cycle) + 1);
        const double forms = is_high ? 0.2 : 0.5;
        for (std::int64_t phase = 0; phase < phases; ++phase) {
            const double ft = static_cast<double>(phase) / static_cast<double>(phases);
            const synthetic::Front front{.location = ft < forms - 1e-9 ? -20.0 : 2.0 + 60.0 * (ft - forms)};
            moments.begin_sample(cycle, phase);
            for (int i = 0; i < 400; ++i) {
                const double z = 0.1 * i + 0.05, n = front.volume_fraction(z) * 6.0 / std::numbers::pi;
                moments.add_slab(z - 0.05, z + 0.05, n,
                                 {0.0, 0.0, motion.velocity(ft * motion.period()) + front.velocity(z)},
                                 front.temperature(z));
            }
            moments.set_centre_of_mass((is_high ? 14.0 : 8.0) + 0.3 * normal());
        }
    }
    return moments;
}

const compare::Layout two_apart{2, true, 2}, repeated{1, false, 2};

compare::Measured measured(const fields::PhaseMoments& moments, const compare::Layout& layout = {}) {
    return compare::measure(moments, motion, synthetic::ideal_gas(), layout);
}

}  // namespace

TEST_CASE("a period of two is laid out over two cycles, each as if it had been averaged alone") {
    const compare::Analysis both = measured(run(6, 6), two_apart).all;
    REQUIRE(both.profiles.size() == 80);
    for (const bool is_second : {false, true}) {
        const compare::Analysis alone = measured(run(6, 6, is_second ? Which::low : Which::high)).all;
        for (std::size_t phase = 0; phase < 40; ++phase) {
            const std::size_t i = phase + (is_second ? 40 : 0);
            CHECK(both.profiles[i].phase == alone.profiles[phase].phase + (is_second ? 1.0 : 0.0));
            CHECK(both.profiles[i].plate_height == alone.profiles[phase].plate_height);
            // Round-off: T of the first flow is of a difference of sums.
            CHECK(both.profiles[i].temperature[10] == Approx(alone.profiles[phase].temperature[10]).epsilon(1e-9));
            CHECK(both.centre_of_mass[i] == Approx(alone.centre_of_mass[phase]).epsilon(1e-12));
        }
        const auto& history = is_second ? both.second_history : both.history;
        REQUIRE(history);
        REQUIRE(alone.history);
        CHECK(history->formation_phase == alone.history->formation_phase + (is_second ? 1.0 : 0.0));
        CHECK(history->leaving_phase == Approx(alone.history->leaving_phase + (is_second ? 1.0 : 0.0)).epsilon(1e-9));
        CHECK(history->mean_speed == Approx(alone.history->mean_speed).epsilon(1e-9));
    }
    CHECK(both.follows(10));
    CHECK_FALSE(both.follows(40 + 10));
    CHECK(both.follows(40 + 22));
    CHECK_FALSE(both.follows(22));
}

TEST_CASE("a shock that lives on into the second cycle belongs to the first") {
    std::vector<fields::Profile> profiles(80, synthetic::quiet_profile({0.0, 0.5, 80}));
    for (std::size_t k = 34; k < 49; ++k)
        profiles[k] = synthetic::Front{.location = 2.0 + 1.5 * static_cast<double>(k - 34)}.profile({0.0, 0.5, 80});
    const auto measures = synthetic::measure(profiles);
    const auto first = compare::follow_shock(measures, 0.1, 2, 0);
    REQUIRE(first);
    CHECK(first->last >= 40);
    CHECK_FALSE(compare::follow_shock(measures, 0.1, 2, 1));
}

TEST_CASE("a cycle that is shown twice is the same twice") {
    const compare::Analysis once = measured(run(6, 6, Which::high)).all,
                            twice = measured(run(6, 6, Which::high), repeated).all;
    for (std::size_t i = 0; i < 80; ++i) {
        CHECK(twice.profiles[i].density == once.profiles[i % 40].density);
        CHECK(twice.centre_of_mass[i] == once.centre_of_mass[i % 40]);
    }
    CHECK(twice.history->leaving_phase == once.history->leaving_phase);
    CHECK(twice.second_history->leaving_phase == Approx(once.history->leaving_phase + 1.0).epsilon(1e-12));
}

TEST_CASE("errors are those of the mean over the cycles of a flow") {
    const fields::PhaseMoments moments = run(10, 10);
    const compare::Measured m = measured(moments, two_apart);
    CHECK(m.without_block.size() == 5);
    for (const std::size_t i : {3u, 47u}) {
        const auto e = m.estimate([i](const compare::Analysis& a) { return a.centre_of_mass[i]; });
        double sum = 0.0, squares = 0.0;
        for (std::size_t cycle = i / 40; cycle < 10; cycle += 2) {
            const double z = moments.centre_of_mass()[cycle * 40 + i % 40];
            sum += z;
            squares += z * z;
        }
        CHECK(e.value == Approx(sum / 5.0).epsilon(1e-12));
        CHECK(e.error == Approx(std::sqrt((squares / 5.0 - sum * sum / 25.0) / 4.0)).epsilon(1e-6));  // round-off
        CHECK(e.error < 0.3);  // cycles mixed, six apart, have 0.95
    }
}

TEST_CASE("engines of one and of two cycles are both laid out over two, and it is said") {
    compare::Periods one{{1}}, two{{std::nullopt, 2}}, short_run{{std::nullopt}}, four{{4}};
    CHECK(compare::layouts_of(one, short_run).md.cycles == 1);
    CHECK(compare::notes_of_period("The MD", one, compare::layouts_of(one, one).md).empty());
    CHECK(compare::notes_of_period("The MD", short_run, compare::layouts_of(short_run, one).md).empty());
    const compare::Layouts mixed = compare::layouts_of(two, one);
    CHECK((mixed.md.apart && mixed.md.cycles == 2 && mixed.md.period == 2));
    CHECK((!mixed.continuum.apart && mixed.continuum.cycles == 2 && mixed.continuum.period == 1));
    const auto of_two = compare::notes_of_period("The MD", two, mixed.md);
    REQUIRE(of_two.size() == 2);
    CHECK_THAT(of_two[0], Contains("The MD has a period of 2 cycles: even and odd cycles are averaged apart"));
    CHECK_THAT(of_two[1], Contains("1 of 2 runs alternate"));
    CHECK_THAT(compare::notes_of_period("The continuum", one, mixed.continuum).at(0), Contains("shown twice"));
    CHECK_THAT(compare::notes_of_period("The MD", four, compare::layouts_of(four, one).md).at(1),
               Contains("mixes two flows"));
    two.keeps_flows_apart = false;
    const compare::Layouts unparted = compare::layouts_of(two, one);
    CHECK((!unparted.md.apart && unparted.md.cycles == 1 && unparted.md.period == 2));
    CHECK_THAT(compare::notes_of_period("The MD", two, unparted.md).at(0), Contains("run it again"));
    one.opposite_share = 0.12;
    CHECK_THAT(compare::notes_of_period("The MD", one, {1, false, 1}).at(0), Contains("12 % of the area"));
}

TEST_CASE("files and summary of a period of two have both cycles, those of a period of one are as ever") {
    const support::TemporaryFolder folder;
    const compare::Medium medium = synthetic::ideal_gas();
    const auto md = measured(run(10, 10), two_apart), continuum = measured(run(10, 10, Which::high), repeated);
    compare::write_compare_file(folder / "two.h5", md, continuum, medium, {});
    const files::Hdf5File two(folder / "two.h5", files::Open::read);
    CHECK(two.shape("/md/temperature") == files::Shape{80, 80});
    CHECK(two.read_number_attribute("/phase", "period") == 2.0);
    CHECK(two.read_number_attribute("/md", "period") == 2.0);
    CHECK(two.read_number_attribute("/continuum", "period") == 1.0);
    CHECK(two.read_number("/md/shock/second_cycle/formation_phase") == md.all.second_history->formation_phase);
    CHECK(two.read<std::int64_t>("/md/shock/followed")[40 + 22] == 1);

    const auto summary = compare::summarise(md, continuum, scene::Scene{}, {}, {});
    const auto& m = summary.at("md");
    CHECK(m.at("period") == 2);
    CHECK(m.at("zcm").size() == 40);
    CHECK(m.at("zcm_error").size() == 40);
    CHECK(m.at("zcm")[25] == md.all.centre_of_mass[50]);
    CHECK(m.at("shock").at("formation_phase") == md.all.history->formation_phase);
    CHECK(m.at("second_cycle").at("shock").at("formation_phase") == md.all.second_history->formation_phase);
    CHECK(m.at("second_cycle").contains("max_mach_error"));
    // The continuum repeats the high cycle: it agrees with the first and is six too high in the second, of z = 8.
    CHECK(summary.at("zcm_rms_percent").get<double>() == Approx(100.0 * 0.75 / std::sqrt(2.0)).epsilon(0.05));
    // A phase is resolved to one of forty a cycle.
    CHECK(m.at("shock").at("formation_phase_error").get<double>() == Approx(1.0 / 40.0 / std::sqrt(12.0)).margin(1e-6));

    const auto plain = measured(run(10, 10, Which::high), {1, false, 1});
    compare::write_compare_file(folder / "one.h5", plain, plain, medium, {});
    const files::Hdf5File one(folder / "one.h5", files::Open::read);
    CHECK(one.shape("/md/temperature") == files::Shape{40, 80});
    CHECK_FALSE(one.has("/md/shock/second_cycle"));
    const auto short_summary = compare::summarise(plain, plain, scene::Scene{}, {}, {});
    CHECK(short_summary.at("md").at("zcm").size() == 20);
    CHECK(short_summary.at("md").at("period") == 1);
    CHECK_FALSE(short_summary.at("md").contains("second_cycle"));
}
