// SPDX-License-Identifier: MIT
#include "md/neighbour_lists.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "md/errors.hpp"

namespace md {

namespace {

constexpr std::uint32_t end = 0xffffffffu;

std::int32_t cells_across(double length, double reach) {
    return std::max(1, static_cast<std::int32_t>(std::floor(length / reach)));
}

}  // namespace

std::int32_t NeighbourLists::Axis::index(double position, double origin) const {
    const double scaled = (position - origin) * per_length;
    if (repeats) return static_cast<std::int32_t>(static_cast<std::int64_t>(std::floor(scaled)) & (count - 1));
    return std::clamp(static_cast<std::int32_t>(scaled), 0, count - 1);
}

NeighbourLists::NeighbourLists(const Box& box, double shell, std::size_t particles)
    : shell_(shell), x_(box.x), y_(box.y), z_(box.periodic_z ? Periodic(box.z) : Periodic()) {
    const double reach = (1.0 + shell) * (1.0 + 1e-9);  // round-off must not put neighbours two cells apart
    const auto tiled = [&](double length) {
        const std::int32_t count = cells_across(length, reach);
        return Axis{count / length, count, false};
    };
    axis_x_ = tiled(box.x);
    axis_y_ = tiled(box.y);
    if (box.periodic_z) {
        axis_z_ = tiled(box.z);
    } else {
        // Twice the height of the packed layer is enough; what flies higher shares cells with what lies below.
        const double packed = static_cast<double>(particles) / (box.x * box.y);
        const double height = std::min(box.z, 8.0 + 4.0 * packed);
        axis_z_ = {1.0 / reach, static_cast<std::int32_t>(std::bit_ceil(static_cast<unsigned>(height / reach) + 4)),
                   true};
    }
    // A packed layer (0.74 close packed) has at most this many centres in reach; make_room() serves the rest.
    capacity_ = static_cast<std::size_t>(std::ceil(8.0 * 0.7 * reach * reach * reach)) + 4;
    capacity_ = (capacity_ + 3) / 4 * 4;
    centres_.resize(particles);
    neighbours_.resize(particles * capacity_);
    cell_next_.resize(particles);
    cell_previous_.resize(particles);
    cell_first_.resize(static_cast<std::size_t>(axis_x_.count) * axis_y_.count * axis_z_.count);
}

std::uint32_t NeighbourLists::cell_of(const Centre& c) const {
    const std::int32_t ix = axis_x_.index(c.x, 0.0), iy = axis_y_.index(c.y, 0.0);
    const std::int32_t iz = axis_z_.index(c.z, axis_z_.repeats ? origin_z_ : 0.0);
    return static_cast<std::uint32_t>((iz * axis_y_.count + iy) * axis_x_.count + ix);
}

void NeighbourLists::enter_cell(std::uint32_t i) {
    std::uint32_t& first = cell_first_[centres_[i].cell];
    cell_next_[i] = first;
    cell_previous_[i] = end;
    if (first != end) cell_previous_[first] = i;
    first = i;
}

void NeighbourLists::leave_cell(std::uint32_t i) {
    if (cell_previous_[i] == end)
        cell_first_[centres_[i].cell] = cell_next_[i];
    else
        cell_next_[cell_previous_[i]] = cell_next_[i];
    if (cell_next_[i] != end) cell_previous_[cell_next_[i]] = cell_previous_[i];
}

template <class Visit>
void NeighbourLists::visit_around(std::uint32_t i, Visit visit) const {
    const Centre& c = centres_[i];
    const double reach_squared = (1.0 + shell_) * (1.0 + shell_);
    const auto cell = static_cast<std::int32_t>(c.cell);
    const std::int32_t ix = cell % axis_x_.count, iy = cell / axis_x_.count % axis_y_.count;
    const std::int32_t iz = cell / (axis_x_.count * axis_y_.count);
    for (std::int32_t dz = axis_z_.first_offset(); dz <= axis_z_.last_offset(); ++dz)
        for (std::int32_t dy = axis_y_.first_offset(); dy <= axis_y_.last_offset(); ++dy) {
            const std::int32_t row = (axis_z_.step(iz, dz) * axis_y_.count + axis_y_.step(iy, dy)) * axis_x_.count;
            for (std::int32_t dx = axis_x_.first_offset(); dx <= axis_x_.last_offset(); ++dx)
                for (std::uint32_t j = cell_first_[static_cast<std::size_t>(row + axis_x_.step(ix, dx))]; j != end;
                     j = cell_next_[j]) {
                    const double rx = x_.image(centres_[j].x - c.x), ry = y_.image(centres_[j].y - c.y);
                    const double rz = axis_z_.repeats ? centres_[j].z - c.z : z_.image(centres_[j].z - c.z);
                    if (rx * rx + ry * ry + rz * rz < reach_squared && j != i) visit(j);
                }
        }
}

void NeighbourLists::add(std::uint32_t i, std::uint32_t neighbour) {
    if (centres_[i].count == capacity_) make_room();
    list(i)[centres_[i].count++] = neighbour;
}

void NeighbourLists::remove(std::uint32_t i, std::uint32_t neighbour) {
    std::uint32_t* const first = list(i);
    std::uint32_t* const last = first + centres_[i].count;
    std::uint32_t* const found = std::find(first, last, neighbour);
    if (found == last) throw InvariantBroken("md: neighbour lists are no longer mutual");
    *found = *(last - 1);
    --centres_[i].count;
}

void NeighbourLists::make_room() {
    const std::size_t wider = capacity_ + 8;
    std::vector<std::uint32_t> roomy(centres_.size() * wider);
    for (std::size_t i = 0; i < centres_.size(); ++i)
        std::copy_n(neighbours_.data() + i * capacity_, centres_[i].count, roomy.data() + i * wider);
    neighbours_ = std::move(roomy);
    capacity_ = wider;
}

void NeighbourLists::build(std::span<Particle> particles) {
    std::fill(cell_first_.begin(), cell_first_.end(), end);
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
        Particle& p = particles[i];
        p.x = x_.wrapped(p.x);
        p.y = y_.wrapped(p.y);
        if (!axis_z_.repeats) p.z = z_.wrapped(p.z);
        centres_[i] = {p.x, p.y, p.z, 0, 0};
        centres_[i].cell = cell_of(centres_[i]);
    }
    // Entered from the last to the first, so that each cell lists its particles in rising order.
    for (auto i = static_cast<std::uint32_t>(particles.size()); i-- > 0;) enter_cell(i);
    for (std::uint32_t i = 0; i < particles.size(); ++i) visit_around(i, [&](std::uint32_t j) { add(i, j); });
}

void NeighbourLists::rebuild(std::uint32_t i, Particle& p) {
    for (const std::uint32_t j : of(i)) remove(j, i);
    p.x = x_.wrapped(p.x);
    p.y = y_.wrapped(p.y);
    if (!axis_z_.repeats) p.z = z_.wrapped(p.z);
    Centre moved{p.x, p.y, p.z, 0, 0};
    moved.cell = cell_of(moved);
    if (moved.cell != centres_[i].cell) {
        leave_cell(i);
        centres_[i] = moved;
        enter_cell(i);
    } else {
        centres_[i] = moved;
    }
    visit_around(i, [&](std::uint32_t j) {
        add(i, j);
        add(j, i);
    });
}

void NeighbourLists::shift_heights(double shift) {
    for (Centre& c : centres_) c.z += shift;
    origin_z_ += shift;
}

void NeighbourLists::save(files::CheckpointWriter& out) const {
    out.put("md.neighbours.origin", origin_z_);
    out.put("md.neighbours.capacity", static_cast<std::uint64_t>(capacity_));
    out.put("md.neighbours.centres", centres_);
    // Only what is in use: places beyond a list's end hold leftovers that are no part of the state.
    std::vector<std::uint32_t> used;
    for (std::uint32_t i = 0; i < centres_.size(); ++i) used.insert(used.end(), of(i).begin(), of(i).end());
    out.put("md.neighbours.lists", used);
    out.put("md.neighbours.cell_first", cell_first_);
    out.put("md.neighbours.cell_next", cell_next_);
    out.put("md.neighbours.cell_previous", cell_previous_);
}

void NeighbourLists::restore(const files::CheckpointReader& in) {
    in.take_into("md.neighbours.centres", std::span(centres_));
    in.take_into("md.neighbours.cell_first", std::span(cell_first_));
    in.take_into("md.neighbours.cell_next", std::span(cell_next_));
    in.take_into("md.neighbours.cell_previous", std::span(cell_previous_));
    origin_z_ = in.take_one<double>("md.neighbours.origin");
    capacity_ = in.take_one<std::uint64_t>("md.neighbours.capacity");
    neighbours_.assign(centres_.size() * capacity_, 0);
    const auto used = in.take<std::uint32_t>("md.neighbours.lists");
    std::size_t from = 0;
    for (std::uint32_t i = 0; i < centres_.size(); ++i) {
        std::copy_n(used.data() + from, centres_[i].count, list(i));
        from += centres_[i].count;
    }
}

std::size_t NeighbourLists::bytes() const {
    return centres_.capacity() * sizeof(Centre) +
           (neighbours_.capacity() + cell_first_.capacity() + cell_next_.capacity() + cell_previous_.capacity()) *
               sizeof(std::uint32_t);
}

}  // namespace md
