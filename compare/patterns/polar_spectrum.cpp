// SPDX-License-Identifier: MIT
#include "compare/patterns/polar_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace shaken::compare {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::int64_t rays_a_bin = 16, steps_a_wave = 16;

/// Power on the lattice of wavevectors, each and its opposite; zero at k = 0 and beyond the waves of the grid.
class Lattice {
  public:
    explicit Lattice(const PowerSpectrum& spectrum)
        : half_x_(spectrum.grid().nx / 2 + 1), half_y_(spectrum.grid().ny / 2 + 1) {
        power_.resize(static_cast<std::size_t>((2 * half_x_ + 1) * (2 * half_y_ + 1)), 0.0);
        const std::vector<double> power = spectrum.power();
        for (std::size_t i = 0; i < power.size(); ++i) {
            const PlaneWave& wave = spectrum.waves()[i];
            at(wave.mx, wave.my) = at(-wave.mx, -wave.my) = power[i] / wave.share;
        }
    }

    /// x and y in waves along the sides of the box.
    double interpolated(double x, double y) const {
        const double left = std::floor(x), below = std::floor(y);
        const auto mx = static_cast<std::int64_t>(left), my = static_cast<std::int64_t>(below);
        if (mx < -half_x_ || mx >= half_x_ || my < -half_y_ || my >= half_y_) return 0.0;
        const double right = x - left, above = y - below;
        return (1.0 - above) * ((1.0 - right) * power_[index(mx, my)] + right * power_[index(mx + 1, my)]) +
               above * ((1.0 - right) * power_[index(mx, my + 1)] + right * power_[index(mx + 1, my + 1)]);
    }

  private:
    std::size_t index(std::int64_t mx, std::int64_t my) const {
        return static_cast<std::size_t>((my + half_y_) * (2 * half_x_ + 1) + mx + half_x_);
    }
    double& at(std::int64_t mx, std::int64_t my) { return power_[index(mx, my)]; }

    std::int64_t half_x_, half_y_;
    std::vector<double> power_;
};

}  // namespace

std::vector<double> interpolated_by_angle(const PowerSpectrum& spectrum) {
    const fields::HorizontalGrid& grid = spectrum.grid();
    const Lattice lattice(spectrum);
    const double wave_x = 2.0 * pi / grid.length_x, wave_y = 2.0 * pi / grid.length_y;
    const double shortest = pi / std::max(grid.dx(), grid.dy());
    const double step = std::min(wave_x, wave_y) / static_cast<double>(steps_a_wave);
    const auto steps = static_cast<std::int64_t>(std::ceil(shortest / step));
    std::vector<double> shares(static_cast<std::size_t>(PowerSpectrum::angles), 0.0);
    for (std::int64_t ray = 0; ray < PowerSpectrum::angles * rays_a_bin; ++ray) {
        // The first bin lies around the direction 0, half of it below.
        const double bins = (static_cast<double>(ray) + 0.5) / static_cast<double>(rays_a_bin) - 0.5;
        const double angle = bins * pi / static_cast<double>(PowerSpectrum::angles);
        const double along_x = std::cos(angle) / wave_x, along_y = std::sin(angle) / wave_y;
        double power = 0.0;
        for (std::int64_t k = 0; k < steps; ++k) {
            const double wavenumber = (static_cast<double>(k) + 0.5) * step;
            power += lattice.interpolated(wavenumber * along_x, wavenumber * along_y) * wavenumber;
        }
        shares[static_cast<std::size_t>(ray / rays_a_bin)] += power;
    }
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares) share = sum > 0.0 ? share / sum : std::nan("");
    return shares;
}

double interpolated_order(const PowerSpectrum& spectrum) {
    const std::vector<double> shares = interpolated_by_angle(spectrum);
    return *std::max_element(shares.begin(), shares.end());
}

}  // namespace shaken::compare
