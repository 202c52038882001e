// SPDX-License-Identifier: MIT
// The implicit and the exact part of a step, in one column: diffusion along z, cooling in the cells. They are one
// operator: where conduction crosses a cell in less than a step, cooling by itself and conduction by itself would leave
// a heated wall an error of first order in dt.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "continuum/step/coefficients.hpp"
#include "continuum/step/diffusion_solve.hpp"
#include "continuum/step/fluid.hpp"
#include "continuum/step/row.hpp"

namespace shaken::continuum {

class RelaxColumn {
  public:
    /// Fluid and coefficients must outlive it.
    RelaxColumn(Fluid& fluid, Coefficients& coefficients);

    /// Cooling alone, exact for a constant restitution, otherwise second order in dt.
    void cool(std::int64_t column, double dt);
    /// All of it, second order in dt; with `cools` false without the sink.
    void cool_and_diffuse(std::int64_t column, double dt, bool cools);

  private:
    /// What diffuses: temperature, u_z, and u_x and u_y where they can differ from 0.
    struct FieldRows {
        explicit FieldRows(std::int64_t cells) : rows{Row(cells), Row(cells), Row(cells), Row(cells)} {}
        std::array<Row, 4> rows;
        double* operator[](std::size_t field) { return rows[field]; }
    };
    struct Scratch {
        explicit Scratch(std::int64_t cells)
            : lost(cells),
              floored(cells),
              axial(cells),
              shear(cells),
              conduction(cells),
              coupling(cells),
              up(cells),
              down(cells),
              values(cells),
              values_y(cells),
              heat(cells),
              heat_of_shear(cells),
              ratio(cells),
              of_first(cells),
              of_last(cells),
              start(cells),
              whole(cells) {}
        Row lost, floored;             // n times the change of T by cooling, and by its floor
        Row axial, shear, conduction;  // dt coefficient / (2 dz^2) of the cells
        Row coupling, up, down;        // of the faces
        Row values, values_y;          // right sides and solutions
        Row heat, heat_of_shear;       // that motion becomes
        Row ratio, of_first, of_last;  // of the solver
        FieldRows start, whole;        // before the step, and after it in one piece
    };

    void cool_and_diffuse_once(std::int64_t column, double dt, bool cools);
    void diffuse_velocities(std::int64_t column);
    void diffuse_temperature(std::int64_t column, double scale);
    void add_heat_of_density(std::int64_t column, double scale);
    void couple(const double* coefficient, bool lower_wall, bool upper_wall);
    void solve(const double* capacity, const Couplings& couplings);
    void take_over(const double* density, double* velocity, const double* diffused, double* into);
    bool is_ring() const { return fluid_.setup.boundaries.lower.end == End::periodic; }
    Scratch& scratch() { return scratch_[thread()]; }

    Fluid& fluid_;
    Coefficients& coefficients_;
    std::vector<Scratch> scratch_;
};

}  // namespace shaken::continuum
