// SPDX-License-Identifier: MIT
#include "compare/patterns/power_spectrum.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace shaken::compare {

namespace {

constexpr double pi = std::numbers::pi;

std::int64_t signed_index(std::int64_t m, std::int64_t n) { return 2 * m > n ? m - n : m; }

}  // namespace

struct MapTransform::Plan {
    explicit Plan(const fields::HorizontalGrid& grid)
        : real(grid.size()), modes(static_cast<std::size_t>(grid.ny * (grid.nx / 2 + 1))) {
        forward = fftw_plan_dft_r2c_2d(static_cast<int>(grid.ny), static_cast<int>(grid.nx), real.data(),
                                       reinterpret_cast<fftw_complex*>(modes.data()), FFTW_ESTIMATE);
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    ~Plan() { fftw_destroy_plan(forward); }

    std::vector<double> real;
    std::vector<std::complex<double>> modes;
    fftw_plan forward;
};

MapTransform::MapTransform(const fields::HorizontalGrid& grid) : grid_(grid), plan_(std::make_unique<Plan>(grid)) {
    for (std::int64_t iy = 0; iy < grid.ny; ++iy) {
        for (std::int64_t ix = 0; ix <= grid.nx / 2; ++ix) {
            const std::int64_t my = signed_index(iy, grid.ny);
            // In the two columns that are their own opposites, each pair is met twice.
            const bool own_column = ix == 0 || 2 * ix == grid.nx;
            if (own_column && (my < 0 || (ix == 0 && my == 0))) continue;
            const bool own_opposite = own_column && (my == 0 || 2 * my == grid.ny);
            waves_.push_back({ix, my, 2.0 * pi * static_cast<double>(ix) / grid.length_x,
                              2.0 * pi * static_cast<double>(my) / grid.length_y, own_opposite ? 1.0 : 2.0});
        }
    }
}

MapTransform::~MapTransform() = default;

std::vector<std::complex<double>> MapTransform::amplitudes(const std::vector<double>& map) {
    if (map.size() != grid_.size()) throw std::invalid_argument("a map of another grid");
    plan_->real = map;
    fftw_execute(plan_->forward);
    std::vector<std::complex<double>> found;
    found.reserve(waves_.size());
    for (const auto& wave : waves_) {
        const std::int64_t iy = wave.my < 0 ? wave.my + grid_.ny : wave.my;
        found.push_back(plan_->modes[static_cast<std::size_t>(iy * (grid_.nx / 2 + 1) + wave.mx)] /
                        static_cast<double>(grid_.size()));
    }
    return found;
}

PowerSpectrum::PowerSpectrum(const MapTransform& transform)
    : grid_(transform.grid()), waves_(transform.waves()), sums_(waves_.size(), 0.0) {}

void PowerSpectrum::add(const std::vector<std::complex<double>>& amplitudes) {
    if (amplitudes.size() != sums_.size()) throw std::invalid_argument("amplitudes of another grid");
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += waves_[i].share * std::norm(amplitudes[i]);
    ++maps_;
}

std::vector<double> PowerSpectrum::power() const {
    std::vector<double> mean(sums_);
    for (double& p : mean) p /= static_cast<double>(maps_);
    return mean;
}

double PowerSpectrum::mean_square() const {
    return std::accumulate(sums_.begin(), sums_.end(), 0.0) / static_cast<double>(maps_);
}

std::vector<double> PowerSpectrum::power_by_angle() const {
    std::vector<double> powers(static_cast<std::size_t>(angles), 0.0);
    const double shortest = pi / std::max(grid_.dx(), grid_.dy());
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const auto& wave = waves_[i];
        if (std::hypot(wave.kx, wave.ky) > shortest * (1.0 + 1e-12)) continue;
        // Angles in units of a bin; a wavevector and its opposite are one, hence the remainder.
        const double direction = std::atan2(wave.ky, wave.kx) / pi * static_cast<double>(angles);
        const std::int64_t bin = (std::llround(direction) + angles) % angles;
        powers[static_cast<std::size_t>(bin)] += sums_[i] / static_cast<double>(maps_);
    }
    return powers;
}

std::vector<double> PowerSpectrum::by_angle() const {
    std::vector<double> shares = power_by_angle();
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares) share = sum > 0.0 ? share / sum : std::nan("");
    return shares;
}

double PowerSpectrum::order() const {
    const auto shares = by_angle();
    return *std::max_element(shares.begin(), shares.end());
}

double PowerSpectrum::angle() const {
    const auto shares = by_angle();
    const auto strongest = std::max_element(shares.begin(), shares.end()) - shares.begin();
    return pi * static_cast<double>(strongest) / static_cast<double>(angles);
}

double PowerSpectrum::dominant_wavelength() const {
    constexpr double neighbourhood = 0.2;  // of the wavenumber: the ring to which the strongest wave belongs
    const auto strongest = std::max_element(sums_.begin(), sums_.end()) - sums_.begin();
    const auto wavenumber = [&](std::size_t i) { return std::hypot(waves_[i].kx, waves_[i].ky); };
    const double centre = wavenumber(static_cast<std::size_t>(strongest));
    double power = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        if (std::abs(wavenumber(i) - centre) > neighbourhood * centre) continue;
        power += sums_[i];
        moment += sums_[i] * wavenumber(i);
    }
    return 2.0 * pi * power / moment;
}

}  // namespace shaken::compare
