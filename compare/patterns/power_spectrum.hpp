// SPDX-License-Identifier: MIT
// Power spectrum of maps psi(x, y) on a periodic rectangle, and what is read off it (Bougie 2004, section 6.3.3 and
// equation 6.1).
#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include "fields/height_maps.hpp"

namespace shaken::compare {

/// One of the waves whose sum is a map, each wavevector and its opposite counted once and k = 0 left out: with the
/// amplitudes a of exp(i (kx x + ky y)), psi = sum of share Re(a exp(i k.x)).
struct PlaneWave {
    std::int64_t mx, my;  // waves along each side; mx >= 0
    double kx, ky;        // 1/sigma
    double share;         // of |a|^2 in the mean of psi^2: 2, or 1 where the wave is its own opposite
};

/// Two-dimensional transform of maps of one grid.
class MapTransform {
  public:
    explicit MapTransform(const fields::HorizontalGrid& grid);
    ~MapTransform();
    MapTransform(const MapTransform&) = delete;
    MapTransform& operator=(const MapTransform&) = delete;

    const fields::HorizontalGrid& grid() const { return grid_; }
    const std::vector<PlaneWave>& waves() const { return waves_; }
    /// One amplitude for each of waves(). `map` has shape (ny, nx); its mean does not matter.
    std::vector<std::complex<double>> amplitudes(const std::vector<double>& map);

  private:
    struct Plan;
    fields::HorizontalGrid grid_;
    std::vector<PlaneWave> waves_;
    std::unique_ptr<Plan> plan_;
};

/// Mean power of maps, wave by wave, and what it says.
class PowerSpectrum {
  public:
    /// As many angles as the source takes.
    static constexpr std::int64_t angles = 21;

    explicit PowerSpectrum(const MapTransform& transform);

    void add(const std::vector<std::complex<double>>& amplitudes);

    std::int64_t maps() const { return maps_; }
    const fields::HorizontalGrid& grid() const { return grid_; }
    const std::vector<PlaneWave>& waves() const { return waves_; }
    /// Mean over maps of |a|^2, as psi^2 counts it: their sum is <psi^2>.
    std::vector<double> power() const;
    double mean_square() const;
    /// Mean power for each direction of the wavevector, bin b around the angle b pi/21 in [0, pi), of waves no shorter
    /// than two bins of the coarser axis.
    std::vector<double> power_by_angle() const;
    /// The same as shares of their sum.
    std::vector<double> by_angle() const;
    /// P_max: the share of the strongest direction; 1 for one plane wave. NaN for a flat map.
    double order() const;
    /// Direction of the wavevector of the strongest bin, in [0, pi).
    double angle() const;
    /// 2 pi over the power-weighted mean wavenumber of the strongest wave and all within a fifth of its wavenumber.
    double dominant_wavelength() const;

  private:
    const fields::HorizontalGrid grid_;
    const std::vector<PlaneWave> waves_;
    std::vector<double> sums_;
    std::int64_t maps_ = 0;
};

}  // namespace shaken::compare
