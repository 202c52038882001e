// SPDX-License-Identifier: MIT
#include "scene/read_scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compare/scenes.hpp"
#include "scene/errors.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace scene;

using compare::parse_scene;
using compare::read_scene;

namespace {

const std::string shock = R"([plate]
acceleration = 3
frequency = 0.095

[particles]
number = 3937
restitution = 0.9

[box]
x = 20
y = 20
ceiling = 200
)";

/// The scene above with one line replaced.
std::string with(const std::string& line, const std::string& replacement) {
    std::string text = shock;
    const std::size_t at = text.find(line);
    REQUIRE(at != std::string::npos);
    return text.replace(at, line.size(), replacement);
}

std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        parse_scene(text, "try.toml", overrides);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("the shipped scene of chapter 4 is what the source describes") {
    const Scene s = read_scene(SHAKEN_SOURCE_DIR "/data/scenes/ch4_shock.toml");
    CHECK(s.name == "ch4_shock");
    CHECK(s.number_of_particles == 3937);
    CHECK(s.number_per_area() == 9.8425);
    CHECK(s.motion.frequency == 0.095);
    CHECK(s.motion.peak_acceleration() == Approx(3.0).epsilon(1e-15));
    CHECK(fast_restitution(s.particles.restitution) == 0.9);
}

TEST_CASE("depth and number imply each other: 6 a unit area are 5.4 deep") {
    const Scene s = parse_scene(with("number = 3937", "depth = 5.4"), "try.toml");
    CHECK(s.number_of_particles == 2400);
    CHECK(s.depth == Approx(5.4).epsilon(1e-15));
}

TEST_CASE("f* is f sqrt(H)") {
    const Scene s = parse_scene(with("frequency = 0.095", "frequency_star = 0.4174"), "try.toml");
    CHECK(s.motion.frequency == Approx(0.4174 / std::sqrt(s.depth)).epsilon(1e-15));
}

TEST_CASE("the least ceiling is the raised plate, the layer of the start and one diameter") {
    const Scene s = parse_scene(shock, "try.toml");
    const double thickness = s.number_per_area() * (3.14159265358979323846 / 6.0) / s.initial.volume_fraction;
    const double least = 2.0 * s.motion.amplitude + thickness + 1.0;
    const auto ceiling = [](double height) { return refusal(shock, {fmt::format("box.ceiling={}", height)}); };
    CHECK(ceiling(least) == "accepted");
    CHECK_THAT(ceiling(least * (1.0 - 1e-12)), Contains("is too low") &&
                                                   Contains(fmt::format("rises to {:.4g}", 2.0 * s.motion.amplitude)) &&
                                                   Contains(fmt::format("is {:.4g} thick", thickness)));
}

TEST_CASE("the list of keys is itself a scene but for what a scene must give") {
    const auto list = [](Kind kind) { return list_parameters(kind, compare::both_engines()); };
    CHECK_THAT(refusal(list(Kind::layer)), Contains("particles.number or particles.depth is needed"));
    CHECK(refusal(list(Kind::layer), {"particles.depth=9", "plate.frequency=0.095"}) == "accepted");
    CHECK(refusal(list(Kind::uniform), {"particles.number=100"}) == "accepted");
    for (const Kind kind : {Kind::riemann, Kind::piston, Kind::column, Kind::wave, Kind::cooling_flow})
        CHECK(refusal(list(kind), {"continuum.spacing=0.1"}) == "accepted");
}

TEST_CASE("an override wins over the file and replaces the other of an exclusive pair") {
    CHECK(parse_scene(shock, "try.toml", {"plate.acceleration=2.5"}).plate.acceleration == 2.5);
    const Scene s = parse_scene(shock, "try.toml", {"particles.depth=4.5", "plate.frequency_star=0.3"});
    CHECK(s.depth == Approx(4.5).epsilon(1e-12));
    CHECK_FALSE(s.particles.number.has_value());
    CHECK_FALSE(s.plate.frequency.has_value());
    const Scene law = parse_scene(shock, "try.toml", {"particles.restitution={law=\"velocity\", e0=0.7}"});
    CHECK(std::holds_alternative<RestitutionVelocity>(law.particles.restitution));
}

TEST_CASE("a refusal points at file, line and column and shows the line") {
    const std::string message = refusal(with("restitution = 0.9", "restitution = 1.3"));
    CHECK_THAT(message, Contains("try.toml:7:15: particles.restitution = 1.3 is outside [0, 1]"));
    CHECK_THAT(message, Contains("     7 | restitution = 1.3\n       |               ^"));
}

TEST_CASE("wrong values are refused with what is allowed") {
    struct Case {
        std::string line, replacement, message;
    };
    const Case c = GENERATE(
        Case{"restitution = 0.9", "restitution = -0.1", "particles.restitution = -0.1 is outside [0, 1]"},
        Case{"restitution = 0.9", "restitution = nan",
             "particles.restitution = nan is not a finite number; allowed: [0, 1]"},
        Case{"restitution = 0.9", "restitution = \"high\"",
             "particles.restitution must be a number ([0, 1]), not string"},
        Case{"restitution = 0.9", "restitution = { e0 = 0.7 }", "needs law; known: constant, velocity"},
        Case{"restitution = 0.9", "restitution = { law = \"velocty\", e0 = 0.7 }", "did you mean \"velocity\"?"},
        Case{"restitution = 0.9", "restitution = { law = \"velocity\" }", "needs e0 in [0, 1]"},
        Case{"restitution = 0.9", "restitution = { law = \"velocity\", e0 = 0.7, v1 = 3 }", "known: law, e0, v0"},
        Case{"acceleration = 3", "acceleration = -3", "plate.acceleration = -3 must be at least 0"},
        Case{"acceleration = 3", "acceleration = inf", "plate.acceleration = inf is not a finite number"},
        Case{"frequency = 0.095", "frequency = 0.0", "plate.frequency = 0.0 must be at least 1e-06"},
        Case{"frequency = 0.095", "", "plate.frequency or plate.frequency_star is needed"},
        Case{"frequency = 0.095", "frequency = 0.095\nfrequency_star = 0.3",
             "contradicts plate.frequency (try.toml:3): give one of them"},
        Case{"number = 3937", "number = 3937\ndepth = 9.0",
             "contradicts particles.number (try.toml:6): give one of them"},
        Case{"number = 3937", "number = 0", "particles.number = 0 is outside [1, 1000000000]"},
        Case{"number = 3937", "number = 39.5", "particles.number must be a whole number"},
        Case{"number = 3937", "number = \"many\"", "particles.number must be a whole number"},
        Case{"number = 3937", "depth = 1e300", "allowed: 1 to 1e9"},
        Case{"number = 3937", "", "particles.number or particles.depth is needed"},
        Case{"x = 20", "x = 1.5", "box.x = 1.5 is outside [2, 1000000]"},
        Case{"ceiling = 200", "ceiling = 20", "box.ceiling = 20 is too low"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nphases = 0", "sample.phases = 0 is outside [20, 100000]"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nphases = 130", "sample.phases = 130 is not a multiple of 20"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nframes = 30",
             "sample.frames = 30 does not divide sample.phases = 200"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nsettle = 1\naverage = 2\nframe_cycles = 4",
             "sample.frame_cycles = 4 are more than the 3 cycles of the run"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nmap_bin = 1e-3", "at most 8 are allowed"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nphases = []", "sample.phases must be a whole number"},
        Case{"ceiling = 200", "ceiling = 200\n[continuum]\nlid = 10",
             "continuum.lid = 10 is below the top of the layer"},
        Case{"ceiling = 200", "ceiling = 200\n[md]\nseed = -1", "md.seed = -1"},
        Case{"ceiling = 200", "ceiling = 200\n[scene]\nkind = \"lair\"", "did you mean \"layer\"?"},
        Case{"ceiling = 200", "ceiling = 200\n[scene]\nname = 7", "scene.name must be a text in quotes"},
        Case{"ceiling = 200", "ceiling = 200\n[sample]\nphases = 100000\naverage = 1000000000", "GB for averages"},
        Case{"ceiling = 200", "ceiling = 200\n[continuum]\ndimension = 3\nspacing_horizontal = 0.002", "at most"},
        Case{"restitution = 0.9", "restitution = { law = \"foo\" }", "known: constant, velocity"},
        Case{"[box]", "[box", "try.toml:9:"}, Case{"y = 20", "y = 20\ny = 21", "try.toml:12:"},
        Case{"[plate]\nacceleration = 3\nfrequency = 0.095", "plate = 7", "[plate] must be a section"});
    INFO(c.replacement);
    CHECK_THAT(refusal(with(c.line, c.replacement)), Contains(c.message));
}

TEST_CASE("friction and the remedy against collapse are read, printed and refused") {
    const Scene walton = parse_scene(with("restitution = 0.9",
                                          "restitution = 0.9\nfriction = { law = \"walton\", beta0 = 0.3, mu = 0.2 }\n"
                                          "collapse = \"contact_time\"\ncollapse_time = 1e-3"),
                                     "try.toml");
    CHECK(walton.particles.friction.law == FrictionLaw::walton);
    CHECK(walton.particles.friction.beta0 == 0.3);
    CHECK(walton.particles.friction.mu == 0.2);
    CHECK(walton.particles.collapse == CollapseRemedy::contact_time);
    CHECK(walton.particles.collapse_time == 1e-3);
    struct Case {
        std::string key, message;
    };
    const auto c =
        GENERATE(Case{"friction = \"walton\"", "needs its numbers"},
                 Case{"friction = { law = \"waltn\", beta0 = 0.3, mu = 0.2 }", "did you mean \"walton\"?"},
                 Case{"friction = { law = \"walton\", beta0 = 0.3 }", "needs mu"},
                 Case{"friction = { law = \"walton\", beta0 = 1.3, mu = 0.2 }", "beta0 = 1.3 is outside [-1, 1]"},
                 Case{"friction = { law = \"walton\", beta0 = 0.3, mu = 0.2, k = 1 }", "known: law, beta0, mu"},
                 Case{"collapse = \"elastic\"", "known: none, elastic_below, contact_time"},
                 Case{"collapse_time = 0", "collapse_time = 0 must be greater than 0"});
    INFO(c.key);
    CHECK_THAT(refusal(with("restitution = 0.9", "restitution = 0.9\n" + c.key)), Contains(c.message));
}

TEST_CASE("an unknown key is refused with the nearest known one") {
    CHECK_THAT(refusal(with("acceleration = 3", "aceleration = 3")),
               Contains("try.toml:2:1: plate.aceleration is unknown") && Contains("did you mean acceleration?"));
    CHECK_THAT(refusal(with("number = 3937", "number = 3937\nceiling = 3")), Contains("did you mean box.ceiling?"));
    CHECK_THAT(refusal(with("[box]", "[bx]")), Contains("[bx] is unknown") && Contains("did you mean [box]?"));
}

TEST_CASE("a wrong override is refused in its own words") {
    CHECK_THAT(refusal(shock, {"particles.restitution=1.3"}),
               Contains("--set particles.restitution=1.3") && Contains("is outside [0, 1]"));
    CHECK_THAT(refusal(shock, {"particles.restitutoin=0.3"}), Contains("did you mean restitution?"));
    CHECK_THAT(refusal(shock, {"acceleration=2"}), Contains("is not of the form section.key=value"));
    CHECK_THAT(refusal(shock, {"plate.acceleration"}), Contains("is not of the form section.key=value"));
    CHECK_THAT(refusal(shock, {"plate.acceleration="}), Contains("plate.acceleration must be a number"));
}

TEST_CASE("a missing scene file is told apart from a bad one") {
    CHECK_THROWS_AS(read_scene("no/such/scene.toml"), NoSceneFile);
    CHECK_THROWS_AS(read_scene("/"), NoSceneFile);
}

TEST_CASE("lines that would exhaust the parser are refused") {
    std::string keys;
    for (int i = 0; i < 100000; ++i) keys += "a.";
    CHECK_THAT(refusal(keys + "a = 1"), Contains("try.toml:1:1: the line has 200005 characters"));
}

TEST_CASE("a message shows no more of a line than a terminal can, and nothing unprintable") {
    const std::string message = refusal("[plate]\nacceleration = \"" + std::string(5000, 'x') + "\x1b\"");
    CHECK(message.size() < 6000);
    CHECK(message.find('\x1b') == std::string::npos);
}

TEST_CASE("a uniform gas is a cube of its number and volume fraction, whichever of number and side is given") {
    const std::string gas =
        "[scene]\nkind = \"uniform\"\n[particles]\nnumber = 4000\n[initial]\nvolume_fraction = 0.3\n"
        "[sample]\ninterval = 0.1\nsettle = 5\nduration = 20\n";
    const Scene s = parse_scene(gas, "try.toml");
    const double side = std::cbrt(4000.0 * 3.14159265358979324 / 6.0 / 0.3);
    CHECK(s.box.x == Approx(side).epsilon(1e-14));  // round-off
    CHECK(s.box.y == s.box.x);
    CHECK(s.box.ceiling == s.box.x);
    CHECK(s.sample.settle == 50);
    CHECK(s.sample.average == 200);
    CHECK(s.sample.phases == 1);
    CHECK(s.motion.period() == Approx(0.1).epsilon(1e-15));
    CHECK(s.motion.amplitude == 0.0);
    CHECK(parse_scene(print_scene(s), "again.toml").box.x == s.box.x);

    const Scene of_side = parse_scene(gas, "try.toml", {fmt::format("box.side={}", side)});
    CHECK(of_side.number_of_particles == 4000);
    CHECK_THAT(refusal(gas + "[box]\nside = 20\n"), Contains("box.side contradicts particles.number (try.toml:4)"));
    CHECK_THAT(refusal(gas, {"sample.interval=0.3"}), Contains("is not a whole number of sample.interval = 0.3"));
    CHECK_THAT(refusal(gas, {"sample.frames=201"}), Contains("are more than the 200 sample instants"));
    CHECK_THAT(refusal(gas + "[plate]\nacceleration = 3\n"), Contains("[plate] is unknown"));
}
