// SPDX-License-Identifier: MIT
#include "md/neighbour_lists.hpp"

#include <algorithm>
#include <cmath>

#include "files/errors.hpp"
#include "md/errors.hpp"

namespace shaken::md {

namespace {

constexpr double wanted_neighbours = 17.0;  // all found by bench/md.md
constexpr double most_ahead = 0.85, ahead_from = 0.3, ahead_per_half_shell = 4.0;

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
      centres_(particles) {}

/// Half shell at which the list would have the wanted length, going by its present one; at most a quarter at a time.
float NeighbourLists::adapted(float half_shell, std::size_t neighbours) const {
    const double reach = 1.0 + 2.0 * static_cast<double>(half_shell);
    const double ratio = scene::cube_root(wanted_neighbours / std::max(1.0, static_cast<double>(neighbours)));
    const double half = 0.5 * (reach * std::clamp(ratio, 0.8, 1.25) - 1.0);
    return static_cast<float>(std::clamp(half, 0.1 * widest_, 0.5 * widest_));
}

NeighbourCells::Entry NeighbourLists::entry(std::uint32_t i) const {
    const Centre& c = centres_[i];
    return {c.x, c.y, c.z, c.half_shell, i};
}

void NeighbourLists::place(std::uint32_t i, Particle& p, double ahead) {
    // The centre is wrapped, and the particle goes with it.
    const auto centred = [](const Periodic& axis, double& position, double offset) {
        const double centre = position + offset, wrapped = axis.wrapped(centre);
        if (wrapped != centre) position += wrapped < centre ? -axis.length : axis.length;
        return wrapped;
    };
    Centre& c = centres_[i];
    c.x = static_cast<float>(centred(x_, p.x, ahead * p.velocity_x));
    c.y = static_cast<float>(centred(y_, p.y, ahead * p.velocity_y));
    c.z = static_cast<float>(centred(z_, p.z, ahead * p.velocity_z) - shift_);
    c.cell = cells_.cell_of(c.x, c.y, c.z);
}

/// Time by which a new centre lies ahead of its particle. In a dilute gas the particle flies on through its
/// neighbourhood, and keeps it longer the farther back in it it starts; in a dense one it is soon turned round.
double NeighbourLists::time_ahead(float half_shell, const Particle& p) const {
    const double half = static_cast<double>(half_shell);
    const double speed =
        std::sqrt(p.velocity_x * p.velocity_x + p.velocity_y * p.velocity_y + p.velocity_z * p.velocity_z);
    const double share = std::clamp(ahead_per_half_shell * (half - ahead_from), 0.0, most_ahead);
    return speed > 0.0 ? share * half / speed : 0.0;
}

/// Changes the length; what the list holds stays as far as it fits.
void NeighbourLists::resize(std::uint32_t i, std::size_t neighbours) {
    Centre& c = centres_[i];
    const bool was_long = c.count > held, becomes_long = neighbours > held;
    if (neighbours > longest_) make_room(neighbours);
    if (becomes_long && !was_long) {
        if (spare_slots_.empty()) {
            spare_slots_.push_back(static_cast<std::uint32_t>(long_lists_.size() / longest_));
            long_lists_.resize(long_lists_.size() + longest_);
        }
        const std::uint32_t slot = spare_slots_.back();
        spare_slots_.pop_back();
        std::copy_n(c.neighbours.begin(), c.count, long_lists_.begin() + static_cast<std::ptrdiff_t>(slot * longest_));
        c.neighbours[0] = slot;
    } else if (was_long && !becomes_long) {
        const std::uint32_t slot = c.neighbours[0];
        spare_slots_.push_back(slot);
        std::copy_n(long_lists_.begin() + static_cast<std::ptrdiff_t>(slot * longest_), neighbours,
                    c.neighbours.begin());
    }
    c.count = static_cast<std::uint32_t>(neighbours);
}

void NeighbourLists::write(std::uint32_t i, std::span<const std::uint32_t> neighbours) {
    resize(i, neighbours.size());
    std::copy(neighbours.begin(), neighbours.end(), list(i).begin());
}

void NeighbourLists::add(std::uint32_t i, std::uint32_t neighbour) {
    resize(i, centres_[i].count + 1);
    list(i).back() = neighbour;
}

void NeighbourLists::remove(std::uint32_t i, std::uint32_t neighbour) {
    const std::span<std::uint32_t> all = list(i);
    const auto found = std::find(all.begin(), all.end(), neighbour);
    if (found == all.end()) throw InvariantBroken("md: neighbour lists are no longer mutual");
    *found = all.back();
    resize(i, all.size() - 1);
}

void NeighbourLists::make_room(std::size_t neighbours) {
    const std::size_t longer = neighbours + neighbours / 4;
    const std::size_t slots = long_lists_.size() / longest_;
    std::vector<std::uint32_t> roomy(slots * longer);
    for (std::size_t slot = 0; slot < slots; ++slot)
        std::copy_n(long_lists_.data() + slot * longest_, longest_, roomy.data() + slot * longer);
    long_lists_ = std::move(roomy);
    longest_ = longer;
}

void NeighbourLists::build(std::span<Particle> particles) {
    const auto count = static_cast<std::uint32_t>(particles.size());
    shift_ = 0.0;
    // A first search at the widest reach tells the local density, from which half shells follow.
    cells_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
        place(i, particles[i], 0.0);
        centres_[i].half_shell = static_cast<float>(0.25 * widest_);
        cells_.enter(centres_[i].cell, entry(i));
    }
    std::vector<std::uint32_t> near(count);
    for (std::uint32_t i = 0; i < count; ++i)
        near[i] = static_cast<std::uint32_t>(cells_.within_reach(centres_[i].cell, entry(i), found_));
    for (std::uint32_t i = 0; i < count; ++i) centres_[i].half_shell = adapted(centres_[i].half_shell, near[i]);
    cells_.clear();
    for (std::uint32_t i = 0; i < count; ++i) cells_.enter(centres_[i].cell, entry(i));
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::size_t neighbours = cells_.within_reach(centres_[i].cell, entry(i), found_);
        write(i, {found_.data(), neighbours});
    }
}

void NeighbourLists::rebuild(std::uint32_t i, Particle& p) {
    Centre& c = centres_[i];
    const std::uint32_t old_cell = c.cell;
    c.half_shell = adapted(c.half_shell, of(i).size());
    place(i, p, time_ahead(c.half_shell, p));
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
    write(i, now);
}

void NeighbourLists::save(files::CheckpointWriter& out) const {
    out.put("md.neighbours.shift", shift_);
    // Only what is in use: places past a list's end hold leftovers that are no part of the state.
    std::vector<NeighbourCells::Entry> centres;
    std::vector<std::uint32_t> cells, used;
    for (std::uint32_t i = 0; i < centres_.size(); ++i) {
        centres.push_back(entry(i));
        cells.push_back(centres_[i].cell);
        used.push_back(centres_[i].count);
        used.insert(used.end(), of(i).begin(), of(i).end());
    }
    out.put("md.neighbours.centres", centres);
    out.put("md.neighbours.cells", cells);
    out.put("md.neighbours.lists", used);
    cells_.save(out);
}

void NeighbourLists::restore(const files::CheckpointReader& in) {
    const auto centres = in.take<NeighbourCells::Entry>("md.neighbours.centres");
    const auto cells = in.take<std::uint32_t>("md.neighbours.cells");
    if (centres.size() != centres_.size() || cells.size() != centres_.size())
        throw files::Damaged("the checkpoint has neighbour lists of another system");
    shift_ = in.take_one<double>("md.neighbours.shift");
    const auto used = in.take<std::uint32_t>("md.neighbours.lists");
    cells_.restore(in);
    std::size_t from = 0;
    for (std::uint32_t i = 0; i < centres_.size(); ++i) {
        if (from >= used.size() || used[from] > used.size() - from - 1)
            throw files::Damaged("the checkpoint's neighbour lists end too soon");
        Centre& c = centres_[i];
        c.x = centres[i].x;
        c.y = centres[i].y;
        c.z = centres[i].z;
        c.half_shell = centres[i].half_shell;
        c.cell = cells[i];
        write(i, {used.data() + from + 1, used[from]});
        from += used[from] + 1;
    }
}

std::size_t NeighbourLists::bytes() const {
    return centres_.capacity() * sizeof(Centre) + cells_.bytes() +
           (long_lists_.capacity() + spare_slots_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace shaken::md
