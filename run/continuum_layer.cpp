// SPDX-License-Identifier: MIT
#include "run/continuum_layer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "continuum/initial_state.hpp"
#include "fields/field_file.hpp"
#include "files/errors.hpp"
#include "files/provenance.hpp"
#include "run/emit.hpp"

namespace shaken::run {

namespace {

/// Totals are per area, energies in the frame of the plate.
struct Sampled {
    continuum::Ledger ledger;
    compare::Validity validity;
    double height, mass;  // height of the centre of mass, lab frame
    std::int64_t steps;
};

const Recording<Sampled> recording({
    {"centre_of_mass", "sigma", [](const Sampled& s) { return s.height; }},
    {"mass", "m/sigma^2", [](const Sampled& s) { return s.mass; }},
    {"energy", "m g/sigma", [](const Sampled& s) { return s.ledger.energy; }},
    {"body_force_work", "m g/sigma", [](const Sampled& s) { return s.ledger.body_force_work; }},
    {"gravity_work", "m g/sigma", [](const Sampled& s) { return s.ledger.gravity_work; }},
    {"potential_gain", "m g/sigma", [](const Sampled& s) { return s.ledger.potential_gain; }},
    {"collisional_loss", "m g/sigma", [](const Sampled& s) { return s.ledger.collisional_loss; }},
    {"floor_gain", "m g/sigma", [](const Sampled& s) { return s.ledger.floor_gain; }},
    {"dual_energy_gain", "m g/sigma", [](const Sampled& s) { return s.ledger.dual_energy_gain; }},
    {"plate_impulse", "m sqrt(g/sigma^3)", [](const Sampled& s) { return s.ledger.plate_impulse; }},
    {"lid_impulse", "m sqrt(g/sigma^3)", [](const Sampled& s) { return s.ledger.lid_impulse; }},
    {"steps", "1", [](const Sampled& s) { return static_cast<double>(s.steps); }},
    {"knudsen", "1", [](const Sampled& s) { return s.validity.knudsen; }},
    {"knudsen_largest", "1", [](const Sampled& s) { return s.validity.knudsen_largest; }},
    {"omega_tau", "1", [](const Sampled& s) { return s.validity.omega_tau; }},
    {"omega_tau_largest", "1", [](const Sampled& s) { return s.validity.omega_tau_largest; }},
    {"packed_share", "1", [](const Sampled& s) { return s.validity.packed_share; }},
});

/// Runs `visit(ix, iy, iz, column)` over all cells.
template <class Visit>
void for_each_cell(const continuum::Solver& solver, Visit visit) {
    for (std::int64_t iy = 0; iy < solver.cells_y(); ++iy) {
        for (std::int64_t ix = 0; ix < solver.cells_x(); ++ix) {
            const continuum::ColumnView column = solver.column(ix, iy);
            for (std::int64_t iz = 0; iz < solver.cells_z(); ++iz) visit(ix, iy, iz, column);
        }
    }
}

/// z_cm above the plate.
double centre_of_mass(const continuum::Solver& solver) {
    double moment = 0.0, total = 0.0;
    for_each_cell(solver, [&](auto, auto, std::int64_t iz, const continuum::ColumnView& column) {
        const double density = column.density[static_cast<std::size_t>(iz)];
        total += density;
        moment += density * (static_cast<double>(iz) + 0.5) * solver.spacing_z();
    });
    return moment / total;
}

compare::Validity validity_now(const continuum::Solver& solver, const continuum::EquationOfState& gas,
                               const scene::PlateMotion& motion) {
    std::vector<continuum::ColumnView> views;
    for (std::int64_t iy = 0; iy < solver.cells_y(); ++iy)
        for (std::int64_t ix = 0; ix < solver.cells_x(); ++ix) views.push_back(solver.column(ix, iy));
    return compare::validity_of(views, solver.spacing_z(), gas, 2.0 * std::numbers::pi * motion.frequency);
}

/// A frame as a record: its sample, then density, velocity x y z in the lab, and temperature, each (nz, ny, nx).
std::vector<double> packed(const continuum::Solver& solver, std::int64_t sample, double plate_velocity) {
    const auto nx = solver.cells_x(), ny = solver.cells_y();
    const auto cells = static_cast<std::size_t>(nx * ny * solver.cells_z());
    std::vector<double> record(1 + 5 * cells, static_cast<double>(sample));
    for_each_cell(solver, [&](std::int64_t ix, std::int64_t iy, std::int64_t iz, const continuum::ColumnView& column) {
        const auto to = 1 + static_cast<std::size_t>((iz * ny + iy) * nx + ix), from = static_cast<std::size_t>(iz);
        record[to] = column.density[from];
        record[to + cells] = column.velocity_x[from];
        record[to + 2 * cells] = column.velocity_y[from];
        record[to + 3 * cells] = column.velocity_z[from] + plate_velocity;
        record[to + 4 * cells] = column.temperature[from];
    });
    return record;
}

}  // namespace

ContinuumLayerRecord::ContinuumLayerRecord(const scene::Scene& scene)
    : scene_(scene),
      schedule_(scene),
      gas_(continuum::make_equation_of_state(scene)),
      sampler_(scene, 0.0, fields::Heights::passed_on) {}

void ContinuumLayerRecord::sample(const continuum::Solver& solver, const scene::Instant& at, const Emit& emit) {
    sampler_.sample(solver, at);
    emit_maps(sampler_, emit);
    emit_height(schedule_, at, sampler_.moments().latest_centre_of_mass(), emit);
    const double time = schedule_.time_in_cycle(at);
    const compare::Validity validity = validity_now(solver, gas_, scene_.motion);
    recording.emit(schedule_.sample(at), schedule_.time(at),
                   {solver.ledger(), validity, scene_.motion.position(time) + centre_of_mass(solver), solver.mass(),
                    solver.steps()},
                   emit);
    book(solver, at, validity);
    if (schedule_.is_frame(at)) emit(Stream::frame, packed(solver, schedule_.sample(at), scene_.motion.velocity(time)));
}

std::int64_t ContinuumLayerRecord::samples_to_average() const {
    return schedule_.samples() - std::max(first_sample(), schedule_.settling_samples());
}

void ContinuumLayerRecord::book(const continuum::Solver& solver, const scene::Instant& at,
                                const compare::Validity& now) {
    const std::int64_t sample = schedule_.sample(at);
    books_.last_time = schedule_.time(at);
    books_.last_lid_impulse = solver.ledger().lid_impulse;
    books_.last_mass = solver.mass();
    // The force is averaged from the instant before the first averaged one on.
    if (sample == first_sample() || sample < schedule_.settling_samples()) {
        books_.first_time = books_.last_time;
        books_.first_lid_impulse = books_.last_lid_impulse;
    }
    if (!schedule_.is_averaged(at.cycle)) return;
    compare::add(books_.validity, now, 1.0 / static_cast<double>(samples_to_average()));
    ++books_.samples;
}

compare::ValidityOfRun ContinuumLayerRecord::validity() const {
    const double share = static_cast<double>(samples_to_average()) / static_cast<double>(books_.samples);
    compare::ValidityOfRun run = books_.validity;
    for (double* mean : {&run.mean.knudsen, &run.mean.omega_tau, &run.mean.packed_share}) *mean *= share;
    return run;
}

double ContinuumLayerRecord::force_on_upper_end() const {
    const double impulse = books_.last_lid_impulse - books_.first_lid_impulse;
    const double time = books_.last_time - books_.first_time;
    return time > 0.0 ? impulse / (time * books_.last_mass) : 0.0;
}

Notes ContinuumLayerRecord::notes() const {
    Notes notes = notes_of_scene(scene_);
    for (const std::string& warning : compare::warnings(validity())) notes.push_back(warning);
    for (std::string& note : notes_of_upper_end(scene_, force_on_upper_end())) notes.push_back(std::move(note));
    return notes;
}

void ContinuumLayerRecord::save(files::CheckpointWriter& out) const {
    sampler_.save(out);
    out.put("layer/books", books_);
}

void ContinuumLayerRecord::restore(const files::CheckpointReader& in) {
    sampler_.restore(in);
    books_ = in.take_one<Books>("layer/books");
}

void ContinuumLayerRecord::write(const Output& output) const {
    files::Hdf5File file(output.aside(), files::Open::create);
    files::write_provenance(file, {output.scene_text, scene_.initial.seed, output.parent});
    const continuum::Grid own = continuum::make_grid(scene_);
    const fields::Grid grid{{own.nx, own.ny, own.nz}, {own.dx, own.dy, own.dz}};
    fields::FieldFile frames(file, output.path, grid);
    const auto append = [&](std::span<const double> record) {
        const auto cells = static_cast<std::size_t>(grid.size());
        if (record.size() != 1 + 5 * cells)
            throw files::Damaged(fmt::format("{}: a frame of another grid", output.stream.string()));
        const scene::Instant at = schedule_.instant(static_cast<std::int64_t>(record[0]));
        const auto field = [&](std::size_t number) { return record.subspan(1 + number * cells, cells); };
        frames.add_frame(schedule_.time(at), at.cycle, schedule_.phase(at),
                         scene_.motion.position(schedule_.time_in_cycle(at)),
                         {{"density", field(0)},
                          {"velocity_x", field(1)},
                          {"velocity_y", field(2)},
                          {"velocity_z", field(3)},
                          {"temperature", field(4)}});
    };
    write_streams(file, output, {recording.names(), append, schedule_, sampler_.maps().grid()});
    sampler_.moments().write(file, "/profiles");
    write_spent(file, output.spent);
    for (const auto& [name, value] : compare::named(validity())) file.write("/validity/" + name, value);
    file.write_text("/run/notes", joined(notes()));
    file.close();
    std::filesystem::rename(output.aside(), output.path);
    frames.write_xdmf();
}

}  // namespace shaken::run
