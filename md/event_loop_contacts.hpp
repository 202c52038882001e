// SPDX-License-Identifier: MIT
// Bodies of md/event_loop.hpp: what a contact does to particles, books and watch.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "md/errors.hpp"

namespace shaken::md {

/// Relative to the plate, in sqrt(g sigma). Slower rebounds leave at this speed: a hop of 5e-9 sigma at gravity 1, and
/// at most 5000 (1 + Gamma) hops per sqrt(sigma/g) of a particle that rides on a plate of peak acceleration Gamma.
inline constexpr double slowest_rebound = 1e-4;
/// The same where the plate falls faster than gravity, relative to the plate's speed and one: the gap then opens by
/// itself, but a particle at rest on the plate must not be made to approach it by round-off.
inline constexpr double slowest_rebound_in_fall = 1e-12;

/// A contact farther than this from touching means a broken invariant, not round-off.
inline constexpr double contact_tolerance = 1e-7;

template <class Law, bool Layered>
void EventLoop<Law, Layered>::collide(std::uint32_t i, std::uint32_t j) {
    Particle& p = particles_[i];
    Particle& q = particles_[j];
    p.move_to(now_);
    q.move_to(now_);
    const double rx = neighbours_.x().image(q.x - p.x), ry = neighbours_.y().image(q.y - p.y);
    const double rz = neighbours_.z().image(q.z - p.z);
    const double vx = q.velocity_x - p.velocity_x, vy = q.velocity_y - p.velocity_y, vz = q.velocity_z - p.velocity_z;
    const double r_dot_v = rx * vx + ry * vy + rz * vz;
    const double r_squared = rx * rx + ry * ry + rz * rz;
    if (!(std::abs(r_squared - 1.0) < contact_tolerance))
        throw InvariantBroken(
            fmt::format("md: particles {} and {} collide at distance {:.17g} in cycle {} at t = {}, "
                        "collision {}",
                        p.id, q.id, std::sqrt(r_squared), cycle_, now_, counters_.pair_collisions));
    ++p.stamp;
    ++q.stamp;
    if (r_dot_v < 0.0) {  // else grazing, and round-off has already turned it round
        watch_.pair(-r_dot_v, p.id, q.id);
        const double since = since_last_contact(i, j);
        const auto restitution = [&](double speed) { return law_(speed, since); };
        const PairImpulse impulse = collide_pair(r_dot_v, r_squared, restitution);
        p.velocity_x += impulse.factor * rx;
        p.velocity_y += impulse.factor * ry;
        p.velocity_z += impulse.factor * rz;
        q.velocity_x -= impulse.factor * rx;
        q.velocity_y -= impulse.factor * ry;
        q.velocity_z -= impulse.factor * rz;
        epoch_sums_.collision_loss += impulse.loss;
        epoch_sums_.virial -= impulse.factor * r_squared;
        counters_.deepest_contact = std::max(counters_.deepest_contact, 0.5 * (1.0 - r_squared));
        if constexpr (Law::frictional) {
            const double length = std::sqrt(r_squared);
            const Vector3 n{rx / length, ry / length, rz / length};
            const Vector3 spin_p = spin(i), spin_q = spin(j);
            const Vector3 both{spin_p[0] + spin_q[0], spin_p[1] + spin_q[1], spin_p[2] + spin_q[2]};
            const TangentialImpulse rub = collide_tangentially(n, {-vx, -vy, -vz}, both, restitution(-r_dot_v / length),
                                                               law_.friction, Partner::sphere);
            p.velocity_x += rub.velocity[0];
            p.velocity_y += rub.velocity[1];
            p.velocity_z += rub.velocity[2];
            q.velocity_x -= rub.velocity[0];
            q.velocity_y -= rub.velocity[1];
            q.velocity_z -= rub.velocity[2];
            epoch_sums_.collision_loss += rub.loss;
            if (!spins_.empty())
                for (std::size_t k = 0; k < 3; ++k) {
                    spins_[p.id][k] += rub.spin[k];
                    spins_[q.id][k] += rub.spin[k];
                }
        }
    }
    ++counters_.pair_collisions;
    note_contact(ContactEvent::Kind::pair, i, j);
    predict(i);
    predict(j);
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::collide_with_plate(std::uint32_t i) {
    if constexpr (Layered) {
        Particle& p = particles_[i];
        p.move_to(now_);
        const double before = p.velocity_z + frame_.velocity(now_), plate = box_.plate->velocity(now_);
        const double cut_off =
            box_.plate->acceleration(now_) > -1.0 ? slowest_rebound : slowest_rebound_in_fall * (1.0 + std::abs(plate));
        const double since = since_last_contact(i, i);
        const auto restitution = [&](double speed) { return law_(speed, since); };
        const WallImpulse impulse = collide_wall(before, plate, 1.0, restitution, cut_off);
        if constexpr (Law::frictional)
            rub_walls(i, before - plate, restitution(std::max(0.0, plate - before)), 1.0, epoch_sums_.plate_loss);
        p.velocity_z += impulse.velocity - before;
        epoch_sums_.plate_work += impulse.work;
        epoch_sums_.plate_loss += impulse.loss;
        epoch_sums_.plate_impulse += impulse.velocity - before;
        ++p.stamp;
        ++counters_.plate_collisions;
        note_contact(ContactEvent::Kind::plate, i, i);
        predict(i);
    }
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::collide_with_ceiling(std::uint32_t i) {
    if constexpr (Layered) {
        Particle& p = particles_[i];
        p.move_to(now_);
        const double before = p.velocity_z + frame_.velocity(now_);
        const double since = since_last_contact(i, i);
        const auto restitution = [&](double speed) { return law_(speed, since); };
        const WallImpulse impulse = collide_wall(before, 0.0, -1.0, restitution, 0.0);
        if constexpr (Law::frictional)
            rub_walls(i, before, restitution(std::max(0.0, before)), -1.0, epoch_sums_.ceiling_loss);
        p.velocity_z += impulse.velocity - before;
        epoch_sums_.ceiling_work += impulse.work;
        epoch_sums_.ceiling_loss += impulse.loss;
        ++p.stamp;
        ++counters_.ceiling_collisions;
        note_contact(ContactEvent::Kind::ceiling, i, i);
        predict(i);
    }
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::rub_walls(std::uint32_t i, double normal_velocity, double e, double side, double& loss) {
    Particle& p = particles_[i];
    const TangentialImpulse rub = collide_tangentially({0.0, 0.0, -side}, {p.velocity_x, p.velocity_y, normal_velocity},
                                                       spin(i), e, law_.friction, Partner::wall);
    p.velocity_x += rub.velocity[0];
    p.velocity_y += rub.velocity[1];
    loss += rub.loss;
    if (!spins_.empty())
        for (std::size_t k = 0; k < 3; ++k) spins_[p.id][k] += rub.spin[k];
}

template <class Law, bool Layered>
double EventLoop<Law, Layered>::since_last_contact([[maybe_unused]] std::uint32_t i, [[maybe_unused]] std::uint32_t j) {
    if constexpr (Law::remedied) {
        double& first = last_contacts_[particles_[i].id];
        double& second = last_contacts_[particles_[j].id];
        const double since = now_ - std::max(first, second);
        first = second = now_;
        return since;
    }
    return 0.0;
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::note_contact(ContactEvent::Kind kind, std::uint32_t i, std::uint32_t j) {
    last_kind_ = kind;
    last_first_ = i;
    last_second_ = j;
    if (watch_.due(contacts())) {
        const std::string who = kind == ContactEvent::Kind::pair
                                    ? fmt::format("particles {} and {}", particles_[i].id, particles_[j].id)
                                    : fmt::format("particle {} and a wall", particles_[i].id);
        watch_.look({contacts(), counters_.pair_collisions, sums_.virial + epoch_sums_.virial}, cycle_, now_, who);
    }
}

}  // namespace shaken::md
