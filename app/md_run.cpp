// SPDX-License-Identifier: MIT
#include "app/md_run.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>

#include "files/provenance.hpp"
#include "md/h5md.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

namespace {

/// What is recorded at every sample instant, in the order of MdRun::advance_and_sample.
const std::vector<std::string> columns{"centre_of_mass", "kinetic_energy",  "rotational_energy", "potential_energy",
                                       "plate_work",     "ceiling_work",    "collision_loss",    "plate_loss",
                                       "ceiling_loss",   "momentum_x",      "momentum_y",        "momentum_z",
                                       "plate_impulse",  "pair_collisions", "plate_collisions",  "ceiling_collisions"};

}  // namespace

md::Options md_options_of(const scene::Scene& scene) {
    return {scene.md.shell, static_cast<int>(scene.md.frames_per_cycle), scene.md.contacts_between_sorts};
}

void save_frame(files::CheckpointWriter& out, std::size_t number, const md::Snapshot& frame) {
    const std::string prefix = fmt::format("frames/{}/", number);
    out.put(prefix + "position", frame.position);
    out.put(prefix + "velocity", frame.velocity);
    out.put(prefix + "spin", frame.spin);
    out.put(prefix + "cycle", frame.cycle);
    out.put(prefix + "time_in_cycle", frame.time_in_cycle);
}

md::Snapshot restore_frame(const files::CheckpointReader& in, std::size_t number) {
    const std::string prefix = fmt::format("frames/{}/", number);
    return {in.take_one<std::int64_t>(prefix + "cycle"), in.take_one<double>(prefix + "time_in_cycle"),
            in.take<std::array<double, 3>>(prefix + "position"), in.take<std::array<double, 3>>(prefix + "velocity"),
            in.take<std::array<double, 3>>(prefix + "spin")};
}

MdRun::MdRun(const scene::Scene& scene)
    : scene_(scene),
      schedule_(scene),
      scene_text_(scene::print_scene(scene)),
      simulation_(scene, md_options_of(scene)),
      sampler_(scene),
      series_(columns),
      next_(schedule_.sample(scene::start_of(scene))) {}

bool MdRun::advance_and_sample(const AskedToStop& asked_to_stop) {
    const scene::Instant now = schedule_.instant(next_);
    while (!simulation_.advance_to(now.cycle, schedule_.time_in_cycle(now), predictions_between_looks))
        if (asked_to_stop()) return false;
    const md::Snapshot snapshot = simulation_.snapshot();
    sampler_.sample(snapshot, now);
    const md::Ledger l = simulation_.ledger();
    const md::Counters c = simulation_.counters();
    double height = 0.0;
    for (const auto& position : snapshot.position) height += position[2];
    const auto n = [](std::int64_t count) { return static_cast<double>(count); };
    series_.add(next_, schedule_.time(now),
                std::array{height / n(simulation_.particles()), l.kinetic, l.rotational, l.potential, l.plate_work,
                           l.ceiling_work, l.collision_loss, l.plate_loss, l.ceiling_loss, l.momentum[0], l.momentum[1],
                           l.momentum[2], l.plate_impulse, n(c.pair_collisions), n(c.plate_collisions),
                           n(c.ceiling_collisions)});
    if (schedule_.is_frame(now)) frames_.push_back(snapshot);
    ++next_;
    return true;
}

bool MdRun::advance_to_end(const AskedToStop& asked_to_stop) {
    while (!simulation_.advance_to(schedule_.cycles(), 0.0, predictions_between_looks))
        if (asked_to_stop()) return false;
    return true;
}

void MdRun::save(files::CheckpointWriter& out, const Spent& spent) const {
    out.put_text("scene", scene_text_);
    out.put_text("engine", name());
    out.put("next_sample", next_);
    out.put("spent", spent);
    simulation_.save(out);
    sampler_.save(out);
    series_.save(out, "series/");
    out.put("frames/count", static_cast<std::int64_t>(frames_.size()));
    for (std::size_t i = 0; i < frames_.size(); ++i) save_frame(out, i, frames_[i]);
}

void MdRun::restore(const files::CheckpointReader& in) {
    scene_text_ = in.take_text("scene");
    next_ = in.take_one<std::int64_t>("next_sample");
    simulation_.restore(in);
    sampler_.restore(in);
    series_.restore(in, "series/");
    frames_.resize(static_cast<std::size_t>(in.take_one<std::int64_t>("frames/count")));
    for (std::size_t i = 0; i < frames_.size(); ++i) frames_[i] = restore_frame(in, i);
}

void MdRun::write(const std::filesystem::path& path, const Spent& spent, const std::string& parent) const {
    const std::filesystem::path aside = path.string() + ".part";
    const md::Box box{scene_.box.x, scene_.box.y, scene_.box.ceiling, false, scene_.motion};
    md::H5mdWriter writer(aside, box, {scene_text_, scene_.md.seed, parent});
    std::vector<double> phases;
    for (const md::Snapshot& frame : frames_) {
        phases.push_back(frame.time_in_cycle / scene_.motion.period());
        const double time = static_cast<double>(frame.cycle) * scene_.motion.period() + frame.time_in_cycle;
        const double step = (static_cast<double>(frame.cycle) + phases.back()) * static_cast<double>(this->phases());
        writer.append(frame, std::llround(step), time);
    }
    files::Hdf5File& file = writer.file();
    file.write("/particles/all/phase", phases);
    sampler_.moments().write(file, "/profiles");
    if (sampler_.maps().rows() > 0) sampler_.maps().write(file, "/height_maps");
    series_.write(file);
    file.make_group("/run");
    file.attribute("/run", "wall_seconds", spent.wall);
    file.attribute("/run", "cpu_seconds", spent.cpu);
    writer.close();
    std::filesystem::rename(aside, path);
}

}  // namespace shaken::app
