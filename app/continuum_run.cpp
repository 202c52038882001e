// SPDX-License-Identifier: MIT
#include "app/continuum_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "continuum/resolve.hpp"
#include "fields/field_file.hpp"
#include "files/provenance.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

/// What is recorded at every sample instant, in the order of ContinuumRun::advance_and_sample. Totals are per area.
const std::vector<std::string> columns{"centre_of_mass",   "mass",
                                       "energy",           "body_force_work",
                                       "gravity_work",     "potential_gain",
                                       "collisional_loss", "floor_gain",
                                       "dual_energy_gain", "plate_impulse",
                                       "lid_impulse",      "steps",
                                       "knudsen",          "knudsen_largest",
                                       "omega_tau",        "omega_tau_largest",
                                       "packed_share"};

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

}  // namespace

ContinuumRun::ContinuumRun(const scene::Scene& scene)
    : scene_(continuum::resolve(scene)),
      schedule_(scene_),
      solver_(scene_),
      gas_(continuum::make_equation_of_state(scene_)),
      sampler_(scene_),
      series_(columns),
      next_(schedule_.sample(scene::start_of(scene_))) {}

bool ContinuumRun::advance_and_sample(const AskedToStop&) {
    const scene::Instant now = schedule_.instant(next_);
    solver_.advance_to_instant(now.cycle, now.phase_index);
    sampler_.sample(solver_, now);
    double moment = 0.0, total = 0.0;
    for_each_cell(solver_, [&](auto, auto, std::int64_t iz, const continuum::ColumnView& column) {
        const double density = column.density[static_cast<std::size_t>(iz)];
        total += density;
        moment += density * (static_cast<double>(iz) + 0.5) * solver_.spacing_z();
    });
    const double height = scene_.motion.position(schedule_.time_in_cycle(now)) + moment / total;
    const continuum::Ledger l = solver_.ledger();
    const compare::Validity v = validity_now();
    series_.add(next_, schedule_.time(now),
                std::array{height, solver_.mass(), l.energy, l.body_force_work, l.gravity_work, l.potential_gain,
                           l.collisional_loss, l.floor_gain, l.dual_energy_gain, l.plate_impulse, l.lid_impulse,
                           static_cast<double>(solver_.steps()), v.knudsen, v.knudsen_largest, v.omega_tau,
                           v.omega_tau_largest, v.packed_share});
    if (schedule_.is_frame(now)) frames_.push_back(frame());
    ++next_;
    return true;
}

compare::Validity ContinuumRun::validity_now() const {
    std::vector<continuum::ColumnView> views;
    for (std::int64_t iy = 0; iy < solver_.cells_y(); ++iy)
        for (std::int64_t ix = 0; ix < solver_.cells_x(); ++ix) views.push_back(solver_.column(ix, iy));
    return compare::validity_of(views, solver_.spacing_z(), gas_, 2.0 * std::numbers::pi * scene_.motion.frequency);
}

compare::ValidityOfRun ContinuumRun::validity() const {
    std::vector<compare::Validity> states;
    const auto averaged = static_cast<std::size_t>(scene_.sample.average * scene_.sample.phases);
    for (std::size_t row = series_.rows() - std::min(series_.rows(), averaged); row < series_.rows(); ++row)
        states.push_back({series_.value(row, "knudsen"), series_.value(row, "knudsen_largest"),
                          series_.value(row, "omega_tau"), series_.value(row, "omega_tau_largest"),
                          series_.value(row, "packed_share")});
    return compare::over_run(states);
}

ContinuumFrame ContinuumRun::frame() const {
    ContinuumFrame f;
    f.sample = next_;
    const auto nx = solver_.cells_x(), ny = solver_.cells_y(), nz = solver_.cells_z();
    const double plate_velocity = scene_.motion.velocity(schedule_.time_in_cycle(schedule_.instant(next_)));
    for (auto* field : {&f.density, &f.velocity_x, &f.velocity_y, &f.velocity_z, &f.temperature}) {
        field->resize(static_cast<std::size_t>(nx * ny * nz));
    }
    for_each_cell(solver_, [&](std::int64_t ix, std::int64_t iy, std::int64_t iz, const continuum::ColumnView& column) {
        const auto to = static_cast<std::size_t>((iz * ny + iy) * nx + ix), from = static_cast<std::size_t>(iz);
        f.density[to] = column.density[from];
        f.velocity_x[to] = column.velocity_x[from];
        f.velocity_y[to] = column.velocity_y[from];
        f.velocity_z[to] = column.velocity_z[from] + plate_velocity;
        f.temperature[to] = column.temperature[from];
    });
    return f;
}

void ContinuumRun::save(files::CheckpointWriter& out, const Spent& spent) const {
    out.put_text("scene", scene::print_scene(scene_));
    out.put_text("engine", name());
    out.put("next_sample", next_);
    out.put("spent", spent);
    solver_.save(out);
    sampler_.save(out);
    series_.save(out, "series/");
    out.put("frames/count", static_cast<std::int64_t>(frames_.size()));
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const std::string prefix = fmt::format("frames/{}/", i);
        out.put(prefix + "sample", frames_[i].sample);
        out.put(prefix + "density", frames_[i].density);
        out.put(prefix + "velocity_x", frames_[i].velocity_x);
        out.put(prefix + "velocity_y", frames_[i].velocity_y);
        out.put(prefix + "velocity_z", frames_[i].velocity_z);
        out.put(prefix + "temperature", frames_[i].temperature);
    }
}

void ContinuumRun::restore(const files::CheckpointReader& in) {
    next_ = in.take_one<std::int64_t>("next_sample");
    solver_.restore(in);
    sampler_.restore(in);
    series_.restore(in, "series/");
    frames_.resize(static_cast<std::size_t>(in.take_one<std::int64_t>("frames/count")));
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const std::string prefix = fmt::format("frames/{}/", i);
        frames_[i].sample = in.take_one<std::int64_t>(prefix + "sample");
        frames_[i].density = in.take<double>(prefix + "density");
        frames_[i].velocity_x = in.take<double>(prefix + "velocity_x");
        frames_[i].velocity_y = in.take<double>(prefix + "velocity_y");
        frames_[i].velocity_z = in.take<double>(prefix + "velocity_z");
        frames_[i].temperature = in.take<double>(prefix + "temperature");
    }
}

double ContinuumRun::force_on_upper_end() const {
    const auto averaged = static_cast<std::size_t>(scene_.sample.average * scene_.sample.phases);
    if (series_.rows() < 2) return 0.0;
    const std::size_t last = series_.rows() - 1, first = last > averaged ? last - averaged : 0;
    const double impulse = series_.value(last, "lid_impulse") - series_.value(first, "lid_impulse");
    return impulse / ((series_.time(last) - series_.time(first)) * series_.value(last, "mass"));
}

Notes ContinuumRun::notes() const {
    Notes notes = notes_of_scene(scene_);
    for (const std::string& warning : compare::warnings(validity())) notes.push_back(warning);
    for (std::string& note : notes_of_upper_end(scene_, force_on_upper_end())) notes.push_back(std::move(note));
    return notes;
}

void ContinuumRun::write(const std::filesystem::path& path, const Spent& spent, const std::string& parent) const {
    const std::filesystem::path aside = path.string() + ".part";
    files::Hdf5File file(aside, files::Open::create);
    files::write_provenance(file, {scene::print_scene(scene_), scene_.initial.seed, parent});
    fields::FieldFile frames(file, path,
                             {{solver_.cells_x(), solver_.cells_y(), solver_.cells_z()},
                              {solver_.spacing_x(), solver_.spacing_y(), solver_.spacing_z()}});
    for (const ContinuumFrame& f : frames_) {
        const scene::Instant at = schedule_.instant(f.sample);
        frames.add_frame(schedule_.time(at), at.cycle, schedule_.phase(at),
                         scene_.motion.position(schedule_.time_in_cycle(at)),
                         {{"density", f.density},
                          {"velocity_x", f.velocity_x},
                          {"velocity_y", f.velocity_y},
                          {"velocity_z", f.velocity_z},
                          {"temperature", f.temperature}});
    }
    sampler_.moments().write(file, "/profiles");
    if (sampler_.maps().rows() > 0) sampler_.maps().write(file, "/height_maps");
    series_.write(file);
    file.make_group("/run");
    file.attribute("/run", "wall_seconds", spent.wall);
    file.attribute("/run", "cpu_seconds", spent.cpu);
    for (const auto& [name, value] : compare::named(validity())) file.write("/validity/" + name, value);
    file.write_text("/run/notes", joined(notes()));
    file.close();
    std::filesystem::rename(aside, path);
    frames.write_xdmf();
}

}  // namespace shaken::app
