// SPDX-License-Identifier: MIT
// Advances a flow by whole steps. A step reads the same in either direction, which makes it second order and a steady
// state one number:
//     carry     over half the step: mass, momentum and energy by waves and by the body force, explicit
//     relax     over the whole step: cooling dT/dt = -(8/sqrt(pi)) G D T^(3/2), viscosity and conduction, together
//               along each column, implicit (second order in dt); the kinetic energy that viscosity takes becomes heat;
//               viscosity and conduction across columns, and what mixes directions, half before and half after,
//               explicit (first order); in as many pieces as that asks for
//     carry     over the other half
// A step that would leave a cell empty, packed or without a number is taken back and repeated in halves, at last with
// first-order fluxes; if that does not help the run has failed.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/method.hpp"
#include "continuum/setup.hpp"
#include "continuum/step/carry.hpp"
#include "continuum/step/fluid.hpp"
#include "continuum/step/relax.hpp"

namespace shaken::continuum {

class Evolution : public Method {
  public:
    static constexpr int carries_a_step = 2;

    /// Throws scene::SceneError for unknown names.
    explicit Evolution(Setup setup);
    Evolution(const Evolution&) = delete;
    Evolution& operator=(const Evolution&) = delete;

    /// Two carries as long as the waves allow now, times cfl.
    double longest_step() override;
    /// One step from local time t; throws RunFailed, with the state as it was, if it cannot be made.
    void step(double t, double dt) override;

    const Grid& grid() const override { return fluid_.grid(); }
    const Flow& flow() const override { return fluid_.flow(); }
    double bytes_per_cell() const;
    Flow& flow() { return fluid_.flow(); }
    double mass() const override;  // per horizontal area
    double mass_share_at_temperature_floor() const override;
    double floor_temperature() const override { return fluid_.constants.floor_temperature; }
    Ledger ledger() const override;
    /// Mass is kept; energy is made only where the internal energy is trusted over the total, or a cell's heat is kept
    /// from falling by more than half.
    Drift drift() const override;
    std::int64_t steps() const override { return steps_; }
    std::int64_t repeated_steps() const { return repeated_; }
    std::int64_t relaxations() const { return relax_.pieces(); }

    void save(files::CheckpointWriter& out) const override;
    void restore(const files::CheckpointReader& in) override;

  private:
    struct Scratch {
        explicit Scratch(std::int64_t cells) : pressure(cells), sound_speed(cells), rate(cells) {}
        Row pressure, sound_speed;  // from one ghost below the column on
        Row rate;                   // of waves along z past a face
    };

    bool try_step(double t, double dt, const Carry::Sweeps& sweeps);
    double total_energy() const;
    double potential_energy() const;
    [[noreturn]] void fail(double t, double dt) const;

    Fluid fluid_;
    Carry carry_;
    Relax relax_;
    Flow start_;  // state at the start of the step, to take it back
    Books start_books_;
    std::vector<Scratch> scratch_;
    double initial_energy_ = 0.0, initial_potential_energy_ = 0.0;
    std::int64_t steps_ = 0;
    std::int64_t repeated_ = 0;
};

}  // namespace shaken::continuum
