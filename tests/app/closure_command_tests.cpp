// SPDX-License-Identifier: MIT
// `shaken closure` from outside.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"

using support::shaken;

TEST_CASE("a closure's numbers are printed as JSON, a row of each for the volume fractions") {
    const auto result = shaken("closure jenkins_richman --nu 0.1,0.4 --T 1 --e 0.7 --json");
    REQUIRE(result.code == 0);
    const auto said = nlohmann::json::parse(result.text);
    CHECK(said["nu"] == nlohmann::json({0.1, 0.4}));
    // The table of physics.md, nine digits.
    const std::pair<const char*, std::array<double, 2>> rows[] = {
        {"p", {0.27189787, 3.78892459}},      {"c", {1.81351580, 5.64608591}},     {"mu", {0.22502073, 1.29962695}},
        {"lambda", {0.03580367, 1.33855898}}, {"kappa", {0.94912316, 5.27841943}}, {"mu_n", {0.0, 0.0}},
        {"gamma", {0.08216941, 3.07199285}}};
    for (const auto& [name, values] : rows)
        for (std::size_t i = 0; i < 2; ++i) {
            INFO(name << " " << i);
            CHECK(said[name][i].get<double>() == Approx(values[i]).epsilon(2e-7));
            CHECK(said["units"][name].is_string());
        }
    CHECK(said["units"]["p"] == "m g/sigma^2");
}

TEST_CASE("pair correlation and restitution have their part in it") {
    const auto of = [](const std::string& more) {
        return nlohmann::json::parse(shaken("closure garzo_dufty --nu 0.4 --json " + more).text);
    };
    CHECK(of("--e 0.9")["mu_n"][0].get<double>() != 0.0);
    CHECK(of("--e 1")["gamma"][0].get<double>() == 0.0);
    // g0 = (1 - 0.2)/0.6^3 = 100/27, and p = n T (1 + 4 nu g0) with n = 2.4/pi.
    CHECK(of("--pair-correlation carnahan_starling")["p"][0].get<double>() ==
          Approx(2.4 / 3.14159265358979324 * (1.0 + 1.6 * 100.0 / 27.0)).epsilon(1e-14));
    CHECK(of("--T 4")["c"][0].get<double>() == Approx(2.0 * of("")["c"][0].get<double>()).epsilon(1e-14));
}

TEST_CASE("without --json a closure is a table, and without a name there is the list with words and references") {
    const auto table = shaken("closure garzo_dufty --nu 0.4 --e 0.9");
    CHECK(table.code == 0);
    CHECK_THAT(table.text, Contains("mu_n") && Contains("m g sigma^3 sqrt(g/sigma)") && Contains("\n       0.4 "));
    const auto list = shaken("closure");
    CHECK(list.code == 0);
    CHECK_THAT(list.text, Contains("jenkins_richman_dense") && Contains("Bougie 2004") &&
                              Contains("carnahan_starling") && Contains("Torquato 1995"));
    const auto all = nlohmann::json::parse(shaken("closure --json").text);
    for (const char* kind : {"closures", "pair_correlations"}) {
        CHECK_FALSE(all[kind].empty());
        for (const auto& one : all[kind])
            for (const char* said : {"name", "words", "reference"}) CHECK_FALSE(one[said].get<std::string>().empty());
    }
}

TEST_CASE("what no closure has ends with 2 and says what is meant") {
    const auto mistyped = shaken("closure garzo_duffy --nu 0.4");
    CHECK(mistyped.code == 2);
    CHECK_THAT(mistyped.text, Contains("did you mean \"garzo_dufty\"?"));
    CHECK_THAT(shaken("closure garzo --nu 0.4").text, Contains("did you mean \"garzo_dufty\"?"));
    CHECK_THAT(shaken("closure garzo_dufty --nu 0.4 --pair-correlation goldstein").text,
               Contains("did you mean \"goldshtein\"?"));
    CHECK(shaken("closure garzo_dufty").code == 2);
    CHECK(shaken("closure garzo_dufty --nu 0.65").code == 2);
    CHECK(shaken("closure garzo_dufty --nu 0.4 --e 1.5").code == 2);
    CHECK(shaken("closure garzo_dufty --nu 0.4 --T=-1").code == 2);
    CHECK(shaken("closure garzo_dufty --nu x").code == 2);
}
