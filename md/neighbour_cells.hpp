// SPDX-License-Identifier: MIT
// Which centres lie within reach of a point. Cells at least as wide as the longest reach hold copies of the centres in
// single precision, eight to a block, so that eight are tried at once. Single precision may let in a centre up to
// `margin` too far, never leave one out. Along a non-periodic z the cells repeat (a hash of the height).
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

    /// Writes to `found` every particle within reach of this centre, itself left out; returns how many. `found` holds
    /// as many as three layers of cells can.
    std::size_t within_reach(std::uint32_t cell, const Entry& centre, std::vector<std::uint32_t>& found) const;

    /// Every place in every cell, in order: the order of lists, and so the choice among equal times, follows it.
    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);

    double margin() const { return margin_; }
    std::size_t bytes() const { return blocks_.capacity() * sizeof(Block) + counts_.capacity() * sizeof(counts_[0]); }

  private:
    static constexpr std::size_t lanes = 8;
    struct alignas(32) Block {
        std::array<float, lanes> x, y, z, half_shell;
        std::array<std::uint32_t, lanes> particle;
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
    void set(std::size_t cell, std::size_t place, const Entry& entry);
    std::size_t place_of(std::uint32_t cell, std::uint32_t particle) const;
    void make_room();
    Block* blocks_of(std::size_t cell) { return blocks_.data() + cell * blocks_per_cell_; }
    const Block* blocks_of(std::size_t cell) const { return blocks_.data() + cell * blocks_per_cell_; }

    Axis x_, y_, z_;
    float margin_;
    std::size_t blocks_per_cell_;
    PagedVector<Block> blocks_;          // (cells, blocks per cell); unused places lie out of every reach
    std::vector<std::uint16_t> counts_;  // (cells)
};

}  // namespace shaken::md
