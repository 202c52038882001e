// SPDX-License-Identifier: MIT
#include "md/initial_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "md/errors.hpp"
#include "md/hard_sphere_theory.hpp"
#include "md/neighbour_lists.hpp"
#include "scene/random_stream.hpp"

namespace shaken::md {

namespace {

using Vector = std::array<double, 3>;

/// The region that holds the centres.
struct Region {
    Periodic x, y, z;
    double lower = 0.0, upper = 0.0;  // of z
};

/// A face-centred lattice stretched to fit the region: columns_x by columns_y cells with two sites each in every layer,
/// layers half a cell apart, each shifted by half a cell against the next.
struct Lattice {
    std::int64_t columns_x = 0, columns_y = 0, layers = 0;
    double edge_x = 0.0, edge_y = 0.0, edge_z = 0.0;

    double nearest() const {
        const double x = edge_x * edge_x, y = edge_y * edge_y, z = edge_z * edge_z;
        return std::sqrt(std::min({x, y, z, 0.25 * (x + y), 0.25 * (x + z), 0.25 * (y + z)}));
    }
};

/// The lattice with at least `wanted` sites that keeps them farthest apart; nearest() tells whether that is enough.
Lattice widest_lattice(const Region& region, std::int64_t wanted) {
    const double height = region.upper - region.lower;
    const bool periodic = region.z.length > 0.0;
    Lattice best;
    for (std::int64_t nx = 1; static_cast<double>(nx) <= region.x.length; ++nx)
        for (std::int64_t ny = 1; static_cast<double>(ny) <= region.y.length; ++ny) {
            std::int64_t layers = (wanted + 2 * nx * ny - 1) / (2 * nx * ny);
            if (periodic) layers += layers % 2;  // the shift must fit when the stack closes on itself
            const double gaps = static_cast<double>(periodic ? layers : layers - 1);
            const Lattice tried{nx,
                                ny,
                                layers,
                                region.x.length / static_cast<double>(nx),
                                region.y.length / static_cast<double>(ny),
                                layers > 1 ? 2.0 * height / gaps : 2.0};
            if (best.layers == 0 || tried.nearest() > best.nearest()) best = tried;
        }
    return best;
}

std::vector<Vector> sites_of(const Lattice& lattice, const Region& region) {
    std::vector<Vector> sites;
    for (std::int64_t k = 0; k < lattice.layers; ++k)
        for (std::int64_t j = 0; j < 2 * lattice.columns_y; ++j)
            for (std::int64_t i = 0; i < lattice.columns_x; ++i) {
                const double offset = (j + k) % 2 == 0 ? 0.0 : 0.5;
                sites.push_back({lattice.edge_x * (static_cast<double>(i) + offset),
                                 0.5 * lattice.edge_y * static_cast<double>(j),
                                 std::min(region.upper, region.lower + 0.5 * lattice.edge_z * static_cast<double>(k))});
            }
    return sites;
}

/// Metropolis moves of hard spheres, through cells of at least one diameter.
class Disorder {
  public:
    Disorder(const Region& region, std::vector<Vector>& centres) : region_(region), centres_(centres) {
        const auto across = [](double length) { return std::max<std::int64_t>(1, static_cast<std::int64_t>(length)); };
        count_ = {across(region.x.length), across(region.y.length), across(region.upper - region.lower)};
        cells_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
        for (std::uint32_t i = 0; i < centres_.size(); ++i) cells_[cell(centres_[i])].push_back(i);
    }

    /// Melts the lattice as smaller spheres, which are then pushed apart as large ones.
    void melt(double share_of_diameter, scene::RandomStream& random) {
        diameter_ = share_of_diameter;
        stir(random);
        diameter_ = 1.0;
        overlapping_ = true;
        for (int n = 0; n < 10000 && overlapping_; ++n) {
            sweep(0.05, random);
            overlapping_ = false;
            for (std::size_t i = 0; i < centres_.size(); ++i)
                overlapping_ = overlapping_ || overlap(centres_[i], i) > 0.0;
        }
    }

    /// Sweeps by which a particle wanders about a diameter at nu = 0.3.
    void stir(scene::RandomStream& random) {
        double step = 0.3;
        constexpr int sweeps = 60;
        for (int n = 0; n < sweeps; ++n) {
            const double accepted = sweep(step, random);
            step = std::clamp(step * (accepted < 0.4 ? 0.9 : 1.1), 1e-3, 0.5);
        }
    }

  private:
    /// Every particle tries one move, in turn. Returns the share accepted.
    double sweep(double step, scene::RandomStream& random) {
        std::size_t accepted = 0;
        for (std::size_t i = 0; i < centres_.size(); ++i) {
            Vector moved = centres_[i];
            for (double& coordinate : moved) coordinate += random.uniform(-step, step);
            moved[0] = region_.x.wrapped(moved[0]);
            moved[1] = region_.y.wrapped(moved[1]);
            if (region_.z.length > 0.0)
                moved[2] = region_.z.wrapped(moved[2]);
            else if (moved[2] < region_.lower || moved[2] > region_.upper)
                continue;
            const double wanted = overlap(moved, i);
            if (wanted > 0.0 && !(overlapping_ && wanted <= overlap(centres_[i], i))) continue;
            const std::size_t from = cell(centres_[i]), to = cell(moved);
            centres_[i] = moved;
            ++accepted;
            if (from == to) continue;
            std::erase(cells_[from], static_cast<std::uint32_t>(i));
            cells_[to].push_back(static_cast<std::uint32_t>(i));
        }
        return static_cast<double>(accepted) / static_cast<double>(centres_.size());
    }

    std::array<std::int64_t, 3> place(const Vector& r) const {
        const std::array<double, 3> length{region_.x.length, region_.y.length, region_.upper - region_.lower};
        const Vector from{r[0], r[1], r[2] - region_.lower};
        std::array<std::int64_t, 3> at;
        for (std::size_t a = 0; a < 3; ++a)
            at[a] = std::clamp<std::int64_t>(
                length[a] > 0.0 ? static_cast<std::int64_t>(from[a] / length[a] * static_cast<double>(count_[a])) : 0,
                0, count_[a] - 1);
        return at;
    }
    std::size_t cell(const Vector& r) const {
        const auto at = place(r);
        return static_cast<std::size_t>((at[2] * count_[1] + at[1]) * count_[0] + at[0]);
    }
    /// Sum of the squared depths to which a particle there would overlap the others; 0: none. While nothing may
    /// overlap, any overlap is 1.
    double overlap(const Vector& r, std::size_t self) const {
        double sum = 0.0;
        const auto at = place(r);
        const auto moved = [&](std::size_t axis, std::int64_t by) {
            return (at[axis] + by + count_[axis]) % count_[axis];
        };
        for (std::int64_t dz = -1; dz <= 1; ++dz)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dx = -1; dx <= 1; ++dx)
                    for (const std::uint32_t j : cells_[static_cast<std::size_t>(
                             (moved(2, dz) * count_[1] + moved(1, dy)) * count_[0] + moved(0, dx))]) {
                        if (j == self) continue;
                        const double x = region_.x.image(centres_[j][0] - r[0]),
                                     y = region_.y.image(centres_[j][1] - r[1]);
                        const double z =
                            region_.z.length > 0.0 ? region_.z.image(centres_[j][2] - r[2]) : centres_[j][2] - r[2];
                        const double square = x * x + y * y + z * z;
                        if (square >= diameter_ * diameter_) continue;
                        if (!overlapping_) return 1.0;
                        const double depth = diameter_ - std::sqrt(square);
                        sum += depth * depth;
                    }
        return sum;
    }

    const Region& region_;
    std::vector<Vector>& centres_;
    std::array<std::int64_t, 3> count_;
    std::vector<std::vector<std::uint32_t>> cells_;
    double diameter_ = 1.0;
    bool overlapping_ = false;  // whether some spheres are still to be pushed apart
};

/// Maxwell velocities with zero total momentum and exactly this temperature.
std::vector<Vector> maxwell_velocities(std::int64_t particles, double temperature, scene::RandomStream& random) {
    std::vector<Vector> velocities(static_cast<std::size_t>(particles));
    for (Vector& v : velocities)
        for (double& component : v) component = random.normal();
    if (particles < 2) {  // no momentum leaves a single particle at rest
        for (Vector& v : velocities) v = {0.0, 0.0, 0.0};
        return velocities;
    }
    Vector mean{};
    for (const Vector& v : velocities)
        for (std::size_t a = 0; a < 3; ++a) mean[a] += v[a] / static_cast<double>(particles);
    double square = 0.0;
    for (Vector& v : velocities)
        for (std::size_t a = 0; a < 3; ++a) {
            v[a] -= mean[a];
            square += v[a] * v[a];
        }
    const double scale = std::sqrt(3.0 * temperature * static_cast<double>(particles) / square);
    for (Vector& v : velocities)
        for (double& component : v) component *= scale;
    return velocities;
}

}  // namespace

Snapshot make_initial_state(const InitialState& state, const Box& box) {
    scene::RandomStream random(state.seed);
    const auto count = static_cast<std::size_t>(state.particles);
    const double material = static_cast<double>(state.particles) * std::numbers::pi / 6.0 / state.volume_fraction;
    Region region{Periodic(box.x), Periodic(box.y), box.periodic_z ? Periodic(box.z) : Periodic(), 0.0, box.z};
    if (!box.periodic_z) {
        const double height = std::max(1.0, material / (box.x * box.y));
        if (height > box.z)
            throw CannotSetUp(
                fmt::format("md: {} particles at initial.volume_fraction = {} stand {:.3g} high, above the "
                            "ceiling at {}",
                            state.particles, state.volume_fraction, height, box.z));
        region.lower = 0.5;
        region.upper = height - 0.5;
    }
    Snapshot start;
    const Lattice lattice = widest_lattice(region, state.particles);
    if (lattice.nearest() < 1.0)
        throw CannotSetUp(
            fmt::format("md: {} particles do not fit at initial.volume_fraction = {} into {} x {}; a lower "
                        "fraction or a larger box would do",
                        state.particles, state.volume_fraction, box.x, box.y));
    std::vector<Vector> sites = sites_of(lattice, region);
    // A random choice of sites in their order, each site taken with the chance that leaves enough for the rest (Knuth's
    // algorithm S), so that particles near in space stay near in memory.
    std::size_t left = sites.size();
    for (const Vector& site : sites)
        if (random.uniform() * static_cast<double>(left--) < static_cast<double>(count - start.position.size()))
            start.position.push_back(site);
    Disorder disorder(region, start.position);
    // Below this the lattice is lost while it is stirred; from there to freezing it would outlast the settling of a run.
    constexpr double lattice_lasts = 0.4, melts_at = 0.3;
    if (box.periodic_z && state.volume_fraction > lattice_lasts && state.volume_fraction <= theory::freezing)
        disorder.melt(scene::cube_root(melts_at / state.volume_fraction), random);
    disorder.stir(random);
    start.velocity = maxwell_velocities(state.particles, state.temperature, random);
    return start;
}

}  // namespace shaken::md
