// SPDX-License-Identifier: MIT
#include "compare/patterns/noise_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

namespace shaken::compare {

namespace {

void check(const OnsetCurve& curve) {
    const std::size_t points = curve.control.size();
    if (points < 4 || curve.mean_square.size() != points || curve.order.size() != points)
        throw std::invalid_argument("an onset needs at least four points, each with <psi^2> and P_max");
    if (!std::is_sorted(curve.control.begin(), curve.control.end(), std::less_equal<>()))
        throw std::invalid_argument("the controls of a curve must ascend");
}

/// Where the parabola through three points has its extremum; the middle point where they are in line.
double vertex(double x0, double x1, double x2, double y0, double y1, double y2) {
    const double left = (y1 - y0) / (x1 - x0), right = (y2 - y1) / (x2 - x1);
    if (right == left) return x1;
    return 0.5 * (x0 + x1) - left * 0.5 * (x2 - x0) / (right - left);
}

/// Mean of x, and slope of the least-squares line through the points.
std::pair<double, double> fitted_slope(std::span<const double> x, std::span<const double> y) {
    const auto count = static_cast<double>(x.size());
    const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / count;
    const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / count;
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        product += (x[i] - mean_x) * (y[i] - mean_y);
        square += (x[i] - mean_x) * (x[i] - mean_x);
    }
    return {mean_x, product / square};
}

/// <psi^2> between the points of a model curve, linear in its logarithm, which spans decades. NaN outside.
double mean_square_at(const OnsetCurve& curve, double control) {
    const auto above = std::lower_bound(curve.control.begin(), curve.control.end(), control);
    if (above == curve.control.end() || control < curve.control.front()) return std::nan("");
    const auto i = std::max<std::ptrdiff_t>(1, above - curve.control.begin());
    const auto at = static_cast<std::size_t>(i);
    const double share = (control - curve.control[at - 1]) / (curve.control[at] - curve.control[at - 1]);
    return std::exp((1.0 - share) * std::log(curve.mean_square[at - 1]) + share * std::log(curve.mean_square[at]));
}

/// The fit with one curve of the model: noise, onset, scale and residual.
NoiseFit fit_one(const OnsetCurve& measured, double onset, const ModelCurve& model, OnsetBy by) {
    NoiseFit fit;
    fit.noise = model.noise;
    fit.onset = onset;
    fit.onset_control = steepest_rise(model.curve, by);
    fit.mean_field_onset = onset / (1.0 + fit.onset_control);
    std::vector<double> wanted, given;
    for (std::size_t i = 0; i < measured.control.size() && measured.control[i] <= onset; ++i) {
        const double control = measured.control[i] / fit.mean_field_onset - 1.0;
        const double square = mean_square_at(model.curve, control);
        if (std::isnan(square)) continue;
        wanted.push_back(measured.mean_square[i]);
        given.push_back(square);
    }
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        product += wanted[i] * given[i];
        square += given[i] * given[i];
    }
    fit.scale = product / square;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const double difference = wanted[i] - fit.scale * given[i];
        fit.residual += difference * difference / static_cast<double>(wanted.size());
    }
    // Two points are met by any curve with one factor and a shift.
    if (wanted.size() < 3) fit.residual = std::nan("");
    return fit;
}

NoiseFit fit_all(const OnsetCurve& measured, const std::vector<ModelCurve>& model, OnsetBy by) {
    const double onset = steepest_rise(measured, by);
    std::vector<NoiseFit> fits;
    std::vector<double> residuals;
    for (const ModelCurve& curve : model) {
        fits.push_back(fit_one(measured, onset, curve, by));
        residuals.push_back(fits.back().residual);
    }
    std::size_t best = fits.size();
    for (std::size_t i = 0; i < fits.size(); ++i)
        if (!std::isnan(residuals[i]) && (best == fits.size() || residuals[i] < residuals[best])) best = i;
    if (best == fits.size())
        throw std::invalid_argument("no curve of the model covers three measured points below onset");
    NoiseFit fit = fits[best];
    if (best > 0 && best + 1 < fits.size() && !std::isnan(residuals[best - 1]) && !std::isnan(residuals[best + 1])) {
        const auto x = [&](std::size_t i) { return std::log(model[i].noise); };
        const double chosen =
            vertex(x(best - 1), x(best), x(best + 1), residuals[best - 1], residuals[best], residuals[best + 1]);
        fit.noise = std::exp(chosen);
        const std::size_t beside = chosen < x(best) ? best - 1 : best + 1;
        const double share = (chosen - x(best)) / (x(beside) - x(best));
        const auto between = [&](double NoiseFit::*member) {
            return (1.0 - share) * fits[best].*member + share * fits[beside].*member;
        };
        fit.mean_field_onset = between(&NoiseFit::mean_field_onset);
        fit.onset_control = between(&NoiseFit::onset_control);
        fit.scale = between(&NoiseFit::scale);
    }
    fit.residuals = residuals;
    return fit;
}

/// The mean of as many blocks as there are, drawn with replacement.
PatternBlock drawn_mean(const std::vector<PatternBlock>& blocks, scene::RandomStream& random) {
    PatternBlock mean{0.0, std::vector<double>(blocks.front().by_angle.size(), 0.0)};
    const auto count = static_cast<double>(blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const PatternBlock& block = blocks[random.index(blocks.size())];
        mean.mean_square += block.mean_square / count;
        for (std::size_t a = 0; a < mean.by_angle.size(); ++a) mean.by_angle[a] += block.by_angle[a] / count;
    }
    return mean;
}

double deviation(const std::vector<double>& values) {
    double mean = 0.0, square = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (const double v : values) square += (v - mean) * (v - mean);
    return std::sqrt(square / std::max(1.0, static_cast<double>(values.size()) - 1.0));
}

}  // namespace

double steepest_rise(const OnsetCurve& curve, OnsetBy by) {
    check(curve);
    const std::vector<double>& rising = by == OnsetBy::order ? curve.order : curve.mean_square;
    const std::size_t window = std::max<std::size_t>(2, curve.control.size() / 4);
    std::vector<double> middle, slope;
    for (std::size_t i = 0; i + window <= curve.control.size(); ++i) {
        const auto [x, rise] =
            fitted_slope(std::span(curve.control).subspan(i, window), std::span(rising).subspan(i, window));
        middle.push_back(x);
        slope.push_back(rise);
    }
    const auto steepest = static_cast<std::size_t>(std::max_element(slope.begin(), slope.end()) - slope.begin());
    if (steepest == 0 || steepest + 1 == slope.size()) return middle[steepest];
    return vertex(middle[steepest - 1], middle[steepest], middle[steepest + 1], slope[steepest - 1], slope[steepest],
                  slope[steepest + 1]);
}

Redraw redraw_within_errors(OnsetCurve measured) {
    return [measured = std::move(measured)](scene::RandomStream& random) {
        OnsetCurve drawn = measured;
        for (std::size_t i = 0; i < measured.mean_square_error.size(); ++i)
            drawn.mean_square[i] += measured.mean_square_error[i] * random.normal();
        for (std::size_t i = 0; i < measured.order_error.size(); ++i)
            drawn.order[i] += measured.order_error[i] * random.normal();
        return drawn;
    };
}

Redraw redraw_blocks(OnsetCurve measured, std::vector<MeasuredRuns> blocks) {
    return
        [within = redraw_within_errors(std::move(measured)), blocks = std::move(blocks)](scene::RandomStream& random) {
            OnsetCurve drawn = within(random);
            for (const MeasuredRuns& point : blocks) {
                const auto at = std::find(drawn.control.begin(), drawn.control.end(), point.control);
                if (at == drawn.control.end()) continue;
                const auto i = static_cast<std::size_t>(at - drawn.control.begin());
                const auto runs = static_cast<double>(point.runs.size());
                drawn.mean_square[i] = drawn.order[i] = 0.0;
                for (std::size_t r = 0; r < point.runs.size(); ++r) {
                    const PatternBlock mean = drawn_mean(point.runs[random.index(point.runs.size())], random);
                    drawn.mean_square[i] += mean.mean_square / runs;
                    drawn.order[i] += *std::max_element(mean.by_angle.begin(), mean.by_angle.end()) /
                                      std::accumulate(mean.by_angle.begin(), mean.by_angle.end(), 0.0) / runs;
                }
            }
            return drawn;
        };
}

NoiseFit fit_noise(const OnsetCurve& measured, const std::vector<ModelCurve>& model, const Redraw& redraw, int draws,
                   std::uint64_t seed, OnsetBy by) {
    check(measured);
    if (model.size() < 3) throw std::invalid_argument("the fit needs at least three noise strengths");
    for (std::size_t i = 1; i < model.size(); ++i)
        if (!(model[i].noise > model[i - 1].noise))
            throw std::invalid_argument("the model's noise strengths must ascend");
    NoiseFit fit = fit_all(measured, model, by);
    if (!redraw) return fit;
    scene::RandomStream random(seed);
    std::vector<double> noises, mean_field_onsets, onsets;
    for (int d = 0; d < draws; ++d) {
        try {
            const NoiseFit one = fit_all(redraw(random), model, by);
            noises.push_back(one.noise);
            mean_field_onsets.push_back(one.mean_field_onset);
            onsets.push_back(one.onset);
        } catch (const std::invalid_argument&) {
            continue;
        }
    }
    fit.fitted_draws = static_cast<int>(noises.size());
    if (noises.empty()) return fit;
    fit.noise_error = deviation(noises);
    fit.mean_field_onset_error = deviation(mean_field_onsets);
    fit.onset_error = deviation(onsets);
    std::sort(noises.begin(), noises.end());
    const auto quantile = [&](double share) {
        return noises[static_cast<std::size_t>(share * static_cast<double>(noises.size() - 1) + 0.5)];
    };
    fit.noise_low = quantile(0.16);
    fit.noise_high = quantile(0.84);
    return fit;
}

std::vector<FitWithout> fit_without_each(const OnsetCurve& measured, const std::vector<ModelCurve>& model, OnsetBy by) {
    std::vector<FitWithout> fits;
    for (std::size_t i = 0; i < measured.control.size(); ++i) {
        OnsetCurve rest;
        for (std::size_t j = 0; j < measured.control.size(); ++j) {
            if (j == i) continue;
            rest.control.push_back(measured.control[j]);
            rest.mean_square.push_back(measured.mean_square[j]);
            rest.order.push_back(measured.order[j]);
        }
        try {
            fits.push_back({measured.control[i], fit_noise(rest, model, {}, 0, 1, by)});
        } catch (const std::invalid_argument&) {
            continue;
        }
    }
    return fits;
}

}  // namespace shaken::compare
