// SPDX-License-Identifier: MIT
// What runs may differ in follows from who owns a key and what it shapes.
#include "scene/differences.hpp"

#include <string>
#include <vector>

#include "compare/scenes.hpp"
#include "scene/read_scene.hpp"
#include "scene/text_visitor.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"

using namespace shaken;

namespace {

scene::Scene with(const std::vector<std::string>& changes) {
    return compare::read_scene(support::small_scene, changes);
}

/// "key: one, other" of the first key that keeps runs of the two engines apart; empty where none does.
std::string between(const std::vector<std::string>& changes, const std::string& engine, const std::string& other) {
    const auto found = scene::first_difference(with({}), engine, with(changes), other);
    return found ? found->key + ": " + found->one + ", " + found->other : "";
}

}  // namespace

TEST_CASE("runs of the two engines may differ in start, length, label and what one engine alone acts on") {
    for (const char* change :
         {"scene.name=other", "initial.seed=7", "initial.temperature=2", "initial.noise=0.1", "sample.settle=3",
          "sample.average=9", "sample.frames=10", "sample.frame_cycles=2", "md.seed=8", "md.shell=0.3",
          "box.ceiling=70", "particles.friction={law=\"walton\", beta0=0.3, mu=0.2}", "particles.collapse=contact_time",
          "continuum.closure=garzo_dufty", "continuum.lid=50"}) {
        INFO(change);
        CHECK(between({change}, "md", "continuum").empty());
    }
    CHECK(between({"particles.restitution=0.8"}, "md", "continuum") == "particles.restitution: 0.9, 0.8");
    CHECK(between({"plate.frequency=0.2"}, "md", "continuum") == "plate.frequency: 0.15, 0.2");
    CHECK(between({"plate.frequency_star=0.3"}, "md", "continuum") == "plate.frequency: 0.15, not given");
    CHECK(between({"box.x=7"}, "md", "continuum") == "box.x: 6.0, 7.0");
    CHECK(between({"sample.bin=0.5"}, "md", "continuum") == "sample.bin: 1.0, 0.5");
    CHECK(between({"sample.phases=200", "box.y=7"}, "md", "continuum") == "box.y: 6.0, 7.0");  // the first of the file
}

TEST_CASE("runs of one engine share what that engine acts on, but its method") {
    CHECK(between({"box.ceiling=70"}, "md", "md") == "box.ceiling: 60.0, 70.0");
    CHECK(between({"particles.collapse=contact_time"}, "md", "md") == "particles.collapse: \"none\", \"contact_time\"");
    for (const char* change : {"md.seed=8", "md.shell=0.3", "md.frames_per_cycle=9", "md.contacts_between_sorts=50",
                               "continuum.lid=50", "initial.noise=0.1"}) {
        INFO(change);
        CHECK(between({change}, "md", "md").empty());
    }
    CHECK(between({"continuum.lid=50"}, "continuum", "continuum") == "continuum.lid: 40.0, 50.0");
}

TEST_CASE("scenes of other kinds are apart at their kind") {
    scene::Scene tube;
    tube.kind = scene::Kind::wave;
    tube.owners = compare::both_engines();
    const auto found = scene::first_difference(with({}), "continuum", tube, "continuum");
    REQUIRE(found);
    CHECK(found->key == "scene.kind");
}

TEST_CASE("every key of an engine's own section is owned by it, and no key has two owners") {
    for (std::size_t k = 0; k < scene::kind_names().size(); ++k) {
        scene::Scene defaults;
        defaults.kind = static_cast<scene::Kind>(k);
        defaults.owners = compare::both_engines();
        std::vector<std::string> seen;
        for (const scene::KeyText& key : scene::keys_of(defaults)) {
            INFO(scene::kind_names()[k] << ": " << key.full());
            if (key.section == "md" || key.section == "continuum") CHECK(key.owner == key.section);
            CHECK(std::find(seen.begin(), seen.end(), key.full()) == seen.end());
            CHECK_FALSE(key.about.words.empty());
            seen.push_back(key.full());
        }
    }
}

TEST_CASE("an engine that reads alone leaves the keys of others alone, and refuses none of them") {
    const std::string text = support::content_of(support::small_scene) + "[md]\nseed = 5\n";
    const scene::Scene all = compare::parse_scene(text, "try.toml");
    CHECK(all.md.seed == 5);
    const scene::Scene of_continuum = scene::parse_scene(text, "try.toml", scene::alone(*all.owners.list.back()));
    CHECK(of_continuum.continuum.lid == 40.0);
    CHECK(of_continuum.md.seed == 1);
    CHECK_THROWS_WITH(compare::parse_scene(text + "sed = 3\n", "try.toml"), Contains("md.sed is unknown"));
}
