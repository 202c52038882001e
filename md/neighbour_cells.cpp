// SPDX-License-Identifier: MIT
#include "md/neighbour_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

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
        width = std::max(width, std::cbrt(4.0 * box.x * box.y * box.z / static_cast<double>(particles)));
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
    // A layer's cells may be close packed (1.41 per sigma^3); a uniform system's hold the mean and what it fluctuates.
    const double volume = 1.0 / (x_.per_width * y_.per_width * z_.per_width);
    const double mean = static_cast<double>(particles) / (x_.count * y_.count * z_.count);
    const double most = box.periodic_z ? mean + 2.0 * std::sqrt(mean) + 2.0 : 1.4 * volume + 2.0;
    blocks_per_cell_ = static_cast<std::size_t>(most) / lanes + 1;
    const std::size_t cells = static_cast<std::size_t>(x_.count) * y_.count * z_.count;
    blocks_.resize(cells * blocks_per_cell_);
    counts_.resize(cells);
    clear();
}

void NeighbourCells::clear() {
    Block empty;
    empty.x.fill(nowhere);
    empty.y.fill(0.0f);
    empty.z.fill(0.0f);
    empty.half_shell.fill(0.0f);
    empty.particle.fill(0);
    std::fill(blocks_.begin(), blocks_.end(), empty);
    std::fill(counts_.begin(), counts_.end(), std::uint16_t{0});
}

std::uint32_t NeighbourCells::cell_of(double x, double y, double z) const {
    return static_cast<std::uint32_t>((z_.index(z) * y_.count + y_.index(y)) * x_.count + x_.index(x));
}

void NeighbourCells::set(std::size_t cell, std::size_t place, const Entry& entry) {
    Block& block = blocks_of(cell)[place / lanes];
    const std::size_t lane = place % lanes;
    block.x[lane] = entry.x;
    block.y[lane] = entry.y;
    block.z[lane] = entry.z;
    block.half_shell[lane] = entry.half_shell;
    block.particle[lane] = entry.particle;
}

std::size_t NeighbourCells::place_of(std::uint32_t cell, std::uint32_t particle) const {
    const Block* const blocks = blocks_of(cell);
    for (std::size_t place = 0; place < counts_[cell]; ++place)
        if (blocks[place / lanes].particle[place % lanes] == particle) return place;
    throw InvariantBroken("md: a particle is missing from its cell");
}

void NeighbourCells::enter(std::uint32_t cell, const Entry& entry) {
    if (counts_[cell] == blocks_per_cell_ * lanes) make_room();
    set(cell, counts_[cell]++, entry);
}

void NeighbourCells::leave(std::uint32_t cell, std::uint32_t particle) {
    const std::size_t place = place_of(cell, particle);
    const std::size_t last = --counts_[cell];
    const Block& block = blocks_of(cell)[last / lanes];
    const std::size_t lane = last % lanes;
    set(cell, place, {block.x[lane], block.y[lane], block.z[lane], block.half_shell[lane], block.particle[lane]});
    set(cell, last, {nowhere, 0.0f, 0.0f, 0.0f, 0});
}

void NeighbourCells::replace(std::uint32_t cell, const Entry& entry) {
    set(cell, place_of(cell, entry.particle), entry);
}

void NeighbourCells::make_room() {
    const PagedVector<Block> before = blocks_;
    const std::vector<std::uint16_t> counts = counts_;
    const std::size_t per_cell = blocks_per_cell_++;
    blocks_.resize(counts.size() * blocks_per_cell_);
    clear();
    for (std::size_t cell = 0; cell < counts.size(); ++cell)
        std::copy_n(before.data() + cell * per_cell, per_cell, blocks_of(cell));
    counts_ = counts;
}

std::size_t NeighbourCells::within_reach(std::uint32_t cell, const Entry& centre,
                                         std::vector<std::uint32_t>& found) const {
    const auto at = static_cast<std::int32_t>(cell);
    const std::int32_t ix = at % x_.count, iy = at / x_.count % y_.count, iz = at / (x_.count * y_.count);
    const float contact = 1.0f + margin_;  // added last, so that both of a pair compute the same sum
    found.resize(27 * blocks_per_cell_ * lanes);
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
                const Block* block = blocks_of(other);
                for (std::size_t before = 0; before < counts_[other]; before += lanes, ++block) {
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
    out.put("md.cells.blocks_per_cell", static_cast<std::uint64_t>(blocks_per_cell_));
    out.put("md.cells.counts", counts_);
    out.put("md.cells.blocks", std::span<const Block>(blocks_));
}

void NeighbourCells::restore(const files::CheckpointReader& in) {
    blocks_per_cell_ = in.take_one<std::uint64_t>("md.cells.blocks_per_cell");
    in.take_into("md.cells.counts", std::span(counts_));
    const auto stored = in.take<Block>("md.cells.blocks");
    blocks_.assign(stored.begin(), stored.end());
    if (blocks_.size() != counts_.size() * blocks_per_cell_)
        throw files::Damaged("the checkpoint's cells are not its size");
}

}  // namespace shaken::md
