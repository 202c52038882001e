// SPDX-License-Identifier: MIT
// Runs of the shipped scenes against data/expected, where long runs of them are recorded.
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "md/parameters.hpp"
#include "md/simulation.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

const std::string data = SHAKEN_SOURCE_DIR "/data/";

/// The numbers of one key of one section of data/expected/NAME.toml.
std::vector<double> recorded(const std::string& name, const std::string& section, const std::string& key) {
    std::ifstream file(data + "expected/" + name + ".toml");
    std::string line, here;
    std::vector<double> numbers;
    while (std::getline(file, line)) {
        if (line.starts_with('[')) here = line.substr(1, line.size() - 2);
        if (here != section || !line.starts_with(key + " = ")) continue;
        for (char& c : line)
            if (c == '[' || c == ']' || c == ',') c = ' ';
        std::istringstream words(line.substr(key.size() + 3));
        for (double number = 0.0; words >> number;) numbers.push_back(number);
    }
    return numbers;
}

/// Averages over a few cycles lie within 3.5 standard errors (statistics, from the recorded spread of single cycles;
/// their correlation is below 0.12) of the recorded means.
void compare(const std::string& name, int settle, int cycles) {
    md::Simulation simulation(md::read_scene(data + "scenes/" + name + ".toml"));
    constexpr int phases = 20;
    std::vector<double> height(phases, 0.0);
    simulation.advance_to(settle, 0.0);
    const auto before = simulation.counters().pair_collisions;
    const auto particles = static_cast<double>(simulation.particles());
    for (int n = 0; n < cycles; ++n)
        for (int phase = 0; phase < phases; ++phase) {
            simulation.advance_to(settle + n, simulation.plate_period() * phase / phases);
            // Mass and gravity are 1: potential energy is the sum of heights.
            height[static_cast<std::size_t>(phase)] += simulation.ledger().potential / particles / cycles;
        }
    simulation.advance_to(settle + cycles, 0.0);
    const double pairs = static_cast<double>(simulation.counters().pair_collisions - before) / particles / cycles;

    const auto mean = recorded(name, "centre_of_mass", "mean"), spread = recorded(name, "centre_of_mass", "spread"),
               error = recorded(name, "centre_of_mass", "error");
    REQUIRE(mean.size() == phases);
    const auto tolerance = [&](double one_cycle, double of_mean) {
        return 3.5 * std::hypot(one_cycle / std::sqrt(cycles), of_mean);
    };
    for (std::size_t phase = 0; phase < phases; ++phase) {
        INFO("phase " << phase << " of " << phases);
        CHECK(height[phase] == Approx(mean[phase]).margin(tolerance(spread[phase], error[phase])).epsilon(0.0));
    }
    const std::string collisions = "pair_collisions_per_particle_and_cycle";
    const double one_cycle = recorded(name, collisions, "spread").at(0),
                 of_mean = recorded(name, collisions, "error").at(0);
    CHECK(pairs == Approx(recorded(name, collisions, "mean").at(0)).margin(tolerance(one_cycle, of_mean)).epsilon(0.0));
}

}  // namespace

TEST_CASE("the shaken layer of chapter 4 bounces as recorded") { compare("ch4_shock", 9, 6); }

TEST_CASE("the shaken layer of chapter 4 bounces as recorded, over thirty cycles", "[slow]") {
    compare("ch4_shock", 15, 30);
}

TEST_CASE("the striped layer of chapter 5 bounces as recorded", "[slow]") { compare("ch5_stripes", 80, 20); }
