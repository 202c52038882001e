// SPDX-License-Identifier: MIT
#include "md/neighbour_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "files/errors.hpp"
#include "md/errors.hpp"

namespace shaken::md {

namespace {

/// In an unused place: no comparison with it is true, periodic image or not.
constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();

}  // namespace

std::int32_t NeighbourCells::Axis::index(double position) const {
    const double scaled = position * per_width;
    if (length == 0.0f) return static_cast<std::int32_t>(static_cast<std::int64_t>(std::floor(scaled)) & (count - 1));
    return std::clamp(static_cast<std::int32_t>(scaled), 0, count - 1);
}

NeighbourCells::NeighbourCells(const Box& box, double longest_reach, std::size_t particles) {
    const double largest = std::max({box.x, box.y, box.z});
    // Eight units in the last place of the largest coordinate: three differences of two rounded numbers each.
    margin_ = static_cast<float>(8.0 * largest) * std::numeric_limits<float>::epsilon();
    double width = longest_reach + 2.0 * margin_;
    // In a dilute uniform system wider cells, of a few particles each, keep their number below that of the particles.
    if (box.periodic_z)
        width = std::max(width, scene::cube_root(4.0 * box.x * box.y * box.z / static_cast<double>(particles)));
    const auto tiled = [&](double length) {
        const auto count = std::max(1, static_cast<std::int32_t>(std::floor(length / width)));
        return Axis{static_cast<float>(length), count / length, count};
    };
    x_ = tiled(box.x);
    y_ = tiled(box.y);
    if (box.periodic_z) {
        z_ = tiled(box.z);
    } else {
        // Twice the height of the packed layer; what flies higher shares cells with what lies below.
        const double height = std::min(box.z, 6.0 + 2.0 * static_cast<double>(particles) / (box.x * box.y));
        z_ = {0.0f, 1.0 / width, static_cast<std::int32_t>(std::bit_ceil(static_cast<unsigned>(height / width) + 3))};
    }
    cells_.resize(static_cast<std::size_t>(x_.count) * y_.count * z_.count);
    clear();
}

void NeighbourCells::clear() {
    blocks_.clear();
    next_.clear();
    spare_ = none;
    std::fill(cells_.begin(), cells_.end(), Cell{none, 0});
}

std::uint32_t NeighbourCells::cell_of(double x, double y, double z) const {
    return static_cast<std::uint32_t>((z_.index(z) * y_.count + y_.index(y)) * x_.count + x_.index(x));
}

void NeighbourCells::set(Place place, const Entry& entry) {
    Block& block = blocks_[place.block];
    block.x[place.lane] = entry.x;
    block.y[place.lane] = entry.y;
    block.z[place.lane] = entry.z;
    block.half_shell[place.lane] = entry.half_shell;
    block.particle[place.lane] = entry.particle;
}

NeighbourCells::Entry NeighbourCells::get(Place place) const {
    const Block& block = blocks_[place.block];
    return {block.x[place.lane], block.y[place.lane], block.z[place.lane], block.half_shell[place.lane],
            block.particle[place.lane]};
}

NeighbourCells::Place NeighbourCells::place_of(std::uint32_t cell, std::uint32_t particle) const {
    std::size_t left = cells_[cell].count;
    for (std::uint32_t block = cells_[cell].first; left > 0; block = next_[block]) {
        const std::size_t held = std::min(left, lanes);
        for (std::size_t lane = 0; lane < held; ++lane)
            if (blocks_[block].particle[lane] == particle) return {block, lane};
        left -= held;
    }
    throw InvariantBroken("md: a particle is missing from its cell");
}

/// The block of the chain that holds this place; `none` if the chain ends before.
std::uint32_t NeighbourCells::block_of(const Cell& cell, std::size_t place) const {
    std::uint32_t block = cell.first;
    for (std::size_t passed = lanes; passed <= place && block != none; passed += lanes) block = next_[block];
    return block;
}

std::uint32_t NeighbourCells::take_block() {
    std::uint32_t taken = spare_;
    if (taken == none) {
        taken = static_cast<std::uint32_t>(blocks_.size());
        if (blocks_.size() == blocks_.capacity()) {  // an eighth more, not twice as much
            blocks_.reserve(blocks_.size() + blocks_.size() / 8 + 16);
            next_.reserve(blocks_.capacity());
        }
        blocks_.emplace_back();
        next_.push_back(none);
    } else {
        spare_ = next_[taken];
    }
    Block& block = blocks_[taken];
    block.x.fill(nowhere);
    block.y.fill(0.0f);
    block.z.fill(0.0f);
    block.half_shell.fill(0.0f);
    block.particle.fill(0);
    next_[taken] = none;
    return taken;
}

void NeighbourCells::enter(std::uint32_t cell, const Entry& entry) {
    const std::size_t place = cells_[cell].count;
    if (place % lanes == 0) {
        const std::uint32_t taken = take_block();
        if (place == 0)
            cells_[cell].first = taken;
        else
            next_[block_of(cells_[cell], place - 1)] = taken;
    }
    set({block_of(cells_[cell], place), place % lanes}, entry);
    ++cells_[cell].count;
    fullest_ = std::max(fullest_, place + 1);
}

void NeighbourCells::leave(std::uint32_t cell, std::uint32_t particle) {
    const Place place = place_of(cell, particle);
    const std::size_t last = --cells_[cell].count;
    const Place end{block_of(cells_[cell], last), last % lanes};
    set(place, get(end));
    set(end, {nowhere, 0.0f, 0.0f, 0.0f, 0});
    if (end.lane != 0) return;
    next_[end.block] = spare_;
    spare_ = end.block;
    if (last == 0) cells_[cell].first = none;
}

void NeighbourCells::replace(std::uint32_t cell, const Entry& entry) { set(place_of(cell, entry.particle), entry); }

std::size_t NeighbourCells::within_reach(std::uint32_t cell, const Entry& centre,
                                         std::vector<std::uint32_t>& found) const {
    const auto at = static_cast<std::int32_t>(cell);
    const std::int32_t ix = at % x_.count, iy = at / x_.count % y_.count, iz = at / (x_.count * y_.count);
    const float contact = 1.0f + margin_;  // added last, so that both of a pair compute the same sum
    found.resize(27 * (fullest_ + lanes));
    std::uint32_t* out = found.data();
#if defined(__AVX2__)
    const __m256 cx = _mm256_set1_ps(centre.x), cy = _mm256_set1_ps(centre.y), cz = _mm256_set1_ps(centre.z);
    const __m256 own_shell = _mm256_set1_ps(centre.half_shell), touching = _mm256_set1_ps(contact);
    const auto image = [](__m256 difference, float length) {
        if (length == 0.0f) return difference;
        const __m256 turns = _mm256_round_ps(_mm256_mul_ps(difference, _mm256_set1_ps(1.0f / length)),
                                             _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
        return _mm256_sub_ps(difference, _mm256_mul_ps(turns, _mm256_set1_ps(length)));
    };
#else
    const auto image = [](float difference, float length) {
        return length == 0.0f ? difference : difference - length * std::nearbyint(difference / length);
    };
#endif
    for (std::int32_t dz = z_.first_offset(); dz <= z_.last_offset(); ++dz)
        for (std::int32_t dy = y_.first_offset(); dy <= y_.last_offset(); ++dy) {
            const std::int32_t row = (z_.step(iz, dz) * y_.count + y_.step(iy, dy)) * x_.count;
            for (std::int32_t dx = x_.first_offset(); dx <= x_.last_offset(); ++dx) {
                const auto other = static_cast<std::size_t>(row + x_.step(ix, dx));
                std::size_t before = 0;
                for (std::uint32_t at_block = cells_[other].first; before < cells_[other].count;
                     before += lanes, at_block = next_[at_block]) {
                    const Block* const block = &blocks_[at_block];
#if defined(__AVX2__)
                    const __m256 rx = image(_mm256_sub_ps(_mm256_load_ps(block->x.data()), cx), x_.length);
                    const __m256 ry = image(_mm256_sub_ps(_mm256_load_ps(block->y.data()), cy), y_.length);
                    const __m256 rz = image(_mm256_sub_ps(_mm256_load_ps(block->z.data()), cz), z_.length);
                    const __m256 limit =
                        _mm256_add_ps(_mm256_add_ps(own_shell, _mm256_load_ps(block->half_shell.data())), touching);
                    const __m256 squared = _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(rx, rx), _mm256_mul_ps(ry, ry)),
                                                         _mm256_mul_ps(rz, rz));
                    auto near = static_cast<unsigned>(
                        _mm256_movemask_ps(_mm256_cmp_ps(squared, _mm256_mul_ps(limit, limit), _CMP_LT_OQ)));
                    for (; near != 0; near &= near - 1) {
                        *out = block->particle[static_cast<std::size_t>(std::countr_zero(near))];
                        out += *out != centre.particle;
                    }
#else
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        const float rx = image(block->x[lane] - centre.x, x_.length);
                        const float ry = image(block->y[lane] - centre.y, y_.length);
                        const float rz = image(block->z[lane] - centre.z, z_.length);
                        const float limit = (centre.half_shell + block->half_shell[lane]) + contact;
                        if (rx * rx + ry * ry + rz * rz < limit * limit && block->particle[lane] != centre.particle)
                            *out++ = block->particle[lane];
                    }
#endif
                }
            }
        }
    return static_cast<std::size_t>(out - found.data());
}

void NeighbourCells::save(files::CheckpointWriter& out) const {
    std::vector<std::uint32_t> counts;
    std::vector<Entry> entries;
    for (const Cell& cell : cells_) {
        counts.push_back(cell.count);
        std::uint32_t block = cell.first;
        for (std::size_t place = 0; place < cell.count; ++place) {
            entries.push_back(get({block, place % lanes}));
            if (place % lanes == lanes - 1) block = next_[block];
        }
    }
    out.put("md.cells.counts", counts);
    out.put("md.cells.entries", entries);
}

void NeighbourCells::restore(const files::CheckpointReader& in) {
    const auto counts = in.take<std::uint32_t>("md.cells.counts");
    const auto entries = in.take<Entry>("md.cells.entries");
    if (counts.size() != cells_.size() ||
        std::accumulate(counts.begin(), counts.end(), std::size_t{0}) != entries.size())
        throw files::Damaged("the checkpoint's cells are not its size");
    clear();
    std::size_t from = 0;
    for (std::uint32_t cell = 0; cell < counts.size(); ++cell)
        for (std::uint32_t n = 0; n < counts[cell]; ++n) enter(cell, entries[from++]);
}

}  // namespace shaken::md
