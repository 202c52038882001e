// SPDX-License-Identifier: MIT
// The explicit part of a step: mass, momentum and energy by waves and by the body force, in the stages of a Runge-Kutta
// table. carry.cpp has the stages and the sweep along z, carry_horizontal.cpp the sweeps along x and y.
#pragma once

#include <cstdint>
#include <vector>

#include "continuum/step/fluid.hpp"
#include "continuum/step/row.hpp"

namespace shaken::continuum {

enum class Direction { x, y, z };

class Carry {
  public:
    /// The loops that make the fluxes; `thin` in rows that hold next to nothing.
    struct Sweeps {
        SweepKernel vertical, horizontal, thin;
    };

    /// The fluid must outlive it.
    explicit Carry(Fluid& fluid);

    /// Over dt from local time t. False where it would leave a cell empty, packed or without a number: the state is
    /// then to be taken back.
    bool operator()(double t, double dt, const Sweeps& sweeps);

    /// Doubles that it keeps beside the fluid's, without scratch.
    std::size_t doubles() const;

  private:
    struct Scratch {
        explicit Scratch(std::int64_t cells)
            : faces(cells), faces_above(cells), sound_speed(cells), passing(cells), corrected(cells), floored(cells) {}
        FaceRows faces, faces_above;  // below a column, and between it and the next
        Row sound_speed;              // which the pressure's kernel gives beside it
        Row passing;                  // mass that passes a cell
        Row corrected, floored;       // energy
    };

    // The horizontal sweeps share their work among the threads that call them.
    std::int64_t rows_with_gas() const;
    void sweep_along_x(const Sweeps& sweeps, std::int64_t rows);
    void sweep_along_y(const Sweeps& sweeps, std::int64_t rows, bool first_sweep);
    void sweep_along_z(std::int64_t column, SweepKernel sweep, bool first_sweep, double gravity);
    void sweep_row(Direction direction, std::int64_t row, std::int64_t from, std::int64_t to, const Sweeps& sweeps,
                   std::int64_t rows, bool first_sweep);
    double stress_below_wall(const Stencil& stencil, std::int64_t face) const;
    void add_rates(std::int64_t column, const FaceArrays& lower, const FaceArrays& upper, Direction direction,
                   double spacing, bool first_sweep);
    bool update(std::int64_t column, const Stage& stage, bool first_stage, double gravity, double dt);
    void keep_books(std::int64_t column, const Stage& stage, double gravity, double dt);

    Fluid& fluid_;
    Flow base_;  // state at the start of the stages
    Books base_books_;
    std::vector<Scratch> scratch_;
};

}  // namespace shaken::continuum
