// SPDX-License-Identifier: MIT
#include "swift_hohenberg/simulation.hpp"

#include <fftw3.h>

#include <cmath>
#include <stdexcept>

#include "swift_hohenberg/linear_theory.hpp"

namespace shaken::swift_hohenberg {

/// Real field <-> modes, planned once. FFTW_ESTIMATE: a measured plan could differ from run to run, and with it the
/// last bit.
struct Simulation::Transform {
    explicit Transform(std::size_t side_points)
        : points(side_points), real(points * points), modes(points * (points / 2 + 1)) {
        const int side = static_cast<int>(points);
        auto* complex = reinterpret_cast<fftw_complex*>(modes.data());
        forward = fftw_plan_dft_r2c_2d(side, side, real.data(), complex, FFTW_ESTIMATE);
        backward = fftw_plan_dft_c2r_2d(side, side, complex, real.data(), FFTW_ESTIMATE);
    }
    Transform(const Transform&) = delete;
    Transform& operator=(const Transform&) = delete;
    ~Transform() {
        fftw_destroy_plan(forward);
        fftw_destroy_plan(backward);
    }

    void to_modes(const std::vector<double>& from, Modes& to) {
        real = from;
        fftw_execute(forward);
        to = modes;
        const double share = 1.0 / static_cast<double>(points * points);
        for (auto& mode : to) mode *= share;
    }
    void to_field(const Modes& from, std::vector<double>& to) {
        modes = from;
        fftw_execute(backward);
        to = real;
    }

    std::size_t points;
    std::vector<double> real;
    Modes modes;
    fftw_plan forward, backward;
};

namespace {

std::vector<double> white_noise(std::size_t points, double deviation, scene::RandomStream& random) {
    std::vector<double> values(points);
    for (double& value : values) value = deviation * random.normal();
    return values;
}

const Parameters& checked(const Parameters& p) {
    if (p.points < 4 || p.points > 4096) throw std::invalid_argument("points must be from 4 to 4096");
    if (!(p.side > 0.0) || !std::isfinite(p.side)) throw std::invalid_argument("side must be positive");
    if (!(p.step > 0.0) || !std::isfinite(p.step)) throw std::invalid_argument("step must be positive");
    if (!(p.noise >= 0.0) || !std::isfinite(p.noise)) throw std::invalid_argument("noise must not be negative");
    if (!std::isfinite(p.control)) throw std::invalid_argument("control must be a number");
    return p;
}

}  // namespace

Simulation::Simulation(const Parameters& parameters)
    : parameters_(checked(parameters)),
      random_(parameters.seed),
      transform_(std::make_unique<Transform>(static_cast<std::size_t>(parameters.points))) {
    const std::int64_t n = parameters_.points;
    for (std::int64_t iy = 0; iy < n; ++iy)
        for (std::int64_t ix = 0; ix <= n / 2; ++ix)
            weights_.emplace_back(growth_rate(parameters_, ix, iy), parameters_.step);
    set_field(white_noise(static_cast<std::size_t>(n * n), parameters_.start, random_));
}

Simulation::~Simulation() = default;

std::size_t Simulation::index(std::int64_t ix, std::int64_t iy) const {
    return static_cast<std::size_t>(iy * (parameters_.points / 2 + 1) + ix);
}

std::complex<double> Simulation::mode(std::int64_t ix, std::int64_t iy) const { return modes_[index(ix, iy)]; }

void Simulation::set_field(const std::vector<double>& field) {
    if (field.size() != static_cast<std::size_t>(parameters_.points * parameters_.points))
        throw std::invalid_argument("the field must have points x points values");
    transform_->to_modes(field, modes_);
    field_is_current_ = false;
}

const std::vector<double>& Simulation::field() const {
    if (!field_is_current_) transform_->to_field(modes_, field_);
    field_is_current_ = true;
    return field_;
}

void Simulation::cubic_term(const Modes& modes, Modes& out) {
    transform_->to_field(modes, field_);
    for (double& psi : field_) psi = -psi * psi * psi;
    transform_->to_modes(field_, out);
    field_is_current_ = false;
}

void Simulation::make_real() {
    const std::int64_t n = parameters_.points;
    const auto pair_up = [&](std::int64_t ix) {
        for (std::int64_t iy = 0; iy <= n / 2; ++iy) {
            auto &mode = modes_[index(ix, iy)], &mirrored = modes_[index(ix, (n - iy) % n)];
            mode = 0.5 * (mode + std::conj(mirrored));
            mirrored = std::conj(mode);
        }
    };
    pair_up(0);
    if (n % 2 == 0) pair_up(n / 2);
}

void Simulation::step() {
    const auto points = static_cast<double>(parameters_.points);
    const bool noisy = parameters_.noise > 0.0;
    if (noisy) {
        // A point's share of delta(x - x') is 1/(cell area); a transform of unit noise has 1/points^2 in each mode.
        const double deviation = std::sqrt(2.0 * parameters_.noise) * points / parameters_.side;
        transform_->to_modes(white_noise(static_cast<std::size_t>(points * points), deviation, random_), noise_);
    }
    if (parameters_.cubic) cubic_term(modes_, term_);
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        const ExponentialStep& w = weights_[k];
        modes_[k] *= w.decay;
        if (parameters_.cubic) modes_[k] += w.first * term_[k];
        if (noisy) modes_[k] += w.noise_spread * noise_[k];
    }
    if (parameters_.cubic) {
        cubic_term(modes_, later_term_);
        for (std::size_t k = 0; k < modes_.size(); ++k) modes_[k] += weights_[k].second * (later_term_[k] - term_[k]);
    }
    make_real();
    field_is_current_ = false;
    ++steps_;
}

void Simulation::advance(std::int64_t steps) {
    for (std::int64_t i = 0; i < steps; ++i) step();
}

double Simulation::mean_square() const {
    double sum = 0.0;
    for (const double psi : field()) sum += psi * psi;
    return sum / static_cast<double>(field_.size());
}

double Simulation::potential() const {
    const std::int64_t n = parameters_.points;
    double quadratic = 0.0, quartic = 0.0;
    for (std::int64_t iy = 0; iy < n; ++iy) {
        for (std::int64_t ix = 0; ix <= n / 2; ++ix) {
            const bool has_conjugate = ix > 0 && 2 * ix < n;
            quadratic -= (has_conjugate ? 1.0 : 0.5) * growth_rate(parameters_, ix, iy) * std::norm(mode(ix, iy));
        }
    }
    for (const double psi : field()) quartic += psi * psi * psi * psi;
    return quadratic + 0.25 * quartic / static_cast<double>(field_.size());
}

}  // namespace shaken::swift_hohenberg
