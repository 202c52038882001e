// SPDX-License-Identifier: MIT
// The strength of the noise and the mean-field onset of a layer's pattern, by fitting the noisy Swift-Hohenberg model
// to measured curves (Bougie 2004, section 6.4.2): the control at which long-range order sets in ties the plate's
// acceleration to the model's control, epsilon = (Gamma - Gamma_MF)/Gamma_MF; one scale factor ties the mean squares
// below it; the noise F is that of the least residual.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compare/patterns/pattern_summary.hpp"
#include "scene/random_stream.hpp"

namespace shaken::compare {

/// <psi^2> and the order P_max against a control that ascends: Gamma of a layer or epsilon of the model. Errors are one
/// standard error; empty where there are none.
struct OnsetCurve {
    std::vector<double> control, mean_square, order;
    std::vector<double> mean_square_error, order_error;
};

/// What tells the onset: long-range order where there is one, <psi^2> where the pattern stays disordered
/// (section 6.6.2).
enum class OnsetBy { order, mean_square };

/// The control at which the order (or <psi^2>) rises most steeply: the largest slope of lines fitted to a quarter of
/// the points that follow one another (two at least), refined by the parabola through it and the slopes beside it.
/// Slopes between neighbours alone scatter so much that the F of a noisy field came out between 0.8 and 1.35 of the
/// true one; with these, between 0.95 and 1.02. Throws std::invalid_argument for fewer than four points.
double steepest_rise(const OnsetCurve& curve, OnsetBy by = OnsetBy::order);

/// Another curve that could as well have been measured.
using Redraw = std::function<OnsetCurve(scene::RandomStream&)>;

/// Every value within its error, normally distributed.
Redraw redraw_within_errors(OnsetCurve measured);

/// The blocks of cycles of every run (seed) at one control.
struct MeasuredRuns {
    double control = 0.0;
    std::vector<std::vector<PatternBlock>> runs;
};

/// Bootstrap over seeds and cycles (Efron 1979): at each control as many runs as there are are drawn with replacement,
/// then as many blocks of cycles of each; <psi^2> and P_max are those of each run's mean spectrum, and their mean over
/// runs. Controls of `measured` without blocks are redrawn within their errors.
Redraw redraw_blocks(OnsetCurve measured, std::vector<MeasuredRuns> blocks);

/// One curve of the model, of noise strength F.
struct ModelCurve {
    double noise = 0.0;
    OnsetCurve curve;
};

struct NoiseFit {
    double noise = 0.0;             // F
    double mean_field_onset = 0.0;  // Gamma_MF
    double onset = 0.0;             // of long-range order, Gamma
    double onset_control = 0.0;     // the same as the model's control
    double scale = 0.0;             // measured <psi^2> over the model's
    double residual = 0.0;          // mean square difference of <psi^2>, at the best curve
    // Over redrawn curves: standard deviations, and where the middle 68 per cent of F begin and end.
    double noise_error = 0.0, mean_field_onset_error = 0.0, onset_error = 0.0;
    double noise_low = 0.0, noise_high = 0.0;
    int fitted_draws = 0;
    std::vector<double> residuals;  // one for each curve of the model
};

/// Model curves ascend in noise; at least three. The best noise is the minimum of the parabola through the residuals of
/// the best curve and its neighbours, over the logarithm of the noise. Errors: over `draws` curves of `redraw`, from
/// `seed`; a drawn curve that cannot be fitted is left out. Throws std::invalid_argument for curves too short or not in
/// order.
NoiseFit fit_noise(const OnsetCurve& measured, const std::vector<ModelCurve>& model, const Redraw& redraw = {},
                   int draws = 200, std::uint64_t seed = 1, OnsetBy by = OnsetBy::order);

/// The fit again without one of the measured controls, for each of them: how far it hangs on a single point, which the
/// bootstrap over cycles does not say. A control without which nothing can be fitted is left out of the answer.
struct FitWithout {
    double control = 0.0;  // the one left out
    NoiseFit fit;
};
std::vector<FitWithout> fit_without_each(const OnsetCurve& measured, const std::vector<ModelCurve>& model,
                                         OnsetBy by = OnsetBy::order);

}  // namespace shaken::compare
