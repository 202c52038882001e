// SPDX-License-Identifier: MIT
#include "md/neighbour_lists.hpp"

#include <algorithm>
#include <cmath>

#include "files/errors.hpp"
#include "md/errors.hpp"

namespace shaken::md {

namespace {

constexpr double wanted_neighbours = 15.0;  // found by bench/md.md
constexpr std::size_t first_stride = 24;    // one word for the count, half as much again as wanted

bool holds(std::span<const std::uint32_t> list, std::uint32_t wanted) {
    unsigned found = 0;  // no early exit: short lists are compared eight at a time
    for (const std::uint32_t j : list) found |= static_cast<unsigned>(j == wanted);
    return found != 0;
}

}  // namespace

NeighbourLists::NeighbourLists(const Box& box, double widest, std::size_t particles)
    : widest_(widest),
      x_(box.x),
      y_(box.y),
      z_(box.periodic_z ? Periodic(box.z) : Periodic()),
      cells_(box, 1.0 + widest, particles),
      stride_(first_stride),
      centres_(particles),
      rows_(particles * stride_) {}

/// Half shell at which the list would have the wanted length, going by its present one; at most a quarter at a time.
float NeighbourLists::adapted(float half_shell, std::size_t neighbours) const {
    const double reach = 1.0 + 2.0 * static_cast<double>(half_shell);
    const double ratio = std::cbrt(wanted_neighbours / std::max(1.0, static_cast<double>(neighbours)));
    const double half = 0.5 * (reach * std::clamp(ratio, 0.8, 1.25) - 1.0);
    return static_cast<float>(std::clamp(half, 0.1 * widest_, 0.5 * widest_));
}

NeighbourCells::Entry NeighbourLists::entry(std::uint32_t i) const {
    const Centre& c = centres_[i];
    return {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), c.half_shell, i};
}

void NeighbourLists::place(std::uint32_t i, Particle& p) {
    p.x = x_.wrapped(p.x);
    p.y = y_.wrapped(p.y);
    p.z = z_.wrapped(p.z);
    Centre& c = centres_[i];
    c.x = p.x;
    c.y = p.y;
    c.z = p.z - shift_;
    c.cell = cells_.cell_of(c.x, c.y, c.z);
}

void NeighbourLists::write_row(std::uint32_t i, std::span<const std::uint32_t> neighbours) {
    if (neighbours.size() >= stride_) make_room(neighbours.size());
    row(i)[0] = static_cast<std::uint32_t>(neighbours.size());
    std::copy(neighbours.begin(), neighbours.end(), row(i) + 1);
}

void NeighbourLists::add(std::uint32_t i, std::uint32_t neighbour) {
    if (row(i)[0] + 1 >= stride_) make_room(stride_);
    std::uint32_t* const list = row(i);
    list[++list[0]] = neighbour;
}

void NeighbourLists::remove(std::uint32_t i, std::uint32_t neighbour) {
    std::uint32_t* const list = row(i);
    std::uint32_t* const last = list + list[0];
    std::uint32_t* const found = std::find(list + 1, last + 1, neighbour);
    if (found == last + 1) throw InvariantBroken("md: neighbour lists are no longer mutual");
    *found = *last;
    --list[0];
}

void NeighbourLists::make_room(std::size_t neighbours) {
    const std::size_t wider = neighbours / 4 * 4 + 4;
    PagedVector<std::uint32_t> roomy(centres_.size() * wider);
    for (std::size_t i = 0; i < centres_.size(); ++i)
        std::copy_n(rows_.data() + i * stride_, rows_[i * stride_] + 1, roomy.data() + i * wider);
    rows_ = std::move(roomy);
    stride_ = wider;
}

void NeighbourLists::build(std::span<Particle> particles) {
    const auto count = static_cast<std::uint32_t>(particles.size());
    shift_ = 0.0;
    // A first search at the widest reach tells the local density, from which half shells follow.
    cells_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        place(i, particles[i]);
        centres_[i].half_shell = static_cast<float>(0.25 * widest_);
        cells_.enter(centres_[i].cell, entry(i));
    }
    for (std::uint32_t i = 0; i < count; ++i)
        row(i)[0] = static_cast<std::uint32_t>(cells_.within_reach(centres_[i].cell, entry(i), found_));
    for (std::uint32_t i = 0; i < count; ++i) {
        centres_[i].half_shell = adapted(centres_[i].half_shell, row(i)[0]);
        row(i)[0] = 0;
    }
    cells_.clear();
    for (std::uint32_t i = 0; i < count; ++i) cells_.enter(centres_[i].cell, entry(i));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::size_t neighbours = cells_.within_reach(centres_[i].cell, entry(i), found_);
        write_row(i, {found_.data(), neighbours});
    }
}

void NeighbourLists::rebuild(std::uint32_t i, Particle& p) {
    Centre& c = centres_[i];
    const std::uint32_t old_cell = c.cell;
    c.half_shell = adapted(c.half_shell, of(i).size());
    place(i, p);
    if (c.cell == old_cell) {
        cells_.replace(c.cell, entry(i));
    } else {
        cells_.leave(old_cell, i);
        cells_.enter(c.cell, entry(i));
    }
    const std::size_t neighbours = cells_.within_reach(c.cell, entry(i), found_);
    const std::span<const std::uint32_t> now{found_.data(), neighbours};
    // Most neighbours stay: only the lists of those that came or went are touched.
    for (const std::uint32_t j : of(i))
        if (!holds(now, j)) remove(j, i);
    for (const std::uint32_t j : now)
        if (!holds(of(i), j)) add(j, i);
    write_row(i, now);
}

void NeighbourLists::save(files::CheckpointWriter& out) const {
    out.put("md.neighbours.shift", shift_);
    out.put("md.neighbours.centres", std::span<const Centre>(centres_));
    // Only what is in use: places past a list's end hold leftovers that are no part of the state.
    std::vector<std::uint32_t> used;
    for (std::uint32_t i = 0; i < centres_.size(); ++i) {
        used.push_back(static_cast<std::uint32_t>(of(i).size()));
        used.insert(used.end(), of(i).begin(), of(i).end());
    }
    out.put("md.neighbours.lists", used);
    cells_.save(out);
}

void NeighbourLists::restore(const files::CheckpointReader& in) {
    in.take_into("md.neighbours.centres", std::span(centres_));
    shift_ = in.take_one<double>("md.neighbours.shift");
    const auto used = in.take<std::uint32_t>("md.neighbours.lists");
    cells_.restore(in);
    std::size_t from = 0;
    for (std::uint32_t i = 0; i < centres_.size(); ++i) {
        if (from >= used.size() || used[from] > used.size() - from - 1)
            throw files::Damaged("the checkpoint's neighbour lists end too soon");
        write_row(i, {used.data() + from + 1, used[from]});
        from += used[from] + 1;
    }
}

std::size_t NeighbourLists::bytes() const {
    return centres_.capacity() * sizeof(Centre) + rows_.capacity() * sizeof(std::uint32_t) + cells_.bytes();
}

}  // namespace shaken::md
