// SPDX-License-Identifier: MIT
// Who may touch whom soon. Each particle has a centre (where it stood when its list was made) and the list of all
// particles whose centres lie within 1 + shell of its own. While both stay within shell/2 of their centres, no pair
// outside the lists can touch; a particle that leaves gets a new centre and list, alone. Lists are mutual.
// Centres are found through cells; along a non-periodic z the cells repeat (a hash of the height), so that the layer
// may rise and the frame may move without bound.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "files/checkpoint.hpp"
#include "md/audit.hpp"
#include "md/particle.hpp"

namespace md {

/// Along one axis: the minimum image of a difference. length 0: not periodic.
struct Periodic {
    double length = 0.0, half = 0.0;
    Periodic() = default;
    explicit Periodic(double l) : length(l), half(0.5 * l) {}
    double image(double difference) const {
        if (difference > half) return difference - length;
        if (difference < -half) return difference + length;
        return difference;
    }
    double wrapped(double position) const {
        if (position < 0.0) position += length;
        if (position >= length) position -= length;
        return position;
    }
};

class NeighbourLists {
  public:
    struct Centre {
        double x, y, z;
        std::uint32_t count;  // neighbours in the list
        std::uint32_t cell;
    };

    /// shell > 0, at most (L/2 - 1)/2 for periodic lengths L, so that one image of a neighbour suffices.
    NeighbourLists(const Box& box, double shell, std::size_t particles);

    /// All centres and lists anew, from the present positions.
    void build(std::span<Particle> particles);
    /// One particle's centre and list anew, and its place in the lists of others. Its position is wrapped.
    void rebuild(std::uint32_t i, Particle& particle);
    /// The frame has moved: every centre keeps its place in the laboratory.
    void shift_heights(double shift);

    std::span<const std::uint32_t> of(std::uint32_t i) const { return {list(i), centres_[i].count}; }
    const Centre& centre(std::uint32_t i) const { return centres_[i]; }
    double free_radius_squared() const { return 0.25 * shell_ * shell_; }
    const Periodic& x() const { return x_; }
    const Periodic& y() const { return y_; }
    const Periodic& z() const { return z_; }

    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);
    std::size_t bytes() const;

  private:
    /// Cells along one axis; periodic ones tile the box, others repeat.
    struct Axis {
        double per_length = 1.0;
        std::int32_t count = 1;
        bool repeats = false;
        std::int32_t index(double position, double origin) const;
        std::int32_t first_offset() const { return count >= 3 ? -1 : 0; }
        std::int32_t last_offset() const { return count >= 2 ? 1 : 0; }
        std::int32_t step(std::int32_t i, std::int32_t offset) const {
            const std::int32_t moved = i + offset;
            return moved < 0 ? moved + count : moved >= count ? moved - count : moved;
        }
    };
    std::uint32_t* list(std::uint32_t i) { return neighbours_.data() + static_cast<std::size_t>(i) * capacity_; }
    const std::uint32_t* list(std::uint32_t i) const {
        return neighbours_.data() + static_cast<std::size_t>(i) * capacity_;
    }
    std::uint32_t cell_of(const Centre& centre) const;
    void enter_cell(std::uint32_t i);
    void leave_cell(std::uint32_t i);
    void add(std::uint32_t i, std::uint32_t neighbour);
    void remove(std::uint32_t i, std::uint32_t neighbour);
    void make_room();
    template <class Visit>
    void visit_around(std::uint32_t i, Visit visit) const;

    double shell_;
    Periodic x_, y_, z_;
    Axis axis_x_, axis_y_, axis_z_;
    double origin_z_ = 0.0;  // moves with the frame
    std::size_t capacity_;
    std::vector<Centre> centres_;
    std::vector<std::uint32_t> neighbours_;  // (N, capacity)
    std::vector<std::uint32_t> cell_first_;
    std::vector<std::uint32_t> cell_next_, cell_previous_;
};

}  // namespace md
