// SPDX-License-Identifier: MIT
// `shaken plan` from outside, on a layer of 200 particles whose trials take about a second.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using support::shaken;

namespace {

nlohmann::json plan_of(const support::TemporaryFolder& folder, const std::string& wish) {
    const auto result = shaken(std::string("plan ") + support::small_scene + " " + wish + " --json --overwrite --out " +
                               (folder / "planned.toml").string());
    INFO(result.text);
    REQUIRE(result.code == 0);
    return nlohmann::json::parse(result.text);
}

}  // namespace

TEST_CASE("the scene that a plan writes reads back and is what the plan says") {
    const support::TemporaryFolder folder;
    const auto plan = plan_of(folder, "--error 2%");
    CHECK(plan["continuum"]["dimension"] == 1);
    CHECK(plan["md"]["error"].get<double>() <= 0.02);
    CHECK(plan["continuum"]["error"].get<double>() <= 0.02);
    const auto scene = shaken("scene " + (folder / "planned.toml").string());
    REQUIRE(scene.code == 0);
    const auto says = [&](const std::string& key, const nlohmann::json& value) {
        CHECK_THAT(scene.text, Contains("\n" + key + " = " + value.dump() + "\n"));
    };
    says("spacing", plan["continuum"]["spacing"]);
    says("lid", plan["continuum"]["lid"]);
    says("scheme", plan["continuum"]["scheme"]);
    says("settle", plan["md"]["settle"]);
    says("average", plan["md"]["average"]);
    says("number", plan["md"]["particles"]);
    CHECK_THAT(support::content_of((folder / "planned.toml").string()), Contains("# for an error of 2 %"));
}

TEST_CASE("half the error takes four times the MD") {
    const support::TemporaryFolder folder;
    const auto one = plan_of(folder, "--error 0.4%"), half = plan_of(folder, "--error 0.002");
    const auto cycles = [](const nlohmann::json& plan) {
        return plan["md"]["average"].get<double>() * plan["md"]["seeds"].get<double>();
    };
    // Cycles come in tens a seed, of a hundred or more; both plans see the same trial but for its number of cycles,
    // which gives the spread to 25 per cent.
    CHECK(cycles(half) / cycles(one) == Approx(4.0).epsilon(0.35));
}

TEST_CASE("a plan for a time stays below it") {
    const support::TemporaryFolder folder;
    const auto plan = plan_of(folder, "--seconds 3");
    CHECK(plan["md"]["seconds"].get<double>() + plan["continuum"]["seconds"].get<double>() <= 3.0);
    CHECK(plan["md"]["seconds"].get<double>() > 1.0);
}

TEST_CASE("wishes that cannot be met are told with what is possible") {
    const support::TemporaryFolder folder;
    const std::string out = " --out " + (folder / "p.toml").string();
    const auto exact = shaken(std::string("plan ") + support::small_scene + " --error 1e-9" + out);
    CHECK(exact.code == 2);
    CHECK_THAT(exact.text, Contains("the least is"));
    const auto quick = shaken(std::string("plan ") + support::small_scene + " --seconds 0.0001" + out);
    CHECK(quick.code == 2);
    CHECK_THAT(quick.text, Contains("the least plan takes"));
    const auto other = shaken("plan " SHAKEN_SOURCE_DIR "/data/scenes/verify_riemann.toml --error 1%" + out);
    CHECK(other.code == 2);
    CHECK_THAT(other.text, Contains("only a shaken layer"));
    CHECK_FALSE(std::filesystem::exists(folder / "p.toml"));
}

TEST_CASE("nonsense is refused before anything is tried") {
    const std::string scene = std::string("plan ") + support::small_scene;
    CHECK(shaken(scene).code == 2);
    CHECK(shaken(scene + " --error 1% --seconds 3").code == 2);
    CHECK(shaken(scene + " --seconds never").code == 2);
    CHECK(shaken(scene + " --error much").code == 2);
    CHECK(shaken("plan no_such.toml --error 1%").code == 66);
}

TEST_CASE("a plan replaces no file unless told to") {
    const support::TemporaryFolder folder;
    std::ofstream(folder / "mine.toml") << "precious";
    const std::string command =
        std::string("plan ") + support::small_scene + " --error 20% --out " + (folder / "mine.toml").string();
    CHECK(shaken(command).code == 73);
    CHECK(support::content_of((folder / "mine.toml").string()) == "precious");
    CHECK(shaken(command + " --overwrite").code == 0);
}
