// SPDX-License-Identifier: MIT
// What a Simulation holds: one event loop, compiled for one restitution law and one kind of walls.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "files/checkpoint.hpp"
#include "md/audit.hpp"
#include "md/contact_law.hpp"
#include "md/simulation.hpp"
#include "md/snapshot.hpp"
#include "scene/restitution.hpp"

namespace shaken::md {

class Engine {
  public:
    virtual ~Engine() = default;
    virtual bool advance_to(std::int64_t cycle, double time_in_cycle, std::int64_t most_predictions) = 0;
    virtual void advance_collisions(std::int64_t pair_collisions) = 0;
    virtual ContactEvent advance_contact() = 0;
    virtual std::int64_t cycle() const = 0;
    virtual double time_in_cycle() const = 0;
    virtual double period() const = 0;
    virtual std::int64_t particles() const = 0;
    virtual Snapshot snapshot() const = 0;
    virtual Ledger ledger() const = 0;
    virtual Counters counters() const = 0;
    virtual const Box& box() const = 0;
    virtual std::int64_t memory() const = 0;
    virtual void save(files::CheckpointWriter& out) const = 0;
    virtual void restore(const files::CheckpointReader& in) = 0;
};

/// What an event loop starts from.
struct Setup {
    Box box;
    double period = 1.0;  // of the clock: the plate's, or a uniform system's
    scene::Restitution restitution;
    std::optional<WaltonFriction> friction;
    ElasticContacts elastic;
    Snapshot start;
    Options options;
};

std::unique_ptr<Engine> make_engine(const Setup& setup);

/// The two halves of the table of event loops, compiled apart.
std::unique_ptr<Engine> make_smooth_engine(const Setup& setup);
std::unique_ptr<Engine> make_frictional_engine(const Setup& setup);

}  // namespace shaken::md
