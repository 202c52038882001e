// SPDX-License-Identifier: MIT
// Advances a flow by whole steps. A step is, in turn, and in the opposite order every other time (which makes the
// splitting second order over two steps):
//     cool      dT/dt = -(8/sqrt(pi)) G D T^(3/2), exactly, cell by cell
//     diffuse   viscosity and conduction, implicit along each column; the kinetic energy it takes becomes heat
//     carry     mass, momentum and energy by waves and by the body force, explicit
// A step that would leave a cell empty, packed or without a number is taken back and repeated in halves, at last with
// first-order fluxes; if that does not help the run has failed.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/kernels.hpp"
#include "continuum/setup.hpp"
#include "continuum/solver.hpp"

namespace continuum {

/// Scratch of one thread: rows as long as a column.
struct Workspace {
    explicit Workspace(std::int64_t cells);
    double* row(std::size_t i) { return rows_.data() + i * static_cast<std::size_t>(length_); }

  private:
    std::int64_t length_;
    std::vector<double> rows_;
};

class Evolution {
  public:
    /// Throws scene::SceneError for unknown names.
    explicit Evolution(Setup setup);

    /// The longest step that the waves allow now, times cfl.
    double longest_step();
    /// One step from local time t; throws RunFailed, with the state as it was, if it cannot be made.
    void step(double t, double dt);

    const Grid& grid() const { return setup_.grid; }
    const Flow& flow() const { return setup_.flow; }
    Flow& flow() { return setup_.flow; }
    double mass() const;  // per horizontal area
    Ledger ledger() const;
    std::int64_t steps() const { return steps_; }
    std::int64_t repeated_steps() const { return repeated_; }

    void save(files::CheckpointWriter& out) const;
    void restore(const files::CheckpointReader& in);

  private:
    bool try_step(double t, double dt, SweepKernel sweep);
    void relax(double dt, bool cooling_first);
    bool carry(double t, double dt, SweepKernel sweep);

    void cool(std::int64_t column, double dt, Workspace& work);
    void diffuse(std::int64_t column, double dt, Workspace& work);
    void sweep_along_z(std::int64_t column, SweepKernel sweep, Workspace& work);
    bool update(std::int64_t column, const Stage& stage, double gravity, double dt);
    double total_energy() const;
    [[noreturn]] void fail(double t, double dt) const;

    Setup setup_;
    Kernels kernels_;
    Constants constants_;
    EffectiveDissipation dissipation_;
    Flow base_;   // state at the start of the Runge-Kutta stages
    Flow start_;  // state at the start of the step, to take it back
    // Rates of change by the fluxes, and the largest squared jump of velocity around each cell; (ny, nx, stride) each.
    struct Rates {
        std::vector<double> mass, momentum_x, momentum_y, momentum_z, energy, internal, jump;
    } rates_;
    std::vector<Workspace> work_;
    std::vector<Ledger> books_, base_books_, start_books_;  // one a column, so that sums do not depend on threads
    double initial_energy_ = 0.0;
    std::int64_t steps_ = 0;
    std::int64_t repeated_ = 0;
    bool transverse_ = false;  // whether u_x or u_y can differ from 0
};

}  // namespace continuum
