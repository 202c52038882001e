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

#include "continuum/kernels.hpp"
#include "continuum/method.hpp"
#include "continuum/setup.hpp"
#include "continuum/solver.hpp"

namespace shaken::continuum {

/// Scratch of one thread: rows as long as a column.
struct Workspace {
    explicit Workspace(std::int64_t cells);
    double* row(std::size_t i) { return rows_.data() + i * static_cast<std::size_t>(length_); }
    /// Rows 8 set to 8 set + 7.
    FaceArrays faces(std::size_t set) {
        const std::size_t r = 8 * set;
        return {row(r), row(r + 1), row(r + 2), row(r + 3), row(r + 4), row(r + 5), row(r + 6), row(r + 7)};
    }

  private:
    std::int64_t length_;
    std::vector<double> rows_;
};

enum class Direction { x, y, z };

class Evolution : public Method {
  public:
    static constexpr int carries_a_step = 2;

    /// Throws scene::SceneError for unknown names.
    explicit Evolution(Setup setup);

    /// Two carries as long as the waves allow now, times cfl.
    double longest_step() override;
    /// One step from local time t; throws RunFailed, with the state as it was, if it cannot be made.
    void step(double t, double dt) override;

    const Grid& grid() const override { return setup_.grid; }
    const Flow& flow() const override { return setup_.flow; }
    double bytes_per_cell() const;
    Flow& flow() { return setup_.flow; }
    double mass() const override;  // per horizontal area
    double mass_share_at_temperature_floor() const override;
    double floor_temperature() const override { return constants_.floor_temperature; }
    Ledger ledger() const override;
    /// Mass is kept; energy is made only where the internal energy is trusted over the total, or a cell's heat is kept
    /// from falling by more than half.
    Drift drift() const override;
    std::int64_t steps() const override { return steps_; }
    std::int64_t repeated_steps() const { return repeated_; }
    std::int64_t relaxations() const {
        return relaxations_;
    }  // one a step, more where diffusion across columns is fast

    void save(files::CheckpointWriter& out) const override;
    void restore(const files::CheckpointReader& in) override;

  private:
    struct Sweeps {
        SweepKernel vertical, horizontal, thin;
    };
    bool try_step(double t, double dt, const Sweeps& sweeps);

    // carry.cpp and carry_horizontal.cpp; the horizontal sweeps share their work among the threads that call them.
    bool carry(double t, double dt, const Sweeps& sweeps);
    std::int64_t rows_with_gas() const;
    void sweep_along_x(const Sweeps& sweeps, std::int64_t rows, Workspace& work);
    void sweep_along_y(const Sweeps& sweeps, std::int64_t rows, bool first_sweep, Workspace& work);
    void sweep_along_z(std::int64_t column, SweepKernel sweep, bool first_sweep, double gravity, Workspace& work);
    void sweep_row(Direction direction, std::int64_t row, std::int64_t from, std::int64_t to, const Sweeps& sweeps,
                   std::int64_t rows, bool first_sweep, Workspace& work);
    double stress_below_wall(const Stencil& stencil, std::int64_t face) const;
    void add_rates(std::int64_t column, const FaceArrays& lower, const FaceArrays& upper, Direction direction,
                   double spacing, bool first_sweep);
    bool update(std::int64_t column, const Stage& stage, bool first_stage, double gravity, double dt);

    // relax.cpp and relax_horizontal.cpp
    void relax(double dt);
    TransportArrays coefficients(std::int64_t column);
    void cool(std::int64_t column, double dt);
    void cool_and_diffuse(std::int64_t column, double dt, bool cools, Workspace& work);
    void cool_and_diffuse_once(std::int64_t column, double dt, bool cools, Workspace& work);
    void relax_columns(double dt, bool cools);
    void relax_horizontally(double dt);
    int pieces_of_relaxation(double dt);
    double share_of_face() const;
    double narrowest_square() const;
    void horizontal_stresses(std::int64_t column, double dt, Workspace& work);
    void apply_horizontal_stresses(std::int64_t column, double dt);

    int threads() const;
    static std::size_t thread();
    void copy_column(const Flow& from, Flow& to, std::int64_t column) const;
    double total_energy() const;
    double potential_energy() const;
    [[noreturn]] void fail(double t, double dt) const;

    Setup setup_;
    Kernels kernels_;
    Constants constants_;
    EffectiveDissipation dissipation_;
    Flow base_;   // state at the start of the Runge-Kutta stages
    Flow start_;  // state at the start of the step, to take it back
    // Rates of change by the fluxes, and the largest squared jump of velocity around each cell; (ny, nx, stride) each.
    struct Rates {
        std::vector<double> mass, momentum_x, momentum_y, momentum_z, energy, internal, jump, pressure;
    } rates_;
    struct Coefficients {
        std::vector<double> bulk, shear, conductivity, density_conductivity, cooling;
    } coefficients_;                     // at T = 1
    std::vector<double> thermal_speed_;  // sqrt(T), for the horizontal stresses
    std::vector<Workspace> work_;
    std::vector<Ledger> books_, base_books_, start_books_;  // one a column, so that sums do not depend on threads
    double initial_energy_ = 0.0, initial_potential_energy_ = 0.0;
    std::int64_t steps_ = 0;
    std::int64_t repeated_ = 0;
    std::int64_t relaxations_ = 0;
    bool moves_along_x_ = false, moves_along_y_ = false;  // whether u_x, u_y can differ from 0
};

}  // namespace shaken::continuum
