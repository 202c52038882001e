// SPDX-License-Identifier: MIT
// What a scene names is what runs: settings that a method has no use for are refused at their place, and what is left
// open is there as a value.
#include "continuum/resolve.hpp"

#include <string>
#include <vector>

#include "continuum/ftcs/ftcs.hpp"
#include "continuum/parameters.hpp"
#include "continuum/solver.hpp"
#include "continuum/verification.hpp"
#include "scene/errors.hpp"
#include "scene/read_scene.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using continuum::resolve;

namespace {

const std::string layer = R"([scene]
kind = "layer"
[plate]
acceleration = 3.0
frequency = 0.095
[particles]
number = 864
restitution = 0.9
[box]
x = 12.0
y = 12.0
[continuum]
lid = 40.0
)";

scene::Scene with(const std::vector<std::string>& changes, const std::string& more = "") {
    return continuum::parse_scene(layer + more, "layer.toml", changes);
}

const std::vector<std::string> ftcs{"continuum.scheme=ftcs", "continuum.closure=jenkins_richman_dense"};

std::vector<std::string> ftcs_and(const std::string& change) { return {ftcs[0], ftcs[1], change}; }

}  // namespace

TEST_CASE("a key that the scheme has no use for is refused where it is written, and by default is not printed") {
    struct Case {
        std::string scheme, key, value;
    };
    const Case c = GENERATE(Case{"ftcs", "flux", "hllc"}, Case{"ftcs", "limiter", "van_leer"},
                            Case{"ftcs", "cfl", "0.8"}, Case{"muscl", "artificial_dissipation", "0.1"},
                            Case{"muscl", "diffusion_factor", "0.16"}, Case{"weno5", "limiter", "minmod"},
                            Case{"weno5", "artificial_dissipation", "0.1"}, Case{"weno5", "diffusion_factor", "0.16"});
    INFO(c.scheme << ", " << c.key);
    std::vector<std::string> scheme{"continuum.scheme=" + c.scheme};
    if (c.scheme == "ftcs") scheme.push_back(ftcs[1]);
    const std::string quoted = c.key == "flux" || c.key == "limiter" ? '"' + c.value + '"' : c.value;
    CHECK_THROWS_WITH(resolve(with(scheme, c.key + " = " + quoted + "\n")),
                      Contains("layer.toml:14:") && Contains("continuum." + c.key + " has no part in") &&
                          Contains('"' + c.scheme + '"') && Contains("schemes that use it"));
    const std::string printed = scene::print_scene(resolve(with(scheme)));
    CHECK_THAT(printed, !Contains("\n" + c.key + " ="));
    std::vector<std::string> by_override = scheme;
    by_override.push_back("continuum." + c.key + "=" + c.value);
    CHECK_THROWS_WITH(resolve(with(by_override)), Contains("--set continuum." + c.key));
    // A run refuses it too, whoever starts it.
    CHECK_THROWS_AS(continuum::Solver(with(by_override)), scene::SceneError);
}

TEST_CASE("ftcs is refused with a closure that it cannot run, by the name that it can") {
    const std::string closure =
        GENERATE("jenkins_richman", "jenkins_richman_fluid", "jenkins_richman_bocquet", "garzo_dufty");
    CHECK_THROWS_WITH(resolve(with({ftcs[0]}, "closure = \"" + closure + "\"\n")),
                      Contains("layer.toml:14:") && Contains('"' + closure + '"') &&
                          Contains("it can run \"jenkins_richman_dense\""));
    // Left open, the closure is the default one, which is not replaced: the scheme's place is shown.
    CHECK_THROWS_WITH(resolve(with({ftcs[0]})), Contains("--set continuum.scheme=ftcs") && Contains("the default") &&
                                                    Contains("it can run \"jenkins_richman_dense\""));
    CHECK(resolve(with(ftcs)).continuum.closure.name == "jenkins_richman_dense");
    CHECK(resolve(with({})).continuum.closure.name == "jenkins_richman");
}

TEST_CASE("the floor of ftcs is what the scene says, and by default its own") {
    CHECK(resolve(with({})).continuum.floor_density == 1e-7);
    CHECK(resolve(with(ftcs)).continuum.floor_density == 1e-3);
    CHECK(resolve(with(ftcs_and("continuum.floor_density=0.02"))).continuum.floor_density == 0.02);
    CHECK_THROWS_WITH(resolve(with(ftcs_and("continuum.floor_density=1e-4"))),
                      Contains("--set continuum.floor_density") && Contains("0.0001") && Contains("0.001"));

    // And it is what holds the gas above the layer, before and after the first steps. Round-off.
    const double floor = GENERATE(1e-3, 0.02);
    continuum::Solver solver(with(ftcs_and("continuum.floor_density=" + std::to_string(floor))));
    solver.advance_to_instant(0, 2);
    double least = 1.0;
    for (const double n : solver.column(0, 0).density) least = std::min(least, n);
    // Relative to the mean of the run, which holds the floor itself: at most that share more.
    CHECK(least >= floor * 864.0 / (12.0 * 12.0 * 40.0));
    CHECK(least <= (1.0 + floor) * floor * 864.0 / (12.0 * 12.0 * 40.0));
}

TEST_CASE("the grid that runs is the one recorded") {
    CHECK(resolve(with({})).continuum.dimension.name == "1");
    CHECK(resolve(with({"initial.noise=0.01", "box.x=24", "box.y=6"})).continuum.dimension.name == "2");
    CHECK(resolve(with({"initial.noise=0.01", "box.x=24", "box.y=24"})).continuum.dimension.name == "3");
    // One column of cells along y is no third dimension.
    CHECK(resolve(with({"continuum.dimension=3", "box.x=48", "box.y=3", "continuum.spacing_horizontal=3"}))
              .continuum.dimension.name == "2");

    const scene::Scene uneven =
        resolve(with({"continuum.spacing=0.3", "continuum.dimension=3", "continuum.spacing_horizontal=0.7"}));
    const continuum::Solver solver(uneven);
    CHECK(uneven.continuum.spacing == solver.spacing_z());
    CHECK(uneven.continuum.spacing_horizontal == solver.spacing_x());
    CHECK(solver.spacing_z() == Approx(40.0 / 133.0));
    CHECK_THAT(scene::print_scene(resolve(with({}))), !Contains("spacing_horizontal"));
}

TEST_CASE("a start that the columns cannot hold is refused") {
    CHECK_THROWS_WITH(resolve(with({"continuum.dimension=1", "initial.noise=0.01"})),
                      Contains("initial.noise = 0.01") && Contains("several columns"));
    CHECK_THROWS_WITH(resolve(with({"continuum.dimension=2", "initial.wave=0.1", "initial.wave_y=1"})),
                      Contains("initial.wave_y = 1") && Contains("along y"));
    CHECK_NOTHROW(resolve(with({"continuum.dimension=2", "initial.wave=0.1", "initial.wave_x=2"})));
}

namespace {

scene::Scene tube(const std::string& kind, const std::string& more) {
    return continuum::parse_scene("[scene]\nkind = \"" + kind + "\"\n" + more, "tube.toml");
}

}  // namespace

TEST_CASE("of a flow with a known future the cells and the time that run are recorded") {
    // 10/0.3 is 33.3: the nearest whole number of cells is 33.
    CHECK(resolve(tube("piston", "[continuum]\nspacing = 0.3\n")).continuum.spacing == Approx(10.0 / 33.0));
    // Whole periods of sound of the length, 40/c with c = 1.8135158 sqrt(g sigma) (physics.md, e = 0.7): 22.0566 each.
    const std::string wave =
        "[tube]\nlength = 40.0\nrestitution = 0.7\ntime = 100.0\n[initial]\nvolume_fraction = 0.1\n"
        "[continuum]\nspacing = 1.0\n";
    CHECK(resolve(tube("wave", wave)).tube.time == Approx(5.0 * 40.0 / 1.81351580).epsilon(1e-7));
}

TEST_CASE("a setting that a flow with a known future has no use for is refused or not printed") {
    struct Case {
        std::string kind, section, key, value, more;
    };
    const auto c =
        GENERATE(Case{"riemann", "tube", "speed", "2.0", ""}, Case{"column", "initial", "number_per_area", "2.0", ""},
                 Case{"column", "initial", "volume_fraction", "0.2", "[tube]\nwall_temperature = 1.5\n"},
                 Case{"piston", "continuum", "floor_density", "1e-5", ""},
                 Case{"piston", "continuum", "closure", "\"garzo_dufty\"", "[continuum]\ntransport = \"inviscid\"\n"});
    INFO(c.kind << ": " << c.key);
    const auto text = [&](bool written) {
        std::string all = c.more;
        if (!written) return all;
        const std::string line = c.key + " = " + c.value + "\n";
        const std::size_t at = all.find("[" + c.section + "]\n");
        return at == std::string::npos ? all + "[" + c.section + "]\n" + line : all + line;
    };
    CHECK_THROWS_WITH(resolve(tube(c.kind, text(true))),
                      Contains("tube.toml:") && Contains(c.section + "." + c.key + " has no part in"));
    CHECK_THAT(scene::print_scene(resolve(tube(c.kind, text(false)))), !Contains("\n" + c.key + " ="));
}

TEST_CASE("the floor of ftcs in a tube is recorded") {
    const std::string printed = scene::print_scene(resolve(
        tube("column", "[continuum]\nscheme = \"ftcs\"\nclosure = \"jenkins_richman_dense\"\nspacing = 0.1\n")));
    CHECK_THAT(printed, Contains("\nfloor_density = 0.001\n"));
}

TEST_CASE("ftcs is asked for its closure only where the gas asks one") {
    const std::string inviscid = "[continuum]\nscheme = \"ftcs\"\ntransport = \"inviscid\"\nspacing = 0.1\n";
    const std::string walls = "[tube]\nlower = \"wall\"\nupper = \"wall\"\ntime = 1.0\n";
    const scene::Scene elastic = resolve(tube("riemann", inviscid + walls));
    CHECK_THAT(scene::print_scene(elastic), !Contains("\nclosure ="));
    // Which it then gives up: forward differences without viscosity are stable at no step.
    CHECK_THROWS_WITH(continuum::verify(elastic), Contains("unstable"));
    CHECK_THROWS_WITH(resolve(tube("riemann", inviscid + walls + "restitution = 0.9\n")),
                      Contains("it can run \"jenkins_richman_dense\""));
}

TEST_CASE("a uniform gas of the continuum alone is recorded without what the MD acts on, and starts from no file") {
    const std::string gas = "[particles]\nnumber = 100\n";
    const auto alone = [&](const std::string& more) { return continuum::resolve_alone(tube("uniform", gas + more)); };
    CHECK_THAT(scene::print_scene(alone("")), !Contains("seed") && !Contains("frames") && Contains("interval"));
    CHECK_THROWS_WITH(alone("[initial]\nfile = \"x.h5\"\n"), Contains("initial.file has no part"));
}

TEST_CASE("what is printed resolves to itself") {
    const std::vector<std::string> changes =
        GENERATE(std::vector<std::string>{}, ftcs, std::vector<std::string>{"continuum.scheme=weno5"},
                 std::vector<std::string>{"initial.noise=0.01", "continuum.spacing=0.3"});
    const scene::Continuum once = resolve(with(changes)).continuum;
    const scene::Scene printed = continuum::parse_scene(scene::print_scene(resolve(with(changes))), "printed.toml");
    const scene::Continuum again = resolve(printed).continuum;
    for (const auto choice :
         {&scene::Continuum::dimension, &scene::Continuum::scheme, &scene::Continuum::flux, &scene::Continuum::limiter,
          &scene::Continuum::closure, &scene::Continuum::transport, &scene::Continuum::lower, &scene::Continuum::upper})
        CHECK((again.*choice).name == (once.*choice).name);
    for (const auto number : {&scene::Continuum::spacing, &scene::Continuum::lid, &scene::Continuum::cfl,
                              &scene::Continuum::floor_density, &scene::Continuum::floor_temperature})
        CHECK(again.*number == once.*number);
    // What was chosen for the scene stands in it as if written.
    CHECK(printed.continuum.upper.name == once.upper.name);
    CHECK(printed.continuum.dimension.name == once.dimension.name);
    CHECK(once.dimension.name != "auto");
    const std::string kind = GENERATE("riemann", "piston", "column", "wave", "cooling_flow");
    const scene::Scene tubes = resolve(tube(kind, "[tube]\nlength = 10.1\n[continuum]\nspacing = 0.3\n"));
    const scene::Scene reread = resolve(continuum::parse_scene(scene::print_scene(tubes), "printed.toml"));
    CHECK(reread.continuum.spacing == tubes.continuum.spacing);
    CHECK(reread.continuum.spacing != 0.3);  // which does not part a length of 10.1
    CHECK(reread.continuum.closure.name == tubes.continuum.closure.name);
    CHECK(reread.continuum.floor_density == tubes.continuum.floor_density);
}
