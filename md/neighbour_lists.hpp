// SPDX-License-Identifier: MIT
// Who may touch whom soon. Each particle has a centre (near where it stood when its list was made), a half shell (how
// far from there it may go) and the list of all particles whose centres are within 1 + both half shells of its own.
// While both stay within their half shells, no pair outside the lists can touch; a particle that leaves gets a new
// centre and list, alone. Lists are mutual. Half shells follow the local density, so that lists have about the same
// length: in a dilute gas particles keep their lists for longer flights.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "files/checkpoint.hpp"
#include "md/audit.hpp"
#include "md/neighbour_cells.hpp"
#include "md/paged_vector.hpp"
#include "md/particle.hpp"

namespace shaken::md {

/// Along one axis: the minimum image of a difference. length 0: not periodic.
struct Periodic {
    double length = 0.0, half = std::numeric_limits<double>::infinity(), per_length = 0.0;
    Periodic() = default;
    explicit Periodic(double l) : length(l), half(0.5 * l), per_length(1.0 / l) {}
    double image(double difference) const {
        if (difference > half) return difference - length;
        if (difference < -half) return difference + length;
        return difference;
    }
    double wrapped(double position) const {
        if (length == 0.0) return position;
        if (position < 0.0) position += length;
        if (position >= length) position -= length;
        return position;
    }
};

class NeighbourLists {
  public:
    /// How many neighbours a record holds; longer lists lie elsewhere as a whole.
    static constexpr std::size_t held = 26;
    /// A particle's centre and list, in two cache lines side by side. The centre is exactly these single-precision
    /// numbers, wherever the particle stood.
    struct alignas(128) Centre {
        float x, y, z;  // z less the frame's shift()
        float half_shell;
        std::uint32_t cell;
        std::uint32_t count;  // neighbours
        std::array<std::uint32_t, held> neighbours;
    };
    static_assert(sizeof(Centre) == 128);

    /// widest: largest sum of two half shells, at most (L/2 - 1)/2 for periodic lengths L, so that one image of a
    /// neighbour suffices. Half shells stay between a fifth of that and the half of it.
    NeighbourLists(const Box& box, double widest, std::size_t particles);

    /// All centres and lists anew, from the present positions, which are wrapped.
    void build(std::span<Particle> particles);
    /// One particle's centre and list anew, and its place in the lists of others. Its position is wrapped.
    void rebuild(std::uint32_t i, Particle& particle);
    /// The frame has moved: every centre keeps its place in the laboratory.
    void shift_heights(double shift) { shift_ += shift; }

    std::span<const std::uint32_t> of(std::uint32_t i) const {
        const Centre& c = centres_[i];
        return {c.count <= held ? c.neighbours.data() : long_list(c), c.count};
    }
    const Centre& centre(std::uint32_t i) const { return centres_[i]; }
    double shift() const { return shift_; }
    /// Whether a centre is so far from the periodic boundaries that no neighbour is seen across one.
    bool inside(const Centre& c) const {
        const double margin = 1.0 + 2.0 * widest_;
        return std::abs(c.x - x_.half) < x_.half - margin && std::abs(c.y - y_.half) < y_.half - margin &&
               (z_.length == 0.0 || std::abs(c.z - z_.half) < z_.half - margin);
    }
    const Periodic& x() const { return x_; }
    const Periodic& y() const { return y_; }
    const Periodic& z() const { return z_; }
    double margin() const { return cells_.margin(); }

    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);
    std::size_t bytes() const;

  private:
    std::span<std::uint32_t> list(std::uint32_t i) {
        Centre& c = centres_[i];
        return {c.count <= held ? c.neighbours.data() : long_lists_.data() + c.neighbours[0] * longest_, c.count};
    }
    const std::uint32_t* long_list(const Centre& c) const { return long_lists_.data() + c.neighbours[0] * longest_; }
    float adapted(float half_shell, std::size_t neighbours) const;
    NeighbourCells::Entry entry(std::uint32_t i) const;
    void place(std::uint32_t i, Particle& particle, double ahead);
    double time_ahead(float half_shell, const Particle& particle) const;
    void write(std::uint32_t i, std::span<const std::uint32_t> neighbours);
    void resize(std::uint32_t i, std::size_t neighbours);
    void add(std::uint32_t i, std::uint32_t neighbour);
    void remove(std::uint32_t i, std::uint32_t neighbour);
    void make_room(std::size_t neighbours);

    double widest_;
    Periodic x_, y_, z_;
    NeighbourCells cells_;
    double shift_ = 0.0;
    PagedVector<Centre> centres_;
    std::size_t longest_ = 2 * held;         // places of a long list
    std::vector<std::uint32_t> long_lists_;  // (slots, longest_); a record names its slot in its first place
    std::vector<std::uint32_t> spare_slots_;
    std::vector<std::uint32_t> found_;  // by the last search
};

}  // namespace shaken::md
