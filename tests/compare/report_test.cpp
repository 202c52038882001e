// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compare/compare_file.hpp"
#include "compare/summary.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace shaken;

namespace {

// Debian's, which has h5py and matplotlib: another one first on the PATH may lack them.
int run_report(const std::filesystem::path& folder) {
    const std::string command =
        "/usr/bin/python3 -B " SHAKEN_SOURCE_DIR "/scripts/figures/report.py " + folder.string() + " > /dev/null 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("a compared run becomes one report without outside parts, and each figure a PNG, a PDF and a CSV") {
    const support::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    const compare::Medium medium = synthetic::ideal_gas();
    const scene::PlateMotion motion{5.0, 0.1};
    const auto md = compare::measure(synthetic::run_with_front(3), motion, medium);
    const auto continuum = compare::measure(synthetic::run_with_front(1), motion, medium);
    scene::Scene scene;
    scene.name = "a <synthetic> front";
    compare::write_compare_file(folder / "compare.h5", md, continuum, medium, {});
    auto summary = compare::summarise(md, continuum, scene, {}, {});
    summary["continuum"]["notes"] = {"The continuum has no <friction>."};
    summary["continuum"]["validity"] = {
        {"knudsen", 0.0123},      {"knudsen_largest", 0.5},      {"knudsen_limit", 0.1},
        {"omega_tau", 3.4},       {"omega_tau_largest", 7.0},    {"omega_tau_limit", 2.5},
        {"packed_share", 0.0567}, {"packed_share_largest", 0.4}, {"packed_share_limit", 0.1}};
    std::ofstream(folder / "summary.json") << summary.dump();
    REQUIRE(run_report(folder) == 0);

    std::ifstream in(folder / "report.html");
    std::stringstream text;
    text << in.rdbuf();
    const std::string page = text.str();
    CHECK(count(page, "data:image/png;base64,") == 4);
    CHECK(count(page, "http") == 0);
    CHECK(count(page, "a &lt;synthetic&gt; front") == 2);  // title and heading, escaped
    CHECK(count(page, "<li>The continuum has no &lt;friction&gt;.</li>") == 1);
    for (const char* number : {">0.012<", ">3.4<", ">5.7 %<", ">40 %<", ">2.5<"}) CHECK(count(page, number) == 1);
    for (const char* figure : {"figure_4_1", "figure_4_2b", "figure_4_3", "figure_4_5"}) {
        for (const char* kind : {".png", ".pdf", ".csv"}) {
            const auto file = folder / "figures" / (std::string(figure) + kind);
            INFO(file);
            CHECK(std::filesystem::exists(file));
        }
    }
    // The first column of figure 4.2(b) beside its source, from ft = -0.33 on: the CSV holds the file's values.
    std::ifstream csv(folder / "figures/figure_4_2b.csv");
    std::string line;
    std::getline(csv, line);
    for (std::size_t k = 0; k < 40; ++k) {
        REQUIRE(std::getline(csv, line));
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream row(line);
        double phase = 0.0, plate = 0.0, centre = 0.0;
        row >> phase >> plate >> centre;
        const std::size_t of = (k + 27) % 40;
        CHECK(phase == Approx((static_cast<double>(k) - 13.0) / 40.0).margin(1e-12));  // round-off
        CHECK(plate == md.all.profiles[of].plate_height);
        CHECK(centre == md.all.centre_of_mass[of]);
    }
}

TEST_CASE("a folder that was not compared is refused as input that is not there") {
    const support::TemporaryFolder folder;
    CHECK(run_report(folder.path()) == 66);
}
