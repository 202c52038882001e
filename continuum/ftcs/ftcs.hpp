// SPDX-License-Identifier: MIT
// The source's own method (Bougie 2004, sections 3.2.4 to 3.2.9), as the baseline that the others are held against:
// forward Euler in time and second-order centred differences of the equations in n, u and T as they stand: that of n
// is a divergence (3.1), those of u and T are not. Mass and energy are therefore kept to truncation error only, and the
// run says how badly.
//     nodes    0    1    2         N    the walls are nodes: u_z = 0 there, and u_x, u_y and T as the one-sided
//              |----|----| ... ----|    derivative of zero makes them; only n evolves, with a one-sided d u_z/dz
//     cells      0    1        N-1      flow() gives the means of two nodes
// The closure is jenkins_richman_dense, without the terms in 1/G, and artificial dissipation takes their place where
// the gas is thin: with them an explicit step is bounded by n/mu, which the vacuum takes to zero. The source names no
// floor; those of [continuum] hold here, n at least at 1e-3 of its mean, and floor_mass() says what they added. A flat
// layer starts with an exponential top: a jump to vacuum in one cell ends the run in the first steps, since grad p / n
// has no bound there.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "continuum/closures/effective_dissipation.hpp"
#include "continuum/kernels.hpp"
#include "continuum/method.hpp"

namespace shaken::continuum {

class Ftcs : public Method {
  public:
    static constexpr std::string_view name = "ftcs";
    /// Of the mean. With a tenth of it a node above the layer of chapter 4 empties in the second cycle
    /// (docs/numerics.md).
    static constexpr double least_floor_density = 1e-3;

    /// Throws scene::SceneError, at the closure's place or else the scheme's, for a closure with terms in 1/G that has
    /// a part in this gas.
    static void refuse_closure(const scene::Continuum& choices, double restitution);

    /// Throws scene::SceneError for unknown names, for closures with terms in 1/G, and for ends other than walls.
    explicit Ftcs(Setup setup);

    /// Equation 3.21 and what follows it: the least over all nodes of 1.5 h/|u_i|, s n h^2/(mu, lambda, kappa) and
    /// 0.3/(D G sqrt(T)), h the smallest spacing and s the diffusion factor, 0.16. cfl has no part in it.
    double longest_step() override;
    void step(double t, double dt) override;

    const Grid& grid() const override { return setup_.grid; }
    const Flow& flow() const override;
    double mass() const override;
    double floor_mass() const { return floor_mass_; }  // per area, added where n met its floor
    double mass_share_at_temperature_floor() const override;
    double floor_temperature() const override { return setup_.floor_temperature; }
    /// dual_energy_gain is what the differences make or lose: the balance of all other entries.
    Ledger ledger() const override;
    Drift drift() const override;
    /// By von Neumann's conditions for gas at rest, which its own rules for the step do not know; after longest_step().
    double unstable_share(double dt) const override;
    std::int64_t steps() const override { return steps_; }

    void save(files::CheckpointWriter& out) const override;
    void restore(const files::CheckpointReader& in) override;

  private:
    struct Books {
        double work = 0.0, loss = 0.0, heat_of_floor = 0.0, mass_of_floor = 0.0;
    };
    struct Column;

    Column column(std::int64_t ix, std::int64_t iy) const;
    void close(std::int64_t column);
    void enforce_walls(std::int64_t column);
    void difference(std::int64_t column, double gravity, double dt);
    void difference_at_wall(std::int64_t column, std::int64_t node, std::int64_t inward, double dt);
    Books settle(std::int64_t column, double dt);
    int threads() const;
    [[noreturn]] void fail(double t, double dt) const;
    double energy() const;
    double potential_energy() const;

    Setup setup_;
    mutable Flow cells_;  // filled when flow() is asked for
    Kernels kernels_;
    Constants constants_;
    EffectiveDissipation dissipation_;
    Grid nodes_;
    Flow now_, next_;
    std::vector<double> pressure_, bulk_, shear_, conductivity_, density_conductivity_, cooling_, sound_;
    double floor_density_ = 0.0;
    double smallest_spacing_ = 1.0;
    double strength_ = 0.0;  // C_AD
    double body_force_work_ = 0.0, gravity_work_ = 0.0, collisional_loss_ = 0.0, floor_gain_ = 0.0, floor_mass_ = 0.0;
    double initial_energy_ = 0.0, initial_potential_energy_ = 0.0, initial_mass_ = 0.0;
    std::int64_t steps_ = 0;
    bool closed_ = false;  // whether pressure and coefficients are those of now_
};

}  // namespace shaken::continuum
