// SPDX-License-Identifier: MIT
// What the solver asks of a method that advances a flow; called once a step, never inside a loop over cells.
#pragma once

#include <cstdint>
#include <memory>

#include "continuum/flow.hpp"
#include "continuum/setup.hpp"
#include "continuum/step/ledger.hpp"
#include "files/checkpoint.hpp"

namespace shaken::continuum {

/// What a method makes by itself (negative: loses), as shares: of the mass at the start; of the energy at the start and
/// what collisions have taken since.
struct Drift {
    double mass = 0.0, energy = 0.0;
};

class Method {
  public:
    Method() = default;
    Method(const Method&) = default;
    Method(Method&&) = default;
    Method& operator=(const Method&) = default;
    Method& operator=(Method&&) = default;
    virtual ~Method() = default;

    /// The longest step that the state allows now.
    virtual double longest_step() = 0;
    /// One step from local time t; throws RunFailed where it cannot be made.
    virtual void step(double t, double dt) = 0;

    virtual const Grid& grid() const = 0;
    virtual const Flow& flow() const = 0;  // means over the cells
    virtual double mass() const = 0;       // per horizontal area
    virtual double mass_share_at_temperature_floor() const = 0;
    virtual double floor_temperature() const = 0;
    virtual Ledger ledger() const = 0;
    virtual Drift drift() const { return {}; }
    /// Share of the mass where a step of dt is longer than linear stability allows; 0 for a method that sees to it
    /// itself.
    virtual double unstable_share(double /*dt*/) const { return 0.0; }
    virtual std::int64_t steps() const = 0;

    virtual void save(files::CheckpointWriter& out) const = 0;
    virtual void restore(const files::CheckpointReader& in) = 0;
};

/// The five fields of a state in a checkpoint, whatever the method: /continuum/density, ...
void save_flow(const Flow& flow, files::CheckpointWriter& out);
/// Throws files::Damaged where they are not there or of another size.
void restore_flow(Flow& flow, const files::CheckpointReader& in);

/// The method that the setup's scheme names: Ftcs for "ftcs", Evolution for the finite-volume schemes. Throws
/// scene::SceneError for unknown names.
std::unique_ptr<Method> make_method(Setup setup);

}  // namespace shaken::continuum
