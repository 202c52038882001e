// SPDX-License-Identifier: MIT
// Bodies of md/event_loop.hpp: what the loop shows of its state, and how it is saved and restored. A checkpoint holds
// every predicted event and every neighbour list as they are: predicted anew they would differ in the last bit, and
// the history with them.
#pragma once

#include "files/errors.hpp"

namespace shaken::md {

template <class Law, bool Layered>
Snapshot EventLoop<Law, Layered>::snapshot() const {
    Snapshot shot{cycle_, now_, {}, {}, spins_};
    shot.position.resize(particles_.size());
    shot.velocity.resize(particles_.size());
    for (Particle p : particles_) {
        p.move_to(now_);
        const double height = neighbours_.z().wrapped(p.z) + frame_.displacement(now_);
        shot.position[p.id] = {neighbours_.x().wrapped(p.x), neighbours_.y().wrapped(p.y), height};
        shot.velocity[p.id] = {p.velocity_x, p.velocity_y, p.velocity_z + frame_.velocity(now_)};
    }
    return shot;
}

template <class Law, bool Layered>
Ledger EventLoop<Law, Layered>::ledger() const {
    Ledger total = sums_;
    total += epoch_sums_;
    for (const Vector3& spin : spins_) total.rotational += 0.125 * sphere_inertia * dot(spin, spin);
    for (Particle p : particles_) {
        p.move_to(now_);
        const double velocity_z = p.velocity_z + frame_.velocity(now_);
        total.kinetic += 0.5 * (p.velocity_x * p.velocity_x + p.velocity_y * p.velocity_y + velocity_z * velocity_z);
        if constexpr (Layered) total.potential += p.z + frame_.displacement(now_);
        total.momentum[0] += p.velocity_x;
        total.momentum[1] += p.velocity_y;
        total.momentum[2] += velocity_z;
    }
    return total;
}

template <class Law, bool Layered>
std::int64_t EventLoop<Law, Layered>::memory() const {
    return static_cast<std::int64_t>(particles_.capacity() * sizeof(Particle) + spins_.capacity() * sizeof(Vector3) +
                                     last_contacts_.capacity() * sizeof(double) + neighbours_.bytes() + queue_.bytes());
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::save(files::CheckpointWriter& out) const {
    const std::vector<double> system{box_.x, box_.y, box_.z, period_, static_cast<double>(epochs_)};
    out.put("md.system", system);
    out.put("md.particles", std::span<const Particle>(particles_));
    std::vector<double> times(particles_.size());
    std::vector<EventSubject> predictions(particles_.size());
    for (std::uint32_t i = 0; i < times.size(); ++i) {
        times[i] = queue_.time(i);
        predictions[i] = queue_.subject(i);
    }
    out.put("md.predictions", predictions);
    out.put("md.event_times", times);
    out.put("md.cycle", cycle_);
    out.put("md.epoch", epoch_);
    out.put("md.now", now_);
    out.put("md.frame", frame_);
    out.put("md.counters", counters_);
    out.put("md.sums", sums_);
    out.put("md.epoch_sums", epoch_sums_);
    out.put("md.highest_plate", highest_plate_);
    out.put("md.contacts_at_sort", contacts_at_sort_);
    out.put("md.events_at_epoch_start", events_at_epoch_start_);
    watch_.save(out);
    if (!spins_.empty()) out.put("md.spins", spins_);
    if (!last_contacts_.empty()) out.put("md.last_contacts", last_contacts_);
    neighbours_.save(out);
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::restore(const files::CheckpointReader& in) {
    const std::vector<double> system{box_.x, box_.y, box_.z, period_, static_cast<double>(epochs_)};
    if (in.take<double>("md.system") != system)
        throw files::Damaged("the checkpoint is of another box, period or number of epochs");
    in.take_into("md.particles", std::span(particles_));
    std::vector<EventSubject> predictions(particles_.size());
    in.take_into("md.predictions", std::span(predictions));
    cycle_ = in.take_one<std::int64_t>("md.cycle");
    epoch_ = in.take_one<int>("md.epoch");
    now_ = in.take_one<double>("md.now");
    frame_ = in.take_one<MovingFrame>("md.frame");
    counters_ = in.take_one<Counters>("md.counters");
    sums_ = in.take_one<Ledger>("md.sums");
    epoch_sums_ = in.take_one<Ledger>("md.epoch_sums");
    highest_plate_ = in.take_one<double>("md.highest_plate");
    contacts_at_sort_ = in.take_one<std::int64_t>("md.contacts_at_sort");
    events_at_epoch_start_ = in.take_one<std::int64_t>("md.events_at_epoch_start");
    watch_.restore(in);
    if (!spins_.empty()) in.take_into("md.spins", std::span(spins_));
    if (!last_contacts_.empty()) in.take_into("md.last_contacts", std::span(last_contacts_));
    neighbours_.restore(in);
    const auto times = in.take<double>("md.event_times");
    if (times.size() != particles_.size()) throw files::Damaged("the checkpoint has events of another system");
    queue_.reset(now_, epoch_end(), 4.0 * static_cast<double>(times.size()));
    for (std::uint32_t i = 0; i < times.size(); ++i) queue_.schedule(i, times[i], predictions[i]);
}

}  // namespace shaken::md
