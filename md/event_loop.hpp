// SPDX-License-Identifier: MIT
// The loop: next event, move, collide, predict anew. Each particle keeps one predicted event, its earliest; when a
// partner has changed its mind meanwhile (its stamp differs), the event is found stale and only then replaced.
// A cycle is cut into epochs. At the start of each, all particles are brought to one time, the frame takes over the
// layer's mean velocity, and every event is predicted anew; at the start of a cycle the clock goes back to zero.
#pragma once

#include <cstdint>
#include <vector>

#include "md/collapse_watch.hpp"
#include "md/collision_law.hpp"
#include "md/engine.hpp"
#include "md/event_queue.hpp"
#include "md/moving_frame.hpp"
#include "md/neighbour_lists.hpp"
#include "md/paged_vector.hpp"
#include "md/particle.hpp"

namespace shaken::md {

/// Law: what a contact does (md/contact_law.hpp). Layered: true with gravity, plate and ceiling; false in a box
/// periodic in z.
template <class Law, bool Layered>
class EventLoop final : public Engine {
  public:
    EventLoop(const Setup& setup, const Law& law);

    bool advance_to(std::int64_t cycle, double time_in_cycle, std::int64_t most_predictions) override;
    void advance_collisions(std::int64_t pair_collisions) override;
    ContactEvent advance_contact() override;
    std::int64_t cycle() const override { return cycle_; }
    double time_in_cycle() const override { return now_; }
    double period() const override { return period_; }
    std::int64_t particles() const override { return static_cast<std::int64_t>(particles_.size()); }
    Snapshot snapshot() const override;
    Ledger ledger() const override;
    Counters counters() const override { return counters_; }
    const Box& box() const override { return box_; }
    std::int64_t memory() const override;
    void save(files::CheckpointWriter& out) const override;
    void restore(const files::CheckpointReader& in) override;

  private:
    // What a particle's event is about; a partner below these is another particle.
    static constexpr std::uint32_t leaves_centre = 0xffffffffu, meets_plate = 0xfffffffeu, meets_ceiling = 0xfffffffdu;

    /// Events up to and including this instant, or until done() says so.
    template <class Done>
    void run(double until, const Done& done);
    void process(std::uint32_t i);
    void predict(std::uint32_t i);
    void collide(std::uint32_t i, std::uint32_t j);
    void collide_with_plate(std::uint32_t i);
    void collide_with_ceiling(std::uint32_t i);
    void begin_epoch();
    void start_next_epoch();
    void sort_in_space();
    double epoch_end() const { return period_ * (epoch_ + 1) / epochs_; }
    void note_contact(ContactEvent::Kind kind, std::uint32_t i, std::uint32_t j);
    /// Time since the latest contact of either before this one, and that they have one now; 0 where nobody asks.
    double since_last_contact(std::uint32_t i, std::uint32_t j);
    Vector3 spin(std::uint32_t i) const { return spins_.empty() ? Vector3{} : spins_[particles_[i].id]; }
    void rub_walls(std::uint32_t i, double normal_velocity, double e, double side, double& loss);
    std::int64_t contacts() const {
        return counters_.pair_collisions + counters_.plate_collisions + counters_.ceiling_collisions;
    }

    Box box_;
    double period_;
    Law law_;
    int epochs_;                     // a cycle
    double contacts_between_sorts_;  // of each particle
    MovingFrame frame_;
    std::int64_t cycle_ = 0;
    int epoch_ = 0;
    double now_ = 0.0;
    double highest_plate_ = 0.0;  // during this epoch
    PagedVector<Particle> particles_;
    // By particle number, where the law asks for them, else empty.
    std::vector<Vector3> spins_;
    std::vector<double> last_contacts_;  // within this cycle, or negative
    NeighbourLists neighbours_;
    EventQueue queue_;
    Counters counters_;
    Ledger sums_;        // exchanges up to the start of this epoch
    Ledger epoch_sums_;  // exchanges in this epoch: summed apart, so that round-off does not grow with the run
    ContactEvent::Kind last_kind_ = ContactEvent::Kind::pair;
    std::uint32_t last_first_ = 0, last_second_ = 0;
    std::int64_t contacts_at_sort_ = 0;
    std::int64_t predictions_ = 0;  // since this object was made; no part of the state
    std::int64_t events_at_epoch_start_ = 0;
    CollapseWatch watch_;
};

}  // namespace shaken::md

#include "md/event_loop_impl.hpp"
