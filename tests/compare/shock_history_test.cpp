// SPDX-License-Identifier: MIT
#include "compare/shock_history.hpp"

#include <cmath>

#include "synthetic.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

constexpr double frequency = 0.1;
constexpr double speed = 7.0;  // of the front, in the frame of the plate

struct Cycle {
    std::int64_t phases = 200;
    double formation = 0.12;
    double noise = 0.0;
    std::uint64_t seed = 1;

    double location(double phase) const { return 3.0 + speed * (phase - formation) / frequency; }

    /// No front before formation and after the front has gone beyond the layer by two sigma.
    std::vector<compare::PhaseMeasures> measures() const {
        std::vector<fields::Profile> profiles;
        const fields::Bins bins{0.0, 0.5, 80};
        for (std::int64_t k = 0; k < phases; ++k) {
            double phase = static_cast<double>(k) / static_cast<double>(phases);
            if (phase < formation - 0.1) phase += 1.0;  // a front formed late lives into the next cycle
            const double front = location(phase);
            const std::uint64_t s = seed * 1000 + static_cast<std::uint64_t>(k);
            const bool is_quiet = phase < formation - 1e-9 || front > 17.0;
            profiles.push_back(is_quiet ? synthetic::quiet_profile(bins, noise, s)
                                        : synthetic::Front{.location = front}.profile(bins, noise, s));
        }
        return synthetic::measure(std::move(profiles));
    }
    double upper_edge() const { return compare::find_layer(synthetic::Front{}.profile({0.0, 0.5, 80}))->upper; }
    double leaving() const { return formation + (upper_edge() - 3.0) / speed * frequency; }
};

}  // namespace

TEST_CASE("a front is followed from its first phase to the layer's edge, at its speed") {
    const double formation = GENERATE(0.12, 0.85);  // 0.85: leaves in the next cycle
    const Cycle cycle{.formation = formation};
    const auto history = compare::follow_shock(cycle.measures(), frequency);
    REQUIRE(history);
    CHECK(history->formation_phase == Approx(formation).margin(1e-12));  // a sampled phase
    // Truncation: locations within 0.05 sigma, which the front runs through in 0.0007 cycles.
    CHECK(history->leaving_phase == Approx(cycle.leaving()).margin(0.002));
    CHECK(history->mean_speed == Approx(speed).epsilon(0.01));
    CHECK(history->leaving_location == Approx(cycle.upper_edge()).margin(0.1));
}

TEST_CASE("noise in every bin leaves the history within a percent of a cycle") {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Cycle cycle{.noise = 0.03, .seed = seed};
        const auto history = compare::follow_shock(cycle.measures(), frequency);
        INFO("seed " << seed);
        REQUIRE(history);
        // Statistics: 3 % in T moves a location by about 0.1 sigma (shock_test.cpp), here 0.0015 cycles.
        CHECK(history->formation_phase == Approx(cycle.formation).margin(0.0051));
        CHECK(history->leaving_phase == Approx(cycle.leaving()).margin(0.01));
        CHECK(history->mean_speed == Approx(speed).epsilon(0.05));
    }
}

TEST_CASE("a shock is fully formed once T rises from the plate to its top") {
    // From phase 20 on T falls from the plate to the front; from phase 26 on it rises to the front first.
    std::vector<fields::Profile> profiles(100, synthetic::quiet_profile({0.0, 0.5, 80}));
    for (std::size_t k = 20; k < 50; ++k) {
        profiles[k] = synthetic::Front{.location = 5.0 + 0.5 * static_cast<double>(k - 20)}.profile({0.0, 0.5, 80});
        for (std::size_t i = 0; i < 10 && k < 26; ++i) profiles[k].temperature[i] += 4.0 - 0.4 * static_cast<double>(i);
    }
    const auto history = compare::follow_shock(synthetic::measure(profiles), frequency);
    REQUIRE(history);
    CHECK(history->formation_phase == Approx(0.20));
    CHECK(history->fully_formed_phase == Approx(0.26));
    CHECK(history->fully_formed_speed == Approx(0.5 * 100 * frequency).epsilon(0.02));  // truncation, as above
    CHECK_FALSE(history->follows_fully_formed(25, 100));
    CHECK(history->follows_fully_formed(26, 100));
    CHECK_FALSE(history->follows(19, 100));
}

TEST_CASE("where a cycle begins does not change what is found in it") {
    const auto measures = Cycle{}.measures();
    auto rotated = measures;
    std::rotate(rotated.begin(), rotated.begin() + 60, rotated.end());
    const auto plain = compare::follow_shock(measures, frequency);
    const auto turned = compare::follow_shock(rotated, frequency);
    REQUIRE((plain && turned));
    CHECK(turned->formation_phase == plain->formation_phase);
    CHECK(turned->mean_speed == Approx(plain->mean_speed).epsilon(1e-12));  // round-off
}

TEST_CASE("a cycle without a shock has no history") {
    std::vector<fields::Profile> profiles(100, synthetic::quiet_profile({0.0, 0.5, 80}));
    CHECK_FALSE(compare::follow_shock(synthetic::measure(profiles), frequency));
}

TEST_CASE("a shock that never reaches the edge has formed and not left") {
    std::vector<fields::Profile> profiles(100, synthetic::quiet_profile({0.0, 0.5, 80}));
    for (std::size_t k = 20; k < 40; ++k) profiles[k] = synthetic::Front{.location = 5.0}.profile({0.0, 0.5, 80});
    const auto history = compare::follow_shock(synthetic::measure(profiles), frequency);
    REQUIRE(history);
    CHECK(history->formation_phase == Approx(0.20));
    CHECK(std::isnan(history->leaving_phase));
    CHECK(std::isnan(history->mean_speed));
}

TEST_CASE("a single phase with a shock is noise") {
    std::vector<fields::Profile> profiles(100, synthetic::quiet_profile({0.0, 0.5, 80}));
    profiles[30] = synthetic::Front{.location = 5.0}.profile({0.0, 0.5, 80});
    CHECK_FALSE(compare::follow_shock(synthetic::measure(profiles), frequency));
}

TEST_CASE("a phase at which noise above the layer outdoes the shock is passed over") {
    const auto plain = compare::follow_shock(Cycle{}.measures(), frequency);
    REQUIRE(plain);
    const auto middle = static_cast<std::size_t>(std::lround(200.0 * (plain->formation_phase + 0.08)));
    auto measures = Cycle{}.measures();
    REQUIRE(measures[middle].shock);
    measures[middle].shock->location = measures[middle].layer->upper + 3.0;
    const auto noisy = compare::follow_shock(measures, frequency);
    REQUIRE(noisy);
    CHECK(noisy->passed_over == std::vector<std::int64_t>{static_cast<std::int64_t>(middle)});
    CHECK_FALSE(noisy->follows(static_cast<std::int64_t>(middle), 200));
    CHECK(noisy->leaving_phase == plain->leaving_phase);
    CHECK(noisy->mean_speed == plain->mean_speed);
    CHECK(noisy->fitted_speed == Approx(plain->fitted_speed).epsilon(1e-3));  // a point less of the line
    CHECK(plain->fitted_speed == Approx(speed).epsilon(0.02));                // truncation, as above
}

TEST_CASE("a location that jumps and stays has jumped") {
    // As where the fall next to the plate and the front change places while a deep layer's shock forms.
    auto measures = Cycle{}.measures();
    const auto plain = compare::follow_shock(measures, frequency);
    REQUIRE(plain);
    for (std::int64_t k = plain->first; k < plain->first + 6; ++k)
        measures[static_cast<std::size_t>(k)].shock->location -= 9.0;
    const auto jumping = compare::follow_shock(measures, frequency);
    REQUIRE(jumping);
    CHECK(jumping->passed_over.empty());
    CHECK(jumping->leaving_phase == plain->leaving_phase);
}

TEST_CASE("one phase of noise before a gap is not where a shock forms") {
    auto measures = Cycle{}.measures();
    const auto plain = compare::follow_shock(measures, frequency);
    REQUIRE(plain);
    const auto first = static_cast<std::size_t>(plain->first);
    REQUIRE(measures[first + 3].shock);
    for (const std::size_t hidden : {first + 1, first + 2}) measures[hidden].shock.reset();
    const auto later = compare::follow_shock(measures, frequency);
    REQUIRE(later);
    CHECK(later->first == plain->first + 3);
}
