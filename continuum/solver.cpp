// SPDX-License-Identifier: MIT
#include "continuum/solver.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "continuum/advance.hpp"
#include "continuum/errors.hpp"
#include "continuum/initial_state.hpp"
#include "continuum/method.hpp"
#include "files/errors.hpp"
#include "scene/schedule.hpp"

namespace shaken::continuum {

struct Solver::Parts {
    explicit Parts(const scene::Scene& scene)
        : period(scene.motion.period()),
          phases(scene.sample.phases),
          phase_index(scene::start_of(scene).phase_index),
          method(make_method(make_setup(scene))) {}

    double instant(std::int64_t index) const {
        return period * (static_cast<double>(index) / static_cast<double>(phases));
    }

    /// From one sample instant to the next, in equal steps as far as the waves allow.
    void advance_one_interval() {
        const double from = instant(phase_index), to = instant(phase_index + 1);
        try {
            advance(*method, from + past, to, (to - from) / most_steps_an_interval);
        } catch (const RunFailed& failure) {
            past = failure.time - from;
            throw RunFailed(fmt::format("{}, in cycle {}", failure.what(), cycle), failure.time);
        }
        past = 0.0;
        if (++phase_index == phases) {
            phase_index = 0;
            ++cycle;
        }
    }

    static constexpr double most_steps_an_interval = 1e6;

    double period;
    std::int64_t phases;
    std::int64_t cycle = 0, phase_index;
    std::unique_ptr<Method> method;
    double past = 0.0;  // time since that instant, where a run has failed on the way to the next
};

Solver::Solver(const scene::Scene& scene) : parts_(std::make_unique<Parts>(scene)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

void Solver::advance_to_instant(std::int64_t cycle, std::int64_t phase_index) {
    const auto reached = [&] { return parts_->cycle * parts_->phases + parts_->phase_index; };
    const std::int64_t wanted = cycle * parts_->phases + phase_index;
    if (phase_index < 0 || phase_index >= parts_->phases || wanted < reached())
        throw std::logic_error(fmt::format("continuum: instant {} of cycle {} does not lie ahead of instant {} of cycle {}",
                                           phase_index, cycle, parts_->phase_index, parts_->cycle));
    while (reached() < wanted) parts_->advance_one_interval();
}

std::int64_t Solver::cycle() const { return parts_->cycle; }
std::int64_t Solver::phase_index() const { return parts_->phase_index; }
double Solver::time_in_cycle() const { return parts_->instant(parts_->phase_index); }

std::int64_t Solver::cells_x() const { return parts_->method->grid().nx; }
std::int64_t Solver::cells_y() const { return parts_->method->grid().ny; }
std::int64_t Solver::cells_z() const { return parts_->method->grid().nz; }
double Solver::spacing_x() const { return parts_->method->grid().dx; }
double Solver::spacing_y() const { return parts_->method->grid().dy; }
double Solver::spacing_z() const { return parts_->method->grid().dz; }

ColumnView Solver::column(std::int64_t ix, std::int64_t iy) const {
    const Grid& grid = parts_->method->grid();
    const Flow& flow = parts_->method->flow();
    const auto inside = [&](const std::vector<double>* field) {
        return std::span<const double>(field->data() + grid.first(grid.column(ix, iy)),
                                       static_cast<std::size_t>(grid.nz));
    };
    const auto [density, velocity_x, velocity_y, velocity_z, temperature] = flow.fields();
    return {inside(density), inside(velocity_x), inside(velocity_y), inside(velocity_z), inside(temperature)};
}

double Solver::mass() const { return parts_->method->mass(); }
std::int64_t Solver::steps() const { return parts_->method->steps(); }
Ledger Solver::ledger() const { return parts_->method->ledger(); }

void Solver::save(files::CheckpointWriter& out) const {
    parts_->method->save(out);
    out.put("continuum/cycle", parts_->cycle);
    out.put("continuum/phase", parts_->phase_index);
    out.put("continuum/phases", parts_->phases);
    out.put("continuum/past", parts_->past);
}

void Solver::restore(const files::CheckpointReader& in) {
    const Grid& grid = parts_->method->grid();
    if (in.take<std::int64_t>("continuum/cells") != std::vector<std::int64_t>{grid.nx, grid.ny, grid.nz} ||
        in.take_one<std::int64_t>("continuum/phases") != parts_->phases)
        throw files::Damaged(
            "the checkpoint was written for another grid or another number of phases than the scene's");
    parts_->method->restore(in);
    parts_->cycle = in.take_one<std::int64_t>("continuum/cycle");
    parts_->phase_index = in.take_one<std::int64_t>("continuum/phase");
    parts_->past = in.take_one<double>("continuum/past");
}

std::uint64_t Solver::state_hash() const {
    files::CheckpointWriter state;
    save(state);
    return state.hash();
}

}  // namespace shaken::continuum
