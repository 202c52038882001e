// SPDX-License-Identifier: MIT
// Cooling, viscosity and conduction over a whole step: along the columns implicit, across them explicit, half before
// and half after, in as many equal pieces as the explicit part asks for.
#pragma once

#include <cstdint>

#include "continuum/step/coefficients.hpp"
#include "continuum/step/fluid.hpp"
#include "continuum/step/relax_column.hpp"
#include "continuum/step/relax_horizontal.hpp"

namespace shaken::continuum {

class Relax {
  public:
    /// The fluid must outlive it.
    explicit Relax(Fluid& fluid);
    Relax(const Relax&) = delete;
    Relax& operator=(const Relax&) = delete;

    void operator()(double dt);

    /// Pieces so far: one a step, more where diffusion across columns is fast.
    std::int64_t pieces() const { return pieces_; }
    /// Doubles that it keeps beside the fluid's, without scratch.
    std::size_t doubles() const;

  private:
    void take_coefficients();
    void relax_columns(double dt, bool cools);

    Fluid& fluid_;
    Coefficients coefficients_;
    RelaxColumn column_;
    RelaxHorizontal horizontal_;
    std::vector<Row> ones_;  // the temperature that coefficients are taken at, a row a thread
    std::int64_t pieces_ = 0;
};

}  // namespace shaken::continuum
