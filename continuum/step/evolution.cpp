// SPDX-License-Identifier: MIT
#include "continuum/step/evolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuum/boundary/fill_ghosts.hpp"
#include "continuum/closures/pressure.hpp"
#include "continuum/errors.hpp"
#include "continuum/flux/wave_speeds.hpp"

namespace shaken::continuum {

namespace {

// A step is halved at most this often before the run is given up: by then it is 1/1024 of what the waves allow.
constexpr int most_halvings = 10;
constexpr int halvings_at_full_order = 3;

}  // namespace

Evolution::Evolution(Setup setup)
    : fluid_(std::move(setup)),
      carry_(fluid_),
      relax_(fluid_),
      start_(fluid_.flow()),
      start_books_(fluid_.books),
      scratch_(rows_of_threads<Scratch>(fluid_)),
      initial_energy_(total_energy()),
      initial_potential_energy_(potential_energy()) {}

// Each carry is cfl of what the fastest direction allows, and no more than what all directions together do: an unsplit
// scheme is stable while the Courant numbers add up to less than one. Cells ten times wider than high leave the first
// condition the stricter one, so that a flow uniform in x and y takes the steps of one column.
double Evolution::longest_step() {
    const std::int64_t nz = grid().nz, columns = grid().columns();
    const double per_dx = grid().nx > 1 ? 1.0 / grid().dx : 0.0, per_dy = grid().ny > 1 ? 1.0 / grid().dy : 0.0;
    const double per_dz = 1.0 / grid().dz, packing = fluid_.constants.packing_density;
    double fastest = 0.0, together = 0.0;
#pragma omp parallel for schedule(static) num_threads(fluid_.threads()) reduction(max : fastest, together)
    for (std::int64_t column = 0; column < columns; ++column) {
        Scratch& scratch = scratch_[thread()];
        const std::int64_t first = grid().first(column);
        fill_ghosts(fluid_.flow(), first, nz, fluid_.setup.boundaries, packing);
        double *sound = scratch.sound_speed, *vertical = scratch.rate;
        const double* density = flow().density.data() + first - 1;
        const double* velocity = flow().velocity_z.data() + first - 1;
        fluid_.kernels.pressure(density, flow().temperature.data() + first - 1, scratch.pressure, sound, nz + 2,
                                fluid_.constants);
        double rate = 0.0;
#pragma omp simd reduction(max : rate)
        for (std::int64_t f = 0; f <= nz; ++f) {
            const double closing = kinematic_speed(density[f], density[f + 1], velocity[f] - velocity[f + 1], packing);
            const double speed = larger(std::abs(velocity[f]), std::abs(velocity[f + 1])) +
                                 larger(larger(sound[f], sound[f + 1]), closing);
            vertical[f] = per_dz * speed;
            rate = larger(rate, vertical[f]);
        }
        double all = rate;
        if (columns > 1) {
            const double *u_x = flow().velocity_x.data() + first, *u_y = flow().velocity_y.data() + first;
#pragma omp simd reduction(max : rate, all)
            for (std::int64_t i = 0; i < nz; ++i) {
                const double along_x = per_dx * (std::abs(u_x[i]) + sound[i + 1]);
                const double along_y = per_dy * (std::abs(u_y[i]) + sound[i + 1]);
                rate = larger(rate, larger(along_x, along_y));
                all = larger(all, larger(vertical[i], vertical[i + 1]) + (along_x + along_y));
            }
        }
        fastest = larger(fastest, rate);
        together = larger(together, all);
    }
    return static_cast<double>(carries_a_step) * smaller(fluid_.setup.choices.cfl / fastest, 1.0 / together);
}

void Evolution::step(double t, double dt) {
    struct Piece {
        double t, dt;
        int halvings;
    };
    const Carry::Sweeps usual{fluid_.kernels.sweep, fluid_.kernels.sweep_horizontal, fluid_.kernels.sweep_thin};
    const Carry::Sweeps careful{fluid_.kernels.sweep_first_order, fluid_.kernels.sweep_first_order,
                                fluid_.kernels.sweep_first_order};
    // Pieces still to do, the next one last.
    std::vector<Piece> pieces{{t, dt, 0}};
    while (!pieces.empty()) {
        const Piece piece = pieces.back();
        pieces.pop_back();
#pragma omp parallel for schedule(static) num_threads(fluid_.threads())
        for (std::int64_t column = 0; column < grid().columns(); ++column) copy_column(grid(), flow(), start_, column);
        start_books_ = fluid_.books;
        const bool first_order = piece.halvings > halvings_at_full_order;
        if (try_step(piece.t, piece.dt, first_order ? careful : usual)) {
            ++steps_;
            continue;
        }
        ++repeated_;
        if (piece.halvings == most_halvings) {
            std::swap(fluid_.flow(), start_);
            std::swap(fluid_.books, start_books_);
            fail(piece.t, piece.dt);  // what start_ now holds is the state that was refused
        }
        fluid_.flow() = start_;
        fluid_.books = start_books_;
        const double half = 0.5 * piece.dt;
        pieces.push_back({piece.t + half, half, piece.halvings + 1});
        pieces.push_back({piece.t, half, piece.halvings + 1});
    }
}

bool Evolution::try_step(double t, double dt, const Carry::Sweeps& sweeps) {
    const double half = 0.5 * dt;
    if (!carry_(t, half, sweeps)) return false;
    relax_(dt);
    return carry_(t + half, half, sweeps);
}

void Evolution::fail(double t, double dt) const {
    for (std::int64_t column = 0; column < grid().columns(); ++column)
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            const double n = start_.density[i], temperature = start_.temperature[i];
            if (n > 0.0 && n < fluid_.constants.packing_density && temperature > 0.0 &&
                std::isfinite(start_.velocity_z[i]) && std::isfinite(temperature))
                continue;
            throw RunFailed(fmt::format("continuum: no step can be made at time {:.6g} in the cycle (the last one "
                                        "tried was {:.3g}): column "
                                        "({}, {}), height {:.4g} above the plate would reach volume fraction {:.6g} "
                                        "(packing {:.4g}), velocity "
                                        "{:.6g}, temperature {:.6g}",
                                        t, dt, column % grid().nx, column / grid().nx, grid().centre(iz),
                                        sphere_volume * n, fluid_.kernels.packing, start_.velocity_z[i], temperature),
                            t);
        }
    throw RunFailed(
        fmt::format("continuum: no step can be made at time {:.6g} in the cycle (the last one tried was {:.3g})", t,
                    dt),
        t);
}

double Evolution::bytes_per_cell() const {
    const std::size_t a_field = start_.density.size(), fields = 2 * start_.fields().size() + 8;  // state, start, rates
    const std::size_t doubles = fields * a_field + carry_.doubles() + relax_.doubles();
    return 8.0 * static_cast<double>(doubles) / static_cast<double>(grid().cells());
}

double Evolution::mass() const {
    double all = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        double sum = 0.0;
        const double* n = flow().density.data() + grid().first(column);
        for (std::int64_t i = 0; i < grid().nz; ++i) sum += n[i];
        all += sum;
    }
    return all * grid().dz / static_cast<double>(grid().columns());
}

double Evolution::mass_share_at_temperature_floor() const {
    double held = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column)
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            // A step of diffusion may leave a cell a little above the floor it was put on.
            if (flow().temperature[i] < 1.01 * fluid_.constants.floor_temperature) held += flow().density[i];
        }
    return held * grid().dz / (static_cast<double>(grid().columns()) * mass());
}

double Evolution::total_energy() const {
    double all = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        double sum = 0.0;
        for (std::int64_t iz = 0; iz < grid().nz; ++iz) {
            const auto i = static_cast<std::size_t>(grid().first(column) + iz);
            const double ux = flow().velocity_x[i], uy = flow().velocity_y[i], uz = flow().velocity_z[i];
            sum += flow().density[i] * (1.5 * flow().temperature[i] + 0.5 * (ux * ux + uy * uy + uz * uz));
        }
        all += sum;
    }
    return all * grid().dz / static_cast<double>(grid().columns());
}

double Evolution::potential_energy() const {
    double all = 0.0;
    for (std::int64_t column = 0; column < grid().columns(); ++column) {
        double moment = 0.0;
        const double* n = flow().density.data() + grid().first(column);
        for (std::int64_t i = 0; i < grid().nz; ++i) moment += n[i] * grid().centre(i);
        all += moment;
    }
    return fluid_.setup.gravity * all * grid().dz / static_cast<double>(grid().columns());
}

Ledger Evolution::ledger() const {
    Ledger sum;
    for (const Ledger& column : fluid_.books) sum += column;
    sum *= 1.0 / static_cast<double>(fluid_.books.size());
    sum.energy = total_energy();
    sum.initial_energy = initial_energy_;
    sum.potential_gain = potential_energy() - initial_potential_energy_;
    return sum;
}

Drift Evolution::drift() const {
    const Ledger books = ledger();
    return {0.0, books.dual_energy_gain / (books.initial_energy + books.collisional_loss)};
}

void Evolution::save(files::CheckpointWriter& out) const {
    out.put("continuum/cells", std::vector<std::int64_t>{grid().nx, grid().ny, grid().nz});
    save_flow(flow(), out);
    out.put("continuum/books", fluid_.books);
    out.put("continuum/initial_energy", initial_energy_);
    out.put("continuum/initial_potential_energy", initial_potential_energy_);
    out.put("continuum/steps", steps_);
    out.put("continuum/repeated_steps", repeated_);
}

void Evolution::restore(const files::CheckpointReader& in) {
    restore_flow(fluid_.flow(), in);
    in.take_into("continuum/books", std::span(fluid_.books));
    initial_energy_ = in.take_one<double>("continuum/initial_energy");
    initial_potential_energy_ = in.take_one<double>("continuum/initial_potential_energy");
    steps_ = in.take_one<std::int64_t>("continuum/steps");
    repeated_ = in.take_one<std::int64_t>("continuum/repeated_steps");
}

}  // namespace shaken::continuum
