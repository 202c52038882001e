// SPDX-License-Identifier: MIT
// Three Mach numbers of one cycle, each under its own name: of the layer that falls before the shock forms, of the gas
// ahead of the shock and of the gas behind it. In a made-up cycle all of them differ from phase to phase.
#include <cmath>

#include "compare/compare_file.hpp"
#include "compare/summary.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

constexpr std::int64_t phases = 50, formation = 9;  // a shock from ft = 0.18 on
const scene::PlateMotion motion{5.0, 0.1};

/// The layer at a phase: it falls faster and faster, and the gas behind the front moves, more and more, past the plate.
struct Phase {
    std::int64_t k;
    double inflow() const { return 8.0 + 0.1 * static_cast<double>(k); }
    double behind() const { return 0.05 + 0.01 * static_cast<double>(k); }
    synthetic::Front front() const {
        return {.location = k < formation ? -20.0 : 4.0 + 0.4 * static_cast<double>(k - formation), .inflow = inflow()};
    }
    double velocity(double z) const { return front().velocity(z) - behind(); }
    double mach(double z) const { return std::abs(velocity(z)) / std::sqrt(5.0 / 3.0 * front().temperature(z)); }
};

fields::PhaseMoments cycle() {
    fields::PhaseMoments moments(fields::Deposits::cells, phases, {0.0, 0.5, 80}, 1.0, 1, 1);
    for (std::int64_t k = 0; k < phases; ++k) {
        moments.begin_sample(0, k);
        const double plate = motion.velocity(static_cast<double>(k) / phases * motion.period());
        for (std::int64_t i = 0; i < 80; ++i) {
            const double z = 0.5 * (static_cast<double>(i) + 0.5);
            moments.add_slab(z - 0.25, z + 0.25, Phase{k}.front().volume_fraction(z) * 6.0 / std::numbers::pi,
                             {0.0, 0.0, plate + Phase{k}.velocity(z)}, Phase{k}.front().temperature(z));
        }
        moments.set_centre_of_mass(10.0);
    }
    return moments;
}

/// The middle of the bin, of those between two heights, with the largest of some quantity.
template <class Quantity>
double bin_of_largest(double from, double to, const Quantity& quantity) {
    double best = 0.25 + 0.5 * std::ceil((from - 0.25) / 0.5);
    for (double z = best; z <= to; z += 0.5)
        if (quantity(z) > quantity(best)) best = z;
    return best;
}

}  // namespace

TEST_CASE("before, ahead of and behind the shock each Mach number is that of its phase and place") {
    const auto measured = compare::measure(cycle(), motion, synthetic::ideal_gas());
    REQUIRE(measured.all.history);
    REQUIRE(measured.all.history->formation_phase == Approx(static_cast<double>(formation) / phases));
    const double layer_top = measured.all.measures[formation - 1].layer->upper;
    const Phase last_before{formation - 1};
    const double fastest = bin_of_largest(0.0, layer_top, [&](double z) { return last_before.mach(z); });
    // Round-off of the moments: T is a difference of squares of velocities of some ten.
    CHECK(measured.all.history->approach_mach == Approx(last_before.mach(fastest)).epsilon(1e-9));
    for (std::int64_t k = formation; k < formation + 15; ++k) {
        const Phase phase{k};
        INFO("phase " << k);
        const auto& shock = measured.all.measures[static_cast<std::size_t>(k)].shock;
        REQUIRE(shock);
        const double at = phase.front().location;
        const double top = bin_of_largest(0.0, at, [&](double z) { return phase.front().temperature(z); });
        const double foot = bin_of_largest(at, layer_top, [&](double z) { return -phase.front().temperature(z); });
        CHECK(shock->mach_below == Approx(phase.mach(top)).epsilon(1e-9));
        CHECK(shock->mach_above == Approx(phase.mach(foot)).epsilon(1e-9));
    }
}

TEST_CASE("summary and compare.h5 have them under their names") {
    const compare::Medium medium = synthetic::ideal_gas();
    const auto measured = compare::measure(cycle(), motion, medium);
    const auto summary = compare::summarise(measured, measured, {}, {}, {});
    const auto& shown = measured.all.measures[11].shock;  // ft = 0.22
    REQUIRE(shown);
    CHECK(summary.at("md").at("max_mach").get<double>() == measured.all.history->approach_mach);
    CHECK(summary.at("md").at("shock_mach").get<double>() == shown->mach_above);
    const support::TemporaryFolder folder;
    compare::write_compare_file(folder / "compare.h5", measured, measured, medium, {});
    const files::Hdf5File file(folder / "compare.h5", files::Open::read);
    const auto ahead = file.read<double>("/md/shock/mach_above"), largest = file.read<double>("/md/max_mach");
    for (std::size_t k = 0; k < phases; ++k) {
        const auto& of_phase = measured.all.measures[k];
        CHECK(largest[k] == of_phase.maximum_mach.value);
        if (of_phase.shock) CHECK(ahead[k] == of_phase.shock->mach_above);
    }
}
