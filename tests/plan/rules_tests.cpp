// SPDX-License-Identifier: MIT
#include "plan/rules.hpp"

#include "compare/scenes.hpp"
#include "plan/wish.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

scene::Scene stripes(const std::vector<std::string>& changes) {
    return compare::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/ch5_stripes.toml", changes);
}

}  // namespace

TEST_CASE("the formula's wavelength of the source's stripes") {
    // 5.4 (1 + 1.1 0.4174^-1.32), worked out by hand; round-off of the last digit.
    CHECK(plan::pattern_wavelength(stripes({})) == Approx(24.2216).epsilon(1e-5));
}

TEST_CASE("a square that holds waves is 3D, a strip 2D, a box below one wave 1D") {
    CHECK(plan::needed_dimension(stripes({})) == 3);
    CHECK(plan::needed_dimension(stripes({"box.y=10", "particles.number=2520"})) == 2);
    CHECK(plan::needed_dimension(stripes({"box.x=10", "particles.number=2520"})) == 2);
    CHECK(plan::needed_dimension(stripes({"box.x=12", "box.y=12", "particles.number=864"})) == 1);
    CHECK_FALSE(plan::holds_pattern(stripes({"box.x=12", "box.y=12", "particles.number=864"})));
    CHECK(plan::may_hold_pattern(stripes({"box.x=12", "box.y=12", "particles.number=864"})));
    CHECK_FALSE(plan::may_hold_pattern(stripes({"box.x=8", "box.y=8", "particles.number=384"})));
}

TEST_CASE("a flat layer's cell keeps the particles an area, and never grows") {
    const scene::Scene wide = compare::read_scene(SHAKEN_SOURCE_DIR "/data/scenes/ch4_shock.toml");
    const plan::FlatBox flat = plan::flat_box(wide);
    // One particle in a thousand at most, which the side makes up for to round-off.
    CHECK(flat.x == Approx(plan::flat_width).epsilon(1e-3));
    CHECK(static_cast<double>(flat.number) / (flat.x * flat.y) == Approx(wide.number_per_area()).epsilon(1e-14));
    const scene::Scene narrow = stripes({"box.x=8", "box.y=8", "particles.number=384"});
    CHECK(plan::flat_box(narrow).number == 384);
}

TEST_CASE("grains of a low constant restitution may collapse in a small cell, unless a law or a remedy keeps them") {
    const std::string constant = "particles.restitution=0.84";
    CHECK(plan::may_collapse(stripes({constant})));
    CHECK_FALSE(plan::may_collapse(stripes({"particles.restitution=0.85"})));
    CHECK_FALSE(plan::may_collapse(stripes({})));  // e(v), elastic at rest
    CHECK_FALSE(plan::may_collapse(stripes({constant, "particles.collapse=contact_time"})));
}

TEST_CASE("an error is a share or a percentage, and nothing else") {
    CHECK(plan::share_of("1%") == 0.01);
    CHECK(plan::share_of("0.01") == 0.01);
    CHECK(plan::share_of("0.5 %") == Approx(0.005));
    for (const char* nonsense : {"", "%", "much", "0", "-1%", "80%", "1", "1%%", "nan", "1e-400%"}) {
        INFO(nonsense);
        CHECK_THROWS_WITH(plan::share_of(nonsense), Contains("as 1% or as 0.01"));
    }
}
