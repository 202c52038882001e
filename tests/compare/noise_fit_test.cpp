// SPDX-License-Identifier: MIT
// The fit of the Swift-Hohenberg model: on curves made up with a known answer, and on fields of the model itself.
#include "compare/patterns/noise_fit.hpp"

#include <cmath>

#include "compare/patterns/power_spectrum.hpp"
#include "scene/random_stream.hpp"
#include "swift_hohenberg/simulation.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;
using compare::ModelCurve;
using compare::OnsetCurve;

namespace {

/// A family of the model's shape: fluctuations of a Gaussian mode below onset, order that sets in later for more noise.
OnsetCurve made_up(double noise, const std::vector<double>& controls) {
    const double onset = 2.0 * std::pow(noise, 2.0 / 3.0);
    OnsetCurve curve;
    for (const double control : controls) {
        curve.control.push_back(control);
        const double shifted = control - onset;
        curve.mean_square.push_back(0.5 * (shifted + std::sqrt(shifted * shifted + 4.0 * noise)));
        curve.order.push_back(0.2 + 0.7 / (1.0 + std::exp(-shifted / 0.01)));
    }
    return curve;
}

std::vector<double> evenly(double from, double to, int points) {
    std::vector<double> values;
    for (int i = 0; i < points; ++i) values.push_back(from + (to - from) * i / (points - 1));
    return values;
}

/// The same curve as a layer would show it: controls Gamma, squares in sigma^2.
OnsetCurve as_layer(OnsetCurve curve, double mean_field_onset, double scale) {
    for (double& control : curve.control) control = mean_field_onset * (1.0 + control);
    for (double& square : curve.mean_square) square *= scale;
    return curve;
}

ModelCurve simulated(double noise, const std::vector<double>& controls, std::uint64_t seed) {
    ModelCurve model{noise, {}};
    for (const double control : controls) {
        swift_hohenberg::Parameters p;
        p.control = control;
        p.noise = noise;
        p.seed = seed;
        swift_hohenberg::Simulation simulation(p);
        compare::MapTransform transform({p.points, p.points, p.side, p.side});
        compare::PowerSpectrum spectrum(transform);
        simulation.advance(8000);
        for (int i = 0; i < 12000; ++i) {  // 4000 leave the onset uncertain by 0.04
            simulation.step();
            spectrum.add(transform.amplitudes(simulation.field()));
        }
        model.curve.control.push_back(control);
        model.curve.mean_square.push_back(spectrum.mean_square());
        model.curve.order.push_back(spectrum.order());
    }
    return model;
}

}  // namespace

TEST_CASE("the steepest rise of a curve is found between its points") {
    const auto curve = made_up(0.01, evenly(-0.2, 0.2, 41));
    CHECK(compare::steepest_rise(curve) == Approx(2.0 * std::pow(0.01, 2.0 / 3.0)).margin(0.002));  // a fifth of a step
    const OnsetCurve kinked{{0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, 1.1, 1.2, 3.2, 3.3}, {0.1, 0.8, 0.85, 0.9, 0.9}, {}, {}};
    CHECK(compare::steepest_rise(kinked) == Approx(0.5));
    CHECK(compare::steepest_rise(kinked, compare::OnsetBy::mean_square) == Approx(2.5).margin(0.01));
    CHECK_THROWS_AS(compare::steepest_rise(made_up(0.01, {0.0, 0.1})), std::invalid_argument);
}

TEST_CASE("noise, mean-field onset and scale of made-up curves are recovered") {
    const auto controls = evenly(-0.2, 0.25, 91);
    std::vector<ModelCurve> model;
    for (const double noise : {1e-3, 3e-3, 6e-3, 1.2e-2, 2.5e-2, 5e-2})
        model.push_back({noise, made_up(noise, controls)});
    OnsetCurve measured = as_layer(made_up(0.009, evenly(-0.15, 0.2, 36)), 1.97, 3.5);
    const auto fit = compare::fit_noise(measured, model);
    CHECK(fit.noise == Approx(0.009).epsilon(0.15));  // truncation: noises a factor two apart
    CHECK(fit.mean_field_onset == Approx(1.97).epsilon(0.005));
    CHECK(fit.scale == Approx(3.5).epsilon(0.05));
    const auto without = compare::fit_without_each(measured, model);
    REQUIRE(without.size() == measured.control.size());
    CHECK(without.front().control == measured.control.front());
    for (const auto& one : without) CHECK(one.fit.noise == Approx(0.009).epsilon(0.3));  // 35 points hold it as well

    measured.order_error.assign(measured.control.size(), 0.0);
    const auto error_for = [&](double share) {
        measured.mean_square_error = measured.mean_square;
        for (double& error : measured.mean_square_error) error *= share;
        return compare::fit_noise(measured, model, compare::redraw_within_errors(measured), 50).noise_error;
    };
    CHECK(error_for(0.0) < 1e-12);  // round-off of a mean of equal draws
    // Fifty draws give an error to a tenth; it grows as the errors that it comes from.
    const double one = error_for(0.02);
    CHECK(error_for(0.04) / one == Approx(2.0).epsilon(0.5));
    CHECK(one < 0.1 * fit.noise);
}

TEST_CASE("the bootstrap over seeds and blocks scatters as the mean over seeds does") {
    // Four seeds that differ by 0.2 and blocks that differ by 0.3 about them: for a mean over 4 seeds of 25 blocks the
    // bootstrap's variance is that of the seeds' means and of the blocks.
    constexpr int seeds = 4, blocks = 25, draws = 4000;
    scene::RandomStream random(2);
    compare::MeasuredRuns point{2.0, {}};
    std::vector<double> means;
    double within = 0.0;
    for (int s = 0; s < seeds; ++s) {
        const double centre = 5.0 + 0.2 * random.normal();
        point.runs.emplace_back();
        double sum = 0.0, squares = 0.0;
        for (int b = 0; b < blocks; ++b) {
            const double value = centre + 0.3 * random.normal();
            point.runs.back().push_back({value, {value, 1.0, 1.0}});
            sum += value / blocks;
            squares += value * value / blocks;
        }
        means.push_back(sum);
        within += (squares - sum * sum) / blocks / seeds / seeds;
    }
    double mean = 0.0, between = 0.0;
    for (const double m : means) mean += m / seeds;
    for (const double m : means) between += (m - mean) * (m - mean) / seeds / seeds;
    const OnsetCurve measured{{1.0, 2.0}, {0.1, mean}, {0.5, 0.5}, {}, {}};
    const auto redraw = compare::redraw_blocks(measured, {point});
    double first = 0.0, second = 0.0, order = 0.0;
    for (int d = 0; d < draws; ++d) {
        const OnsetCurve drawn = redraw(random);
        CHECK(drawn.mean_square[0] == 0.1);  // no error and no blocks: as measured
        first += drawn.mean_square[1] / draws;
        second += drawn.mean_square[1] * drawn.mean_square[1] / draws;
        order += drawn.order[1] / draws;
    }
    const double variance = second - first * first;
    CHECK(variance == Approx(between + within).epsilon(0.1));  // statistics: 1/sqrt(2000), four of those
    CHECK(std::abs(first - mean) < 4.0 * std::sqrt(variance / draws));
    CHECK(order == Approx(mean / (mean + 2.0)).epsilon(0.01));
}

TEST_CASE("the noise of a Swift-Hohenberg field is recovered within 20 per cent", "[slow]") {
    const auto controls = evenly(-0.2, 0.2, 21);
    std::vector<ModelCurve> model;
    for (const double noise : {4e-3, 7e-3, 1.2e-2, 2e-2, 3.5e-2}) model.push_back(simulated(noise, controls, 1));
    const auto measured = as_layer(simulated(0.012, evenly(-0.18, 0.18, 19), 77).curve, 1.965, 2.0);
    const auto fit = compare::fit_noise(measured, model);
    CHECK(fit.noise == Approx(0.012).epsilon(0.2));
    CHECK(fit.mean_field_onset == Approx(1.965).epsilon(0.02));
}
