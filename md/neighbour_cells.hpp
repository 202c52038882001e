// SPDX-License-Identifier: MIT
// Which centres lie within reach of a point. Cells at least as wide as the longest reach hold copies of the centres in
// single precision, eight to a block, so that eight are tried at once. Single precision may let in a centre up to
// `margin` too far, never leave one out. Along a non-periodic z the cells repeat (a hash of the height).
// A cell is a chain of blocks from a common store: an empty one costs eight bytes, a crowded one what it holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "files/checkpoint.hpp"
#include "md/audit.hpp"
#include "md/paged_vector.hpp"

namespace shaken::md {

class NeighbourCells {
  public:
    /// What a cell keeps of a centre. half_shell: a pair is within reach at 1 + the sum of their half shells.
    struct Entry {
        float x, y, z, half_shell;
        std::uint32_t particle;
    };

    NeighbourCells(const Box& box, double longest_reach, std::size_t particles);

    void clear();
    std::uint32_t cell_of(double x, double y, double z) const;
    void enter(std::uint32_t cell, const Entry& entry);
    void leave(std::uint32_t cell, std::uint32_t particle);
    void replace(std::uint32_t cell, const Entry& entry);

    /// Writes to `found` every particle within reach of this centre, itself left out; returns how many. `found` is made
    /// as long as the fullest cells could need.
    std::size_t within_reach(std::uint32_t cell, const Entry& centre, std::vector<std::uint32_t>& found) const;

    /// Every place in every cell, in order: the order of lists, and so the choice among equal times, follows it.
    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);

    double margin() const { return margin_; }
    std::size_t bytes() const {
        return blocks_.capacity() * sizeof(Block) + next_.capacity() * sizeof(next_[0]) +
               cells_.capacity() * sizeof(Cell);
    }

  private:
    static constexpr std::size_t lanes = 8;
    struct alignas(32) Block {
        std::array<float, lanes> x, y, z, half_shell;
        std::array<std::uint32_t, lanes> particle;
    };
    struct Cell {
        std::uint32_t first, count;  // block of the chain; particles
    };
    struct Axis {
        float length = 0.0f;  // 0: not periodic
        double per_width = 1.0;
        std::int32_t count = 1;
        std::int32_t index(double position) const;
        std::int32_t first_offset() const { return count >= 3 ? -1 : 0; }
        std::int32_t last_offset() const { return count >= 2 ? 1 : 0; }
        std::int32_t step(std::int32_t i, std::int32_t offset) const {
            const std::int32_t moved = i + offset;
            return moved < 0 ? moved + count : moved >= count ? moved - count : moved;
        }
    };
    /// Where one particle is kept.
    struct Place {
        std::uint32_t block;
        std::size_t lane;
    };
    static constexpr std::uint32_t none = 0xffffffffu;

    void set(Place place, const Entry& entry);
    Entry get(Place place) const;
    Place place_of(std::uint32_t cell, std::uint32_t particle) const;
    std::uint32_t block_of(const Cell& cell, std::size_t place) const;
    std::uint32_t take_block();

    Axis x_, y_, z_;
    float margin_;
    PagedVector<Block> blocks_;        // unused places lie out of every reach
    PagedVector<std::uint32_t> next_;  // of each block: the next of its chain, or of those to spare
    std::uint32_t spare_ = none;
    PagedVector<Cell> cells_;
    std::size_t fullest_ = 0;  // particles that any one cell has held at once
};

}  // namespace shaken::md
