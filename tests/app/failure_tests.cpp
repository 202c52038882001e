// SPDX-License-Identifier: MIT
// A continuum run that fails ends with 1, one sentence, and a checkpoint of its last sound state.
#include <filesystem>

#include "tests/support/catch.hpp"
#include "tests/support/command.hpp"
#include "tests/support/temporary_folder.hpp"

using support::shaken;

TEST_CASE("a continuum run that fails says where and when, and leaves its state and no output") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    const auto frozen = shaken(std::string("continuum ") + support::small_scene +
                               " --set particles.restitution=0.5 --set continuum.floor_temperature=0.5 --out " + out);
    CHECK(frozen.code == 1);
    CHECK_THAT(frozen.text,
               Contains("temperature floor") && Contains("time") && Contains("height") && Contains("cycle"));
    CHECK(std::filesystem::exists(out + "/continuum.checkpoint"));
    CHECK_FALSE(std::filesystem::exists(out + "/continuum.h5"));
    CHECK_THAT(support::content_of(out + "/continuum.status.json"), Contains("failed"));

    // The state is that of the failure: what goes on from it fails at once.
    const auto resumed = shaken("continuum --resume " + out);
    CHECK(resumed.code == 1);
    CHECK_THAT(resumed.text, Contains("temperature floor") && Contains("height"));
}

TEST_CASE("a tube that fails says where and when, and leaves nothing") {
    const support::TemporaryFolder folder;
    const std::string out = (folder / "a").string();
    const auto unstable = shaken("continuum " SHAKEN_SOURCE_DIR
                                 "/data/scenes/verify_riemann.toml --set tube.lower=wall --set tube.upper=wall"
                                 " --set continuum.transport=navier_stokes --set continuum.scheme=ftcs --set "
                                 "continuum.closure=jenkins_richman_dense"
                                 " --set continuum.diffusion_factor=1 --set continuum.spacing=0.1 --out " +
                                 out);
    CHECK(unstable.code == 1);
    CHECK_THAT(unstable.text, Contains("time") && Contains("height"));
    CHECK_FALSE(std::filesystem::exists(out + "/summary.json"));
}
