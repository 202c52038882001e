// SPDX-License-Identifier: MIT
#include "compare/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "compare/jackknife.hpp"
#include "compare/summary.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

const scene::PlateMotion motion{5.0, 0.1};

/// A run whose centre of mass is a known wave plus independent noise from cycle to cycle, over a fixed block of gas.
fields::PhaseMoments wavy_run(std::int64_t phases, std::int64_t cycles, std::int64_t blocks, double noise,
                              std::uint64_t seed = 1, double offset = 0.0) {
    synthetic::Normal normal(seed);
    fields::PhaseMoments moments(fields::Deposits::cells, phases, {0.0, 0.5, 40}, 4.0, cycles, blocks);
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
        for (std::int64_t phase = 0; phase < phases; ++phase) {
            const double ft = static_cast<double>(phase) / static_cast<double>(phases);
            moments.begin_sample(cycle, phase);
            moments.add_slab(1.0, 9.0, 0.5, {0.0, 0.0, 0.0}, 1.0);
            moments.set_centre_of_mass(12.0 + 3.0 * std::sin(2.0 * std::numbers::pi * ft) + offset + noise * normal());
        }
    }
    return moments;
}

compare::Measured measured(const fields::PhaseMoments& moments) {
    return compare::measure(moments, motion, synthetic::ideal_gas());
}

}  // namespace

TEST_CASE("the jackknife error of a mean is its analytic standard error") {
    const std::vector<double> x{3.1, 2.7, 4.4, 1.0, 2.2, 3.6};
    const auto n = static_cast<double>(x.size());
    double sum = 0.0, squares = 0.0;
    for (const double v : x) sum += v;
    for (const double v : x) squares += (v - sum / n) * (v - sum / n);
    std::vector<double> without;
    for (const double v : x) without.push_back((sum - v) / (n - 1.0));
    CHECK(compare::jackknife_error(without) ==
          Approx(std::sqrt(squares / (n * (n - 1.0)))).epsilon(1e-12));  // round-off
    CHECK(std::isnan(compare::jackknife_error(std::vector<double>{1.0})));
}

TEST_CASE("the error of the centre of mass is that of the mean of its blocks") {
    const fields::PhaseMoments moments = wavy_run(20, 12, 6, 0.3);
    const compare::Measured m = measured(moments);
    for (std::size_t phase : {0u, 7u, 19u}) {
        const compare::Estimate e = m.estimate([&](const compare::Analysis& a) { return a.centre_of_mass[phase]; });
        CHECK(e.error ==
              Approx(moments.mean_centre_of_mass(static_cast<std::int64_t>(phase)).second).epsilon(1e-9));  // round-off
        CHECK(std::abs(e.value - 12.0 - 3.0 * std::sin(2.0 * std::numbers::pi * static_cast<double>(phase) / 20.0)) <
              4.0 * 0.3 / std::sqrt(12.0));  // statistics: four standard errors of twelve cycles
    }
}

TEST_CASE("errors shrink with the square root of the number of cycles") {
    const auto error = [](std::int64_t cycles) {
        const compare::Measured m = measured(wavy_run(20, cycles, 10, 0.3));
        double sum = 0.0;
        for (std::size_t phase = 0; phase < 20; ++phase) {
            sum += m.estimate([&](const compare::Analysis& a) { return a.centre_of_mass[phase]; }).error;
        }
        return sum / 20.0;
    };
    // Statistics: an error from ten blocks is itself known to 1/sqrt(18), the mean of 20 of them to 5 %.
    CHECK(error(40) / error(160) == Approx(2.0).epsilon(0.25));
}

TEST_CASE("values at phases that exist are picked, at others interpolated round the cycle") {
    std::vector<double> wave(40);
    for (std::size_t k = 0; k < wave.size(); ++k) wave[k] = static_cast<double>(k);
    const auto picked = compare::at_equal_phases(wave, 20);
    CHECK(picked[0] == 0.0);
    CHECK(picked[7] == 14.0);
    const auto between = compare::at_equal_phases({0.0, 1.0, 2.0, 3.0}, 8);
    CHECK(between[3] == 1.5);
    CHECK(between[7] == 1.5);  // half way from 3 back to 0
}

TEST_CASE("the relative root mean square of two centres of mass is that of its definition") {
    const std::vector<double> md{10.0, 20.0};
    const std::vector<double> continuum{11.0, 19.0};
    // Interpolated to 20 phases, the relative difference runs linearly in numerator and denominator: summed directly.
    double squares = 0.0;
    for (int k = 0; k < 20; ++k) {
        const double share = (k % 10) / 10.0;
        const double m = k < 10 ? 10.0 + 10.0 * share : 20.0 - 10.0 * share;
        const double c = k < 10 ? 11.0 + 8.0 * share : 19.0 - 8.0 * share;
        squares += std::pow((c - m) / m, 2) / 20.0;
    }
    CHECK(compare::centre_of_mass_rms_percent(continuum, md) == Approx(100.0 * std::sqrt(squares)).epsilon(1e-12));
}

TEST_CASE("a continuum half a diameter too low agrees to round-off once its floor is lifted") {
    const std::vector<double> md{10.0, 20.5, 30.25, 20.5};
    std::vector<double> continuum = md;
    for (double& z : continuum) z -= 0.5;
    CHECK(compare::centre_of_mass_rms_percent(continuum, md, 0.5) < 1e-12);  // round-off
    CHECK(compare::centre_of_mass_rms_percent(continuum, md) > 1.0);
}

TEST_CASE("shock locations are compared where both engines have a shock, and lifted with the floor") {
    const auto cycle = [](double ahead, std::size_t forms) {
        compare::Analysis analysis;
        std::vector<fields::Profile> profiles(100, synthetic::quiet_profile({0.0, 0.5, 80}));
        for (std::size_t k = forms; k < 40; ++k) {
            const double location = 5.0 + 0.5 * static_cast<double>(k - 20) + ahead;
            profiles[k] = synthetic::Front{.location = location}.profile({0.0, 0.5, 80});
        }
        analysis.measures = synthetic::measure(profiles);
        analysis.history = compare::follow_shock(analysis.measures, 0.1);
        REQUIRE(analysis.history);
        return analysis;
    };
    const auto md = cycle(0.0, 20), behind = cycle(-0.5, 22);
    // Whole bins apart, so that the truncation is the same but for the slow rise of T behind the front.
    CHECK(compare::shock_location_rms(behind, md) == Approx(0.5).margin(2e-3));
    CHECK(compare::shock_location_rms(behind, md, 0.5) < 2e-3);
    CHECK(compare::shock_location_rms(behind, md, 0.0, compare::Life::fully_formed_to_leaving) ==
          Approx(0.5).margin(2e-3));
    compare::Analysis none = md;
    none.history.reset();
    CHECK(std::isnan(compare::shock_location_rms(none, md)));
}

TEST_CASE("the relative difference of fields is that of its definition, and a lift of one bin is a shift by one bin") {
    compare::Analysis md, higher;
    fields::Profile profile;
    profile.bins = {0.0, 0.5, 6};
    profile.plate_velocity = 2.0;
    profile.density = {0.3, 0.5, 0.7, 0.4, 0.2, 0.001};
    profile.velocity = {2.0, 1.0, -1.0, -3.0, -4.0, 50.0};
    profile.temperature = {1.0, 2.0, 3.0, 2.0, 1.0, 70.0};
    md.profiles = {profile};
    fields::Profile denser = profile;
    for (double& n : denser.density) n *= 1.1;
    for (double& u : denser.velocity) u = 2.0 + 0.9 * (u - 2.0);
    higher.profiles = {denser};
    CHECK(compare::profile_rms(higher, md, compare::Field::density) == Approx(0.1).epsilon(1e-12));  // round-off
    CHECK(compare::profile_rms(higher, md, compare::Field::velocity) == Approx(0.1).epsilon(1e-12));
    CHECK(compare::profile_rms(higher, md, compare::Field::temperature) == 0.0);
    compare::Analysis thin = higher, unseen = md;
    thin.profiles[0].velocity[2] = unseen.profiles[0].velocity[3] = std::nan("");
    CHECK(compare::profile_rms(thin, unseen, compare::Field::velocity) == Approx(0.1).epsilon(1e-12));
    fields::Profile lower = profile;
    for (auto* field : {&lower.density, &lower.velocity, &lower.temperature})
        std::rotate(field->begin(), field->begin() + 1, field->end());
    compare::Analysis fallen;
    fallen.profiles = {lower};
    CHECK(compare::profile_rms(fallen, md, compare::Field::temperature) > 0.3);
    // The lowest bin has nothing below it to be read from: it keeps its own value, (2 - 1)^2 of a sum of 19.
    CHECK(compare::profile_rms(fallen, md, compare::Field::temperature, 0.5) == Approx(std::sqrt(1.0 / 19.0)));
}

TEST_CASE("the summary has every key, an error beside each MD number, and null for what is unknown") {
    scene::Scene scene;
    scene.name = "wavy";
    compare::Cost md_cost{.wall_seconds = 2.0, .cpu_seconds = 1.5, .collisions_per_particle_per_cycle = 58.0};
    compare::Cost continuum_cost{.cpu_seconds = 0.5, .steps_per_cycle = 1100.0};
    const auto md = measured(wavy_run(40, 10, 5, 0.1));
    const auto continuum = measured(wavy_run(40, 10, 5, 0.0, 1, 0.12));
    const auto summary = compare::summarise(md, continuum, scene, md_cost, continuum_cost);

    for (const char* engine : {"md", "continuum"}) {
        INFO(engine);
        const auto& e = summary.at(engine);
        CHECK(e.at("zcm").size() == 20);
        for (const char* key : {"formation_phase", "leaving_phase", "mean_speed"}) CHECK(e.at("shock").contains(key));
        for (const char* key : {"max_mach", "width_over_mean_free_path", "wall_seconds", "cpu_seconds"})
            CHECK(e.contains(key));
    }
    const auto& m = summary.at("md");
    CHECK(m.at("zcm_error").size() == 20);
    double mean_error = 0.0;
    for (const auto& error : m.at("zcm_error")) mean_error += error.get<double>() / 20.0;
    CHECK(mean_error == Approx(0.1 / std::sqrt(10.0)).epsilon(0.25));  // statistics: of five blocks, 35 % / sqrt(20)
    for (const char* key : {"formation_phase_error", "leaving_phase_error", "mean_speed_error"}) {
        CHECK(m.at("shock").contains(key));
    }
    for (const char* key : {"max_mach_error", "width_over_mean_free_path_error", "collisions_per_particle_per_cycle"}) {
        CHECK(m.contains(key));
    }
    CHECK(m.at("shock").at("formation_phase").is_null());  // the block of gas has no shock
    CHECK(summary.at("continuum").at("steps_per_cycle") == 1100.0);
    CHECK(summary.at("continuum").at("wall_seconds").is_null());
    // Statistics: 0.12 above 12 is about 1 %; MD's noise, 0.1/sqrt(10), adds 0.3 % in quadrature.
    CHECK(summary.at("zcm_rms_percent").get<double>() == Approx(1.0).margin(0.25));
    // An offset at every phase: the mean of twenty independent errors of 0.0316 of 12, from five blocks (35 %).
    CHECK(summary.at("zcm_rms_percent_error").get<double>() == Approx(0.059).epsilon(1.0));
    CHECK(summary.at("zcm_rms_percent_error").get<double>() > 0.02);
    CHECK(summary.contains("zcm_rms_percent_half_diameter"));
    CHECK(summary.contains("shock_location_rms"));
    for (const char* key : {"density_rms", "velocity_rms", "temperature_rms", "temperature_rms_half_diameter_error"})
        CHECK(summary.contains(key));
    CHECK(summary.dump().find("nan") == std::string::npos);
}
