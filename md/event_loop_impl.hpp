// SPDX-License-Identifier: MIT
// Bodies of md/event_loop.hpp: set-up, epochs, the loop itself and what it predicts.
#pragma once

#include <algorithm>
#include <cmath>

#include "md/contact_time.hpp"
#include "md/nearest_contact.hpp"
#include "md/plate_contact_time.hpp"
#include "md/sort_in_space.hpp"

namespace shaken::md {

/// The frame follows the layer at least this often, in sqrt(sigma/g): within an epoch heights in it grow as the square
/// of time, and their round-off with them. A plate of f > 1/32 has sixteen epochs a cycle.
inline constexpr double longest_epoch = 2.0;
inline constexpr int fewest_epochs = 16;

inline int epochs_of_layer(double period) {
    return std::max(fewest_epochs, static_cast<int>(std::ceil(period / longest_epoch)));
}

/// The widest sum of two half shells: what the options say, or the default, within what the box allows.
double choose_shell(const Setup& setup);

template <class Law, bool Layered>
EventLoop<Law, Layered>::EventLoop(const Setup& setup, const Law& law)
    : box_(setup.box),
      period_(setup.period),
      law_(law),
      epochs_(setup.options.frames_per_cycle > 0 ? setup.options.frames_per_cycle
              : Layered                          ? epochs_of_layer(setup.period)
                                                 : 1),
      contacts_between_sorts_(setup.options.contacts_between_sorts > 0.0 ? setup.options.contacts_between_sorts
                                                                         : 100.0),
      cycle_(setup.start.cycle),
      epoch_(std::min(epochs_ - 1, static_cast<int>(setup.start.time_in_cycle / setup.period * epochs_))),
      now_(setup.start.time_in_cycle),
      particles_(setup.start.position.size()),
      neighbours_(setup.box, choose_shell(setup), particles_.size()),
      queue_(particles_.size()),
      watch_(Law::collapses, static_cast<double>(particles_.size())) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        const auto& r = setup.start.position[i];
        const auto& v = setup.start.velocity[i];
        particles_[i] = {r[0], r[1], r[2], v[0], v[1], v[2], now_, 0, static_cast<std::uint32_t>(i)};
    }
    if (Law::frictional && law_.friction.per_inertia > 0.0) {
        spins_ = setup.start.spin;
        spins_.resize(particles_.size());
    }
    if (Law::remedied) last_contacts_.assign(particles_.size(), -never);
    frame_.gravity = Layered ? 1.0 : 0.0;
    watch_.start(now_);
    sort_in_space();
    begin_epoch();
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::sort_in_space() {
    md::sort_in_space(particles_);
    neighbours_.build(particles_);
    contacts_at_sort_ = contacts();
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::begin_epoch() {
    if constexpr (Layered) {
        double mean = 0.0;
        for (const Particle& p : particles_) mean += p.velocity_z;
        mean /= static_cast<double>(particles_.size());
        frame_.start = now_;
        frame_.initial_velocity = mean;
        for (Particle& p : particles_) p.velocity_z -= mean;
        const double top = 0.5 * period_;
        highest_plate_ = now_ <= top && top <= epoch_end()
                             ? 2.0 * box_.plate->amplitude
                             : std::max(box_.plate->position(now_), box_.plate->position(epoch_end()));
    }
    if constexpr (Layered) {
        watch_.begin_epoch(1.0);
    } else {
        double square = 0.0;
        for (const Particle& p : particles_)
            square += p.velocity_x * p.velocity_x + p.velocity_y * p.velocity_y + p.velocity_z * p.velocity_z;
        watch_.begin_epoch(std::sqrt(square / (3.0 * static_cast<double>(particles_.size()))));
    }
    const std::int64_t events =
        counters_.pair_collisions + counters_.plate_collisions + counters_.ceiling_collisions + counters_.other_events;
    const double expected =
        std::max(static_cast<double>(events - events_at_epoch_start_), 0.1 * static_cast<double>(particles_.size()));
    events_at_epoch_start_ = events;
    queue_.reset(now_, epoch_end(), expected);
    for (std::uint32_t i = 0; i < particles_.size(); ++i) predict(i);
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::start_next_epoch() {
    now_ = epoch_end();
    for (Particle& p : particles_) p.move_to(now_);
    if constexpr (Layered) {
        const double shift = frame_.displacement(now_), gained = frame_.velocity(now_);
        for (Particle& p : particles_) {
            p.z += shift;
            p.velocity_z += gained;
        }
        neighbours_.shift_heights(shift);
    }
    sums_ += epoch_sums_;
    epoch_sums_ = {};
    if (++epoch_ == epochs_) {
        epoch_ = 0;
        ++cycle_;
        now_ = 0.0;
        watch_.rebase(period_);
        for (Particle& p : particles_) p.time = 0.0;
        for (double& time : last_contacts_) time -= period_;
    }
    if (epoch_ % fewest_epochs == 0) {
        if (static_cast<double>(contacts() - contacts_at_sort_) >=
            contacts_between_sorts_ * static_cast<double>(particles_.size()))
            sort_in_space();
    }
    begin_epoch();
}

template <class Law, bool Layered>
template <class Done>
void EventLoop<Law, Layered>::run(double until, const Done& done) {
    while (!done()) {
        const QueuedEvent event = queue_.front();
        if (!(event.time <= until)) return;
        now_ = event.time;
        process(event.owner);
    }
}

template <class Law, bool Layered>
bool EventLoop<Law, Layered>::advance_to(std::int64_t cycle, double time_in_cycle, std::int64_t most_predictions) {
    const std::int64_t last = most_predictions < std::numeric_limits<std::int64_t>::max() - predictions_
                                  ? predictions_ + most_predictions
                                  : std::numeric_limits<std::int64_t>::max();
    const auto short_of_it = [&] { return predictions_ >= last; };
    while (cycle_ < cycle || (cycle_ == cycle && epoch_end() < time_in_cycle && epoch_ + 1 < epochs_)) {
        run(epoch_end(), short_of_it);
        if (short_of_it()) return false;
        start_next_epoch();
    }
    if (cycle_ > cycle || time_in_cycle <= now_) return true;
    const double until = std::min(time_in_cycle, epoch_end());
    run(until, short_of_it);
    if (short_of_it()) return false;
    now_ = until;
    return true;
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::advance_collisions(std::int64_t pair_collisions) {
    const std::int64_t last = counters_.pair_collisions + pair_collisions;
    const auto all_done = [&] { return counters_.pair_collisions >= last; };
    while (true) {
        run(epoch_end(), all_done);
        if (all_done()) return;
        start_next_epoch();
    }
}

template <class Law, bool Layered>
ContactEvent EventLoop<Law, Layered>::advance_contact() {
    const std::int64_t before = contacts();
    while (contacts() == before) {
        const QueuedEvent event = queue_.front();
        if (event.time <= epoch_end()) {
            now_ = event.time;
            process(event.owner);
        } else {
            start_next_epoch();
        }
    }
    const bool pair = last_kind_ == ContactEvent::Kind::pair;
    return {last_kind_, particles_[last_first_].id, pair ? std::int64_t{particles_[last_second_].id} : -1, cycle_,
            now_};
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::predict(std::uint32_t i) {
    ++predictions_;
    const Particle& p = particles_[i];
    const NeighbourLists::Centre& centre = neighbours_.centre(i);
    const Contact contact = nearest_contact(p, now_, neighbours_.of(i), particles_.data(), neighbours_.x(),
                                            neighbours_.y(), neighbours_.z(), neighbours_.inside(centre));
    double delay = contact.delay;
    std::uint32_t partner = contact.partner;

    const double dx = p.x - static_cast<double>(centre.x), dy = p.y - static_cast<double>(centre.y);
    const double dz = p.z - neighbours_.shift() - static_cast<double>(centre.z);
    const double r_dot_v = dx * p.velocity_x + dy * p.velocity_y + dz * p.velocity_z;
    const double r_squared = dx * dx + dy * dy + dz * dz;
    const double v_squared = p.velocity_x * p.velocity_x + p.velocity_y * p.velocity_y + p.velocity_z * p.velocity_z;
    const double free = static_cast<double>(centre.half_shell) * static_cast<double>(centre.half_shell);
    // Still inside when the contact comes? Then no root is needed.
    if (delay == never || r_squared + delay * (2.0 * r_dot_v + delay * v_squared) > free) {
        const double leaving = time_to_leave(r_dot_v, r_squared, v_squared, free);
        if (leaving < delay) {
            delay = leaving;
            partner = leaves_centre;
        }
    }
    if constexpr (Layered) {
        const double height = p.z + frame_.displacement(now_), velocity = p.velocity_z + frame_.velocity(now_);
        const double flight = std::min(delay, epoch_end() - now_);
        const double lowest = std::min(height, height + flight * (velocity - 0.5 * flight)) - 0.5;
        if (lowest <= highest_plate_) {
            const double meeting = plate_contact_time(*box_.plate, height - 0.5, velocity, now_, now_ + flight);
            if (meeting != never) {
                delay = meeting - now_;
                partner = meets_plate;
            }
        }
        if (velocity > 0.0 && height + 0.5 * velocity * velocity > box_.z - 0.5) {
            const double meeting = time_to_ceiling(box_.z - 0.5 - height, velocity);
            if (meeting < delay) {
                delay = meeting;
                partner = meets_ceiling;
            }
        }
    }
    queue_.schedule(i, now_ + delay, {partner, partner < meets_ceiling ? particles_[partner].stamp : 0});
}

template <class Law, bool Layered>
void EventLoop<Law, Layered>::process(std::uint32_t i) {
    const EventSubject prediction = queue_.subject(i);
    switch (prediction.partner) {
        case meets_plate:
            return collide_with_plate(i);
        case meets_ceiling:
            return collide_with_ceiling(i);
        case leaves_centre:
            ++counters_.other_events;
            particles_[i].move_to(now_);
            neighbours_.rebuild(i, particles_[i]);
            return predict(i);
        default:
            break;
    }
    if (particles_[prediction.partner].stamp == prediction.stamp) return collide(i, prediction.partner);
    ++counters_.other_events;
    particles_[i].move_to(now_);
    predict(i);
}

}  // namespace shaken::md

#include "md/event_loop_contacts.hpp"
#include "md/event_loop_state.hpp"
