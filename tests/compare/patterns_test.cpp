// SPDX-License-Identifier: MIT
// Measures of patterns on maps whose answer is known: plane waves, white noise, waves that alternate or grow.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "compare/patterns/floquet.hpp"
#include "compare/patterns/fluctuations.hpp"
#include "compare/patterns/pattern_summary.hpp"
#include "compare/patterns/polar_spectrum.hpp"
#include "compare/patterns/power_spectrum.hpp"
#include "scene/random_stream.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;
using compare::Amplitude;

namespace {

constexpr double pi = std::numbers::pi;
const fields::HorizontalGrid square{21, 21, 42.0, 42.0};

std::vector<double> map_of(const fields::HorizontalGrid& grid, const std::function<double(double, double)>& psi) {
    std::vector<double> map;
    for (std::int64_t iy = 0; iy < grid.ny; ++iy)
        for (std::int64_t ix = 0; ix < grid.nx; ++ix)
            map.push_back(
                psi((static_cast<double>(ix) + 0.5) * grid.dx(), (static_cast<double>(iy) + 0.5) * grid.dy()));
    return map;
}

compare::PowerSpectrum spectrum_of(const fields::HorizontalGrid& grid, const std::vector<double>& map) {
    compare::MapTransform transform(grid);
    compare::PowerSpectrum spectrum(transform);
    spectrum.add(transform.amplitudes(map));
    return spectrum;
}

std::vector<double> noise(const fields::HorizontalGrid& grid, scene::RandomStream& random) {
    return map_of(grid, [&](double, double) { return random.normal(); });
}

}  // namespace

TEST_CASE("a plane wave has order 1, its own wavelength and its own direction") {
    const auto [mx, my] =
        GENERATE(std::pair{2, 0}, std::pair{0, 2}, std::pair{1, 2}, std::pair{2, -1}, std::pair{4, 4});
    const double kx = 2.0 * pi * mx / 42.0, ky = 2.0 * pi * my / 42.0;
    const auto spectrum =
        spectrum_of(square, map_of(square, [&](double x, double y) { return 3.0 + 0.4 * std::cos(kx * x + ky * y); }));
    CHECK(spectrum.order() == Approx(1.0).epsilon(1e-12));  // round-off
    CHECK(spectrum.mean_square() == Approx(0.5 * 0.4 * 0.4).epsilon(1e-12));
    CHECK(spectrum.dominant_wavelength() == Approx(2.0 * pi / std::hypot(kx, ky)).epsilon(1e-12));
    const double direction = std::fmod(std::atan2(ky, kx) + pi, pi);
    const double off = std::abs(spectrum.angle() - direction);
    CHECK(std::min(off, pi - off) <= 0.5 * pi / 21.0 + 1e-12);  // half a bin
}

TEST_CASE("interpolated to polar coordinates, a plane wave keeps the share of a pyramid around its wavevector") {
    const auto [mx, my] = GENERATE(std::pair{2, 0}, std::pair{0, 2}, std::pair{3, -1}, std::pair{6, 2});
    const auto spectrum = spectrum_of(
        square, map_of(square, [&](double x, double y) { return std::cos(2.0 * pi * (mx * x + my * y) / 42.0); }));
    // k_r dk_r dtheta is dkx dky: bilinear interpolation makes of one wave a pyramid of two waves' width.
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform;
    std::vector<int> found(21, 0);
    constexpr int draws = 400000;
    for (int i = 0; i < draws; ++i) {
        const double x = mx + uniform(random) - uniform(random), y = my + uniform(random) - uniform(random);
        const auto bin = std::lround(std::fmod(std::atan2(y, x) + 2.0 * pi, pi) / pi * 21.0) % 21;
        ++found[static_cast<std::size_t>(bin)];
    }
    const double expected = *std::max_element(found.begin(), found.end()) / double(draws);
    // Three standard errors of the draws, and the sums over rays and wavenumbers, midpoint rules on 16 to a bin and
    // wave.
    CHECK(compare::interpolated_order(spectrum) == Approx(expected).margin(3.0 * std::sqrt(expected / draws) + 2e-3));
}

TEST_CASE("the spectrum holds the whole mean square on grids of even and odd sides") {
    const fields::HorizontalGrid grid =
        GENERATE(fields::HorizontalGrid{21, 21, 42.0, 42.0}, fields::HorizontalGrid{42, 42, 42.0, 42.0},
                 fields::HorizontalGrid{84, 5, 168.0, 10.0}, fields::HorizontalGrid{21, 1, 42.0, 4.0});
    scene::RandomStream random(3);
    const std::vector<double> map = noise(grid, random);
    double mean = 0.0, square_sum = 0.0;
    for (const double psi : map) mean += psi / static_cast<double>(map.size());
    for (const double psi : map) square_sum += (psi - mean) * (psi - mean) / static_cast<double>(map.size());
    CHECK(spectrum_of(grid, map).mean_square() == Approx(square_sum).epsilon(1e-12));  // round-off
}

TEST_CASE("the order of white noise is that of independent modes of the same grid") {
    // Second way, by another random generator: draw the power of each wave from its own distribution, with no map and
    // no transform.
    constexpr int draws = 400, maps_a_draw = 20;
    scene::RandomStream random(5);
    std::ranlux24 other(5);
    std::normal_distribution<double> normal;
    compare::MapTransform transform(square);
    double by_maps = 0.0, by_modes = 0.0, squares = 0.0;
    for (int d = 0; d < draws; ++d) {
        compare::PowerSpectrum mapped(transform), drawn(transform);
        for (int m = 0; m < maps_a_draw; ++m) {
            mapped.add(transform.amplitudes(noise(square, random)));
            std::vector<Amplitude> amplitudes;
            for (std::size_t w = 0; w < transform.waves().size(); ++w)
                amplitudes.emplace_back(normal(other), normal(other));
            drawn.add(amplitudes);
        }
        by_maps += mapped.order() / draws;
        by_modes += drawn.order() / draws;
        const double difference = mapped.order() - drawn.order();
        squares += difference * difference;
    }
    const double error = std::sqrt(squares) / draws;
    CHECK(error < 2e-3);
    CHECK(std::abs(by_maps - by_modes) < 3.0 * error);  // three standard errors
    CHECK(by_maps > 1.0 / 21.0);
}

TEST_CASE("the coherent part is what alternates, with an error that covers the noise") {
    scene::RandomStream random(7);
    std::vector<std::int64_t> cycles;
    std::vector<Amplitude> waves;
    for (int c = 0; c < 400; ++c) {
        cycles.push_back(c + 13);
        const Amplitude still{0.7, 0.0}, turning{0.3, 0.4};
        waves.push_back(still + (cycles.back() % 2 == 0 ? 1.0 : -1.0) * turning +
                        Amplitude{random.normal(), random.normal()});
    }
    const auto part = compare::coherent_part(cycles, waves);
    CHECK(part.error == Approx(std::sqrt(2.0 / 400.0)).epsilon(0.5));  // of ten blocks: known to a quarter
    CHECK(std::abs(part.mean - Amplitude{0.3, 0.4}) < 3.0 * part.error);
}

TEST_CASE("the multiplier of a wave that grows and alternates is found, and onset where its modulus is 1") {
    std::vector<Amplitude> wave{{1e-3, 2e-3}};
    for (int c = 0; c < 9; ++c) wave.push_back(-1.07 * wave.back());
    const Amplitude mu = compare::multiplier(wave);
    CHECK(mu.real() == Approx(-1.07).epsilon(1e-12));
    CHECK(std::abs(mu.imag()) < 1e-12);
    const std::vector<double> controls{2.0, 2.2, 2.4}, multipliers{std::exp(-0.3), std::exp(-0.1), std::exp(0.1)};
    CHECK(compare::onset(controls, multipliers) == Approx(2.3).epsilon(1e-12));
    CHECK(std::isnan(compare::onset(controls, std::vector{0.5, 0.6, 0.7})));
}

TEST_CASE("two decays that make a covariance are found again, whatever its noise at lag nought") {
    const auto [p, q] = GENERATE(std::pair{0.9, 0.8}, std::pair{0.3, 0.98}, std::pair{0.97, 0.5});
    std::vector<double> covariance{100.0};
    for (int l = 1; l < 9; ++l) covariance.push_back(0.2 * std::pow(p, l) + 0.7 * std::pow(-q, l));
    const compare::TwoDecays found = compare::fit_two_decays(covariance);
    CHECK(found.persistent_factor ==
          Approx(p).margin(1e-3));  // the last steps are 1e-5 wide; a small factor is loosely held
    CHECK(found.alternating_factor == Approx(q).margin(1e-3));
    CHECK(found.persistent == Approx(0.2).epsilon(1e-2));  // as loosely as its factor
    CHECK(found.alternating == Approx(0.7).epsilon(1e-2));
}

TEST_CASE(
    "a damped wave that is kicked every cycle is told from drifts and noise, by wavelength, with errors that hold") {
    // Every wave of the map: an alternating part of factor 0.8, a drift of factor 0.95, and the noise of a map.
    constexpr int cycles = 2000;
    constexpr double alternates = 0.8, lasts = 0.95, powers[] = {1.0, 0.5, 2.0};  // at l = 0
    compare::MapTransform transform(square);
    scene::RandomStream random(5);
    const std::size_t waves = transform.waves().size();
    std::vector<Amplitude> turning(waves), drifting(waves);
    const auto kick = [&](double power) {
        return std::sqrt(0.5 * power) * Amplitude(random.normal(), random.normal());
    };
    std::vector<std::vector<Amplitude>> series;
    for (int c = -100; c < cycles; ++c) {
        std::vector<Amplitude> map(waves);
        for (std::size_t w = 0; w < 12; ++w) {
            turning[w] = -alternates * turning[w] + kick(powers[0] * (1.0 - alternates * alternates));
            drifting[w] = lasts * drifting[w] + kick(powers[1] * (1.0 - lasts * lasts));
            map[w] = turning[w] + drifting[w] + kick(powers[2]);
        }
        if (c >= 0) series.push_back(map);
    }
    std::vector<compare::PlaneWave> known(transform.waves().begin(), transform.waves().begin() + 12);
    const auto found = compare::fluctuations(known, series, 4);
    REQUIRE(found.size() == 4);
    for (std::size_t i = 1; i < found.size(); ++i) CHECK(found[i].wavelength < found[i - 1].wavelength);
    double off = 0.0;
    for (const compare::Fluctuation& wave : found) {
        double share = 0.0;
        for (const compare::PlaneWave& w : known)
            if (std::abs(2.0 * pi / std::hypot(w.kx, w.ky) / wave.wavelength - 1.0) < 1e-6) share += w.share;
        // Statistics: an error from eight blocks is itself known to 27 %; five of it.
        CHECK(std::abs(wave.decays.alternating - share) < 5.0 * wave.errors.alternating);
        CHECK(std::abs(wave.decays.persistent - 0.5 * share) < 5.0 * wave.errors.persistent);
        CHECK(std::abs(wave.decays.alternating_factor - alternates) < 5.0 * wave.errors.alternating_factor);
        CHECK(wave.errors.alternating_factor < 0.1);            // of 2000 cycles: measured 0.01 to 0.04
        CHECK(wave.power == Approx(3.5 * share).epsilon(0.2));  // statistics: the drift alone scatters by a tenth
        off += (wave.decays.alternating_factor - alternates) / 4.0;
    }
    CHECK(std::abs(off) < 0.05);  // no bias beyond the statistics of four
    CHECK(compare::fluctuations(known, std::vector(series.begin(), series.begin() + 39), 4).empty());
}

TEST_CASE("errors of waves that remember themselves for longer than a block cover their scatter") {
    // Forty runs of 400 cycles of one wave of factor 0.99: what alternates and its factor, against the errors that are
    // told.
    constexpr int runs = 40, cycles = 400;
    constexpr double q = 0.99;
    compare::MapTransform transform(square);
    const std::vector<compare::PlaneWave> one(transform.waves().begin(), transform.waves().begin() + 1);
    scene::RandomStream random(6);
    const auto kick = [&](double power) {
        return std::sqrt(0.5 * power) * Amplitude(random.normal(), random.normal());
    };
    int powers = 0, factors = 0;
    for (int r = 0; r < runs; ++r) {
        std::vector<std::vector<Amplitude>> series;
        Amplitude wave = kick(1.0);
        for (int c = 0; c < cycles; ++c) {
            wave = -q * wave + kick(1.0 - q * q);
            series.push_back({wave});
        }
        const compare::Fluctuation found = compare::fluctuations(one, series, 1).front();
        powers += std::abs(found.decays.alternating - one[0].share) < 2.0 * found.errors.alternating;
        factors += std::abs(found.decays.alternating_factor - q) < 2.0 * found.errors.alternating_factor;
    }
    // Two standard errors hold 95 of 100 where a scatter is normal; 30 of 40 is what chance leaves of 85 (binomial,
    // three standard deviations).
    CHECK(powers >= 30);
    CHECK(factors >= 30);
    CHECK(compare::memory_error(0.0, 4, 100).relative == Approx(0.05));
    CHECK(std::isfinite(compare::memory_error(1.05, 1, 100).relative));
}

TEST_CASE("the growth of what alternates is found above what lasts and drifts") {
    std::vector<Amplitude> wave, drift, drifting;
    for (int c = 0; c < 8; ++c) {
        wave.push_back(std::pow(-0.9, c) * Amplitude(0.3, 0.4));
        drift.push_back(Amplitude(2.0, -1.0) + 0.25 * c);
        drifting.push_back(wave.back() + drift.back());
    }
    CHECK(compare::alternating_multiplier(wave) == Approx(-0.9).epsilon(1e-12));  // round-off
    CHECK(compare::alternating_multiplier(drifting) == Approx(-0.9).epsilon(1e-12));
    CHECK(std::abs(compare::multiplier(drifting)) > 0.95);  // what a multiplier of the whole would say
    std::vector<Amplitude> growing;
    for (int c = 0; c < 8; ++c) growing.push_back(std::pow(1.2, c));
    CHECK(std::isnan(compare::alternating_multiplier(growing)));  // nothing alternates
    CHECK_THROWS(compare::alternating_multiplier(std::vector<Amplitude>(3)));
}

TEST_CASE("a striped run is summed up as what it is") {
    fields::HeightMaps maps(square);
    scene::RandomStream random(11);
    for (int c = 0; c < 60; ++c) {
        maps.begin(c, 0.25);
        const double side = c % 2 == 0 ? 1.0 : -1.0;
        for (std::int64_t iy = 0; iy < 21; ++iy)
            for (std::int64_t ix = 0; ix < 21; ++ix) {
                const double x = 2.0 * static_cast<double>(ix) + 1.0, y = 2.0 * static_cast<double>(iy) + 1.0;
                maps.add_point(x, y, 1.0, 6.0 + side * 0.5 * std::cos(2.0 * pi * x / 21.0) + 0.1 * random.normal());
            }
        maps.end();
    }
    const auto summary = compare::summarise_pattern(maps, {0.25, 20, 40});
    CHECK(summary.maps == 40);
    CHECK(summary.wavelength == Approx(21.0).epsilon(0.01));  // statistics: neighbours' share of the noise
    CHECK(summary.order.value > 0.9);
    // <psi^2> = 1/8 of the wave and 0.01 of the noise.
    CHECK(std::abs(summary.mean_square.value - 0.135) < 3.0 * summary.mean_square.error + 1e-3);
    CHECK(summary.coherent_share == Approx(0.125 / 0.135).epsilon(0.01));
    REQUIRE(!summary.waves.empty());
    REQUIRE(summary.blocks.size() == 10);
    double of_blocks = 0.0;
    for (const auto& block : summary.blocks) of_blocks += block.mean_square / 10.0;
    CHECK(of_blocks == Approx(summary.mean_square.value).epsilon(1e-12));  // round-off
    CHECK(summary.waves[0].wave.mx == 2);
    CHECK(summary.waves[0].coherent == Approx(0.25).epsilon(0.02));
    CHECK(summary.waves[0].multiplier == Approx(-1.0).epsilon(0.01));
    CHECK_THROWS_AS(compare::summarise_pattern(maps, {0.3, 0, 50}), std::invalid_argument);
}
