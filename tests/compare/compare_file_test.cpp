// SPDX-License-Identifier: MIT
#include "compare/compare_file.hpp"

#include <cmath>

#include "synthetic.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

const scene::PlateMotion motion{5.0, 0.1};

}  // namespace

TEST_CASE("what compare.h5 says of a run is what was measured of it") {
    const compare::Medium medium = synthetic::ideal_gas();
    const auto md = compare::measure(synthetic::run_with_front(4), motion, medium);
    const auto continuum = compare::measure(synthetic::run_with_front(1), motion, medium);
    REQUIRE(md.all.history);
    const support::TemporaryFolder folder;
    const auto path = folder / "compare.h5";
    compare::write_compare_file(path, md, continuum, medium, {});
    {
        const files::Hdf5File file(path, files::Open::read);
        CHECK(file.shape("/md/temperature") == files::Shape{40, 80});
        CHECK(file.shape("/md/temperature_error") == files::Shape{40, 80});
        CHECK_FALSE(file.has("/continuum/temperature_error"));  // one block: no error to give
        const std::size_t phase = 12, bin = 9;
        const fields::Profile& profile = md.all.profiles[phase];
        CHECK(file.read<double>("/md/temperature")[phase * 80 + bin] == profile.temperature[bin]);
        CHECK(file.read<double>("/md/density")[phase * 80 + bin] == profile.density[bin]);
        CHECK(file.read<double>("/md/mach")[phase * 80 + bin] == compare::mach_number(profile, bin, medium));
        CHECK(file.read<double>("/md/shock/location")[phase] == md.all.measures[phase].shock->location);
        CHECK(std::isnan(file.read<double>("/md/shock/location")[4]));
        CHECK(file.read<double>("/md/layer/upper")[phase] == md.all.measures[phase].layer->upper);
        CHECK(file.read_number("/md/shock/formation_phase") == md.all.history->formation_phase);
        CHECK(file.read<std::int64_t>("/md/shock/followed")[phase] == 1);
        CHECK(file.read<std::int64_t>("/md/shock/followed")[4] == 0);
        CHECK(file.read<double>("/height")[bin] == 4.75);
        CHECK(file.read<double>("/plate/height")[20] == Approx(10.0));
        CHECK(file.read_text_attribute("/md/velocity", "unit") == "sqrt(g sigma)");
        // The error of the velocity's mean over four blocks, by hand.
        std::vector<double> without;
        for (const auto& a : md.without_block) without.push_back(a.profiles[phase].velocity[bin]);
        double mean = 0.0, squares = 0.0;
        for (const double u : without) mean += u / 4.0;
        for (const double u : without) squares += (u - mean) * (u - mean);
        CHECK(file.read<double>("/md/velocity_error")[phase * 80 + bin] ==
              Approx(std::sqrt(0.75 * squares)).epsilon(1e-9));
    }
}

TEST_CASE("runs on different bins are not compared") {
    const compare::Medium medium = synthetic::ideal_gas();
    const auto one = compare::measure(fields::PhaseMoments(fields::Deposits::particles, 20, {0.0, 0.5, 80}, 1.0, 1, 1),
                                      motion, medium);
    const auto other = compare::measure(
        fields::PhaseMoments(fields::Deposits::particles, 20, {0.0, 1.0, 40}, 1.0, 1, 1), motion, medium);
    CHECK_THROWS_AS(compare::write_compare_file("/nowhere/compare.h5", one, other, medium, {}), std::invalid_argument);
}
