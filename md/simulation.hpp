// SPDX-License-Identifier: MIT
// Event-driven molecular dynamics of inelastic hard spheres, smooth or frictional: between collisions every particle
// flies on its exact path, and the next collision of the whole system is found, never stepped over. Box periodic in x
// and y, oscillating plate below, fixed ceiling above, gravity 1; or periodic in three directions.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "files/checkpoint.hpp"
#include "md/audit.hpp"
#include "md/snapshot.hpp"
#include "md/uniform_system.hpp"
#include "scene/scene.hpp"

namespace shaken::md {

class Engine;

/// Knobs of the method, not of the physics: they change the speed and the round-off, never the statistics.
struct Options {
    double shell = 0.0;                   // reach of a neighbour list beyond contact, sigma; 0: chosen from the density
    int frames_per_cycle = 0;             // how often the frame is made to follow the layer; 0: the default
    double contacts_between_sorts = 0.0;  // particles are reordered in space after so many of each; 0: the default
};

/// One run. Movable, not copyable. The trajectory is a function of the scene, the seed and the options alone: not of
/// how often advance_to is called, nor of checkpoints in between.
class Simulation {
  public:
    /// A random flat layer, or a uniform gas, from initial.seed and md.seed, or the state in initial.file where one
    /// is named (md/initial_file.hpp). A cycle of a uniform gas is its sampling interval.
    /// Throws CannotSetUp when the particles do not fit or overlap, files::NoInput or Damaged for the file.
    explicit Simulation(const scene::Scene& scene, const Options& options = {});
    explicit Simulation(const UniformSystem& system, const Options& options = {});
    /// From given lab-frame positions, velocities and spins at their time within cycle 0, in place of the random start.
    /// Throws CannotSetUp when particles overlap each other, the plate or the ceiling.
    Simulation(const scene::Scene& scene, const Snapshot& start, const Options& options = {});
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Processes every event up to and including this instant. Does nothing when the instant is past already. False
    /// where it stopped short, after so many predictions of a particle's next event, the unit of the engine's work:
    /// they go on where nothing meets. Called again it goes on as if it had not stopped. Throws Stalled on inelastic
    /// collapse, InvariantBroken when a promise fails.
    bool advance_to(std::int64_t cycle, double time_in_cycle,
                    std::int64_t most_predictions = std::numeric_limits<std::int64_t>::max());
    /// Processes exactly this many pair collisions.
    void advance_collisions(std::int64_t pair_collisions);
    /// Goes on to just after the next contact, of a pair or with a wall, and says which.
    ContactEvent advance_contact();

    std::int64_t cycle() const;
    double time_in_cycle() const;
    double plate_period() const;
    std::int64_t particles() const;

    Snapshot snapshot() const;
    Ledger ledger() const;
    Counters counters() const;
    /// All pairs through cells at this instant: largest overlap, particles beyond the walls.
    Audit audit() const;
    /// Bytes of the engine's own arrays, for all particles together.
    std::int64_t memory() const;

    /// The whole state; restore() into a Simulation of the same scene and options continues with the same bits.
    void save(files::CheckpointWriter& out) const;
    /// Throws files::Damaged if the checkpoint is of another system.
    void restore(const files::CheckpointReader& in);
    /// Equal states have equal hashes.
    std::uint64_t state_hash() const;

  private:
    std::unique_ptr<Engine> engine_;
};

}  // namespace shaken::md
