// SPDX-License-Identifier: MIT
// The dilute gas in a cooling state, by direct simulation of Boltzmann's equation without space (Bird 1994): pairs are
// drawn at random and collide with a probability that grows as their relative speed. What MD tends to as its density
// goes to zero; no position, cell or event queue of the engine takes part.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "statistics.hpp"

/// a2, and the rates of collisions and of cooling over those of a Maxwell distribution of the same temperature.
struct DiluteGas {
    Estimate cumulant, collisions, cooling;
};

class DirectSimulation {
  public:
    DirectSimulation(std::size_t particles, double restitution, std::uint64_t seed)
        : velocity_(particles), share_(0.5 * (1.0 + restitution)), random_(seed) {
        std::normal_distribution<double> maxwell;
        for (auto& v : velocity_)
            for (double& component : v) component = maxwell(random_);
        rescale();
    }

    /// Means over blocks of so many collisions of each particle, once twenty have let the distribution settle.
    DiluteGas measure(int blocks, int collisions_a_block) {
        for (int k = 0; k < 20; ++k) collide_each();
        std::vector<double> cumulant, collisions, cooling;
        for (int block = 0; block < blocks; ++block) {
            std::array<double, 3> sum{};
            for (int k = 0; k < collisions_a_block; ++k) {
                collide_each();
                const std::array<double, 3> now = moments();
                for (std::size_t m = 0; m < 3; ++m) sum[m] += now[m] / collisions_a_block;
            }
            cumulant.push_back(sum[0] - 1.0);
            collisions.push_back(sum[1]);
            cooling.push_back(sum[2]);
        }
        return {mean_of(cumulant), mean_of(collisions), mean_of(cooling)};
    }

  private:
    using Vector = std::array<double, 3>;

    static Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
    static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

    std::size_t any() { return std::uniform_int_distribution<std::size_t>(0, velocity_.size() - 1)(random_); }
    double uniform() { return std::uniform_real_distribution<double>()(random_); }

    /// A direction with a density that grows as its component along g, as the impact of spheres has: g/|g| and a point
    /// of the unit sphere, added up and normalised, are so distributed.
    Vector line_of_centres(const Vector& g, double speed) {
        const double z = 2.0 * uniform() - 1.0, angle = 2.0 * M_PI * uniform(), r = std::sqrt(1.0 - z * z);
        const Vector n{r * std::cos(angle) + g[0] / speed, r * std::sin(angle) + g[1] / speed, z + g[2] / speed};
        const double length = std::sqrt(dot(n, n));
        return {n[0] / length, n[1] / length, n[2] / length};
    }

    void collide_each() {
        for (std::size_t done = 0; 2 * done < velocity_.size();) {
            const std::size_t i = any(), j = any();
            const Vector g = difference(velocity_[i], velocity_[j]);
            const double speed = std::sqrt(dot(g, g));
            fastest_ = std::max(fastest_, speed);
            if (speed == 0.0 || uniform() * fastest_ >= speed) continue;
            const Vector n = line_of_centres(g, speed);
            const double impulse = share_ * dot(g, n);
            for (std::size_t k = 0; k < 3; ++k) {
                velocity_[i][k] -= impulse * n[k];
                velocity_[j][k] += impulse * n[k];
            }
            ++done;
        }
        rescale();
    }

    /// Back to temperature 1 and to rest: only the shape of the distribution is followed.
    void rescale() {
        const auto count = static_cast<double>(velocity_.size());
        Vector mean{};
        for (const auto& v : velocity_)
            for (std::size_t k = 0; k < 3; ++k) mean[k] += v[k] / count;
        double square = 0.0;
        for (auto& v : velocity_) {
            v = difference(v, mean);
            square += dot(v, v) / (3.0 * count);
        }
        for (auto& v : velocity_)
            for (double& component : v) component /= std::sqrt(square);
    }

    /// <v^4>/15, <g>/(4/sqrt(pi)) and <g^3>/(32/sqrt(pi)) at temperature 1, the latter two over pairs drawn at random.
    std::array<double, 3> moments() {
        const auto count = static_cast<double>(velocity_.size());
        std::array<double, 3> mean{};
        for (const auto& v : velocity_) {
            mean[0] += dot(v, v) * dot(v, v) / (15.0 * count);
            const Vector g = difference(v, velocity_[any()]);
            const double speed = std::sqrt(dot(g, g));
            mean[1] += speed / (4.0 / std::sqrt(M_PI) * count);
            mean[2] += speed * speed * speed / (32.0 / std::sqrt(M_PI) * count);
        }
        return mean;
    }

    std::vector<Vector> velocity_;
    double share_;
    std::mt19937_64 random_;
    double fastest_ = 1.0;
};
