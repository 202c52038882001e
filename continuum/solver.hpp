// SPDX-License-Identifier: MIT
// The continuum engine: granular hydrodynamics of one scene in the frame of the plate, in 1, 2 or 3 dimensions.
// Equations: Jenkins & Richman 1985 to Navier-Stokes order. Scheme: finite volumes in conservative variables, explicit
// in the acoustics (strong-stability-preserving Runge-Kutta), implicit in the diffusion, exact in the cooling.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "continuum/step/ledger.hpp"
#include "files/checkpoint.hpp"
#include "scene/scene.hpp"

namespace shaken::continuum {

/// One column of cells, bottom to top; shape (cells_z,) each. Plate frame: z = 0 at the plate, so the lab velocity is
/// velocity_z plus the plate's, the lab height z plus the plate's position. Density in particles per sigma^3.
/// Valid until the solver advances.
struct ColumnView {
    std::span<const double> density, velocity_x, velocity_y, velocity_z, temperature;
};

class Solver {
  public:
    /// Builds the scene's initial state at cycle 0, ft = 0 (or initial.phase of a file). Throws scene::SceneError
    /// (with the place) for a name of [continuum] that no table has or values that contradict each other.
    explicit Solver(const scene::Scene& scene);
    ~Solver();
    Solver(Solver&&) noexcept;
    Solver& operator=(Solver&&) noexcept;

    /// Advances to a sample instant of a cycle, numbered as in scene/schedule.hpp. Steps end exactly on
    /// every sample instant on the way, and nothing else shapes them, so that no output changes an answer.
    /// Throws std::logic_error for an instant in the past, RunFailed where the method fails.
    void advance_to_instant(std::int64_t cycle, std::int64_t phase_index);

    std::int64_t cycle() const;
    double time_in_cycle() const;
    std::int64_t phase_index() const;  // of the sample instant reached

    std::int64_t cells_x() const;
    std::int64_t cells_y() const;
    std::int64_t cells_z() const;
    double spacing_x() const;
    double spacing_y() const;
    double spacing_z() const;

    ColumnView column(std::int64_t ix, std::int64_t iy) const;

    double mass() const;         // particles per horizontal area
    std::int64_t steps() const;  // since the start of the history, restarts included
    Ledger ledger() const;

    void save(files::CheckpointWriter& out) const;
    /// Continues bit for bit. Throws files::Damaged where the checkpoint does not fit this scene.
    void restore(const files::CheckpointReader& in);
    std::uint64_t state_hash() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace shaken::continuum
