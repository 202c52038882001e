// SPDX-License-Identifier: MIT
// The field of the noisy Swift-Hohenberg equation in time: pseudo-spectral in space; linear part and noise exact and
// the cubic term of second order in time. The same seed gives the same field.
#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include "scene/random_stream.hpp"
#include "swift_hohenberg/exponential_step.hpp"
#include "swift_hohenberg/parameters.hpp"

namespace shaken::swift_hohenberg {

class Simulation {
  public:
    /// Throws std::invalid_argument for fewer than 4 points, a side, step or noise out of range.
    explicit Simulation(const Parameters& parameters);
    ~Simulation();

    void step();
    void advance(std::int64_t steps);

    double time() const { return parameters_.step * static_cast<double>(steps_); }
    const Parameters& parameters() const { return parameters_; }
    /// psi at the points, shape (points, points), x fastest.
    const std::vector<double>& field() const;
    /// Replaces psi. Throws std::invalid_argument for another shape.
    void set_field(const std::vector<double>& field);
    /// Amplitude of e^(i k.x), 0 <= ix <= points/2, 0 <= iy < points.
    std::complex<double> mode(std::int64_t ix, std::int64_t iy) const;
    /// Spatial mean of psi^2.
    double mean_square() const;
    /// What the equation descends without noise: mean over space of -epsilon psi^2/2 + ((1 + lap) psi)^2/2 + psi^4/4
    /// (Cross and Hohenberg 1993, equation 4.9).
    double potential() const;

  private:
    struct Transform;
    using Modes = std::vector<std::complex<double>>;

    std::size_t index(std::int64_t ix, std::int64_t iy) const;
    /// -psi^3 of the field that these modes make, as modes.
    void cubic_term(const Modes& modes, Modes& out);
    /// Two columns of modes hold each amplitude twice, as conjugates. What round-off parts them by is no field, so the
    /// cubic term would not see it and it would grow without bound.
    void make_real();

    Parameters parameters_;
    scene::RandomStream random_;
    std::unique_ptr<Transform> transform_;
    std::vector<ExponentialStep> weights_;  // one for each mode kept
    Modes modes_, term_, later_term_, noise_;
    mutable std::vector<double> field_;
    mutable bool field_is_current_ = false;
    std::int64_t steps_ = 0;
};

}  // namespace shaken::swift_hohenberg
