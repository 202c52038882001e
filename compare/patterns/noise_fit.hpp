// SPDX-License-Identifier: MIT
// The strength of the noise and the mean-field onset of a layer's pattern, by fitting the noisy Swift-Hohenberg model
// to measured curves (Bougie 2004, section 6.4.2): the control at which long-range order sets in ties the plate's
// acceleration to the model's control, epsilon = (Gamma - Gamma_MF)/Gamma_MF; one scale factor ties the mean squares
// below it; the noise F is that of the least residual.
#pragma once

#include <cstdint>
#include <vector>

namespace shaken::compare {

/// <psi^2> and the order P_max against a control that ascends: Gamma of a layer or epsilon of the model. Errors are one
/// standard error; empty where there are none.
struct OnsetCurve {
    std::vector<double> control, mean_square, order;
    std::vector<double> mean_square_error, order_error;
};

/// The control at which the order rises most steeply: the largest slope between neighbouring points, refined by the
/// parabola through it and the slopes beside it. Throws std::invalid_argument for fewer than four points.
double steepest_rise(const OnsetCurve& curve);

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
    double noise_error = 0.0, mean_field_onset_error = 0.0;
    std::vector<double> residuals;  // one for each curve of the model
};

/// Model curves ascend in noise; at least three. The best noise is the minimum of the parabola through the residuals of
/// the best curve and its neighbours, over the logarithm of the noise. Errors: standard deviation over `draws` sets of
/// measured values, redrawn within their errors from `seed`.
/// Throws std::invalid_argument for curves too short or not in order.
NoiseFit fit_noise(const OnsetCurve& measured, const std::vector<ModelCurve>& model, int draws = 100,
                   std::uint64_t seed = 1);

}  // namespace shaken::compare
