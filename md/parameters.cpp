// SPDX-License-Identifier: MIT
#include "md/parameters.hpp"

#include <fmt/format.h>

#include "scene/errors.hpp"
#include "scene/parameters.hpp"
#include "scene/read_scene.hpp"

namespace shaken::md {

namespace {

using scene::Kind;
using scene::ParameterVisitor;
using scene::Part;
using scene::positive;
using scene::Scene;

void describe_contacts(scene::Particles& p, ParameterVisitor& v) {
    v.friction({"friction", "",
                "\"none\", or { law = \"walton\", beta0 = 0.35, mu = 0.5 }, or the law \"walton_without_spin\""},
               p.friction);
    v.remedy({"collapse", "", "remedy against inelastic collapse"}, p.collapse);
    v.number({"collapse_speed", "sqrt(g sigma)", "elastic_below: contacts slower than this are elastic"},
             p.collapse_speed, positive);
    v.number({"collapse_time", "sqrt(sigma/g)",
              "contact_time: contacts that follow another of a partner sooner than this are elastic"},
             p.collapse_time, positive);
}

void describe_shared(Scene& s, std::string_view section, ParameterVisitor& v) {
    if (section == "particles") describe_contacts(s.particles, v);
    if (section == "box")
        v.number({"ceiling", "sigma", "height of the ceiling, fixed in the lab"}, s.box.ceiling, scene::widths);
}

void describe_own(Scene& s, ParameterVisitor& v) {
    if (s.kind != Kind::layer && s.kind != Kind::uniform) return;
    v.section("md", "event-driven molecular dynamics");
    v.seed({"seed", "", "of positions and velocities at the start", Part::start}, s.md.seed);
    v.number({"shell", "sigma", "reach of a neighbour list beyond contact; 0: chosen from the density", Part::method},
             s.md.shell, {0.0, 10.0});
    v.number({"contacts_between_sorts", "", "of each particle, before they are reordered in space; 0: the default",
              Part::method},
             s.md.contacts_between_sorts, {0.0, 1e9});
    if (s.kind == Kind::layer)
        v.whole({"frames_per_cycle", "", "how often the moving frame follows the layer; 0: the default", Part::method},
                s.md.frames_per_cycle, {0.0, 10000.0});
}

void check_ceiling(const Scene& s) {
    const double thickness = s.thickness_at_start(), highest_plate = 2.0 * s.motion.amplitude;
    if (s.box.ceiling < highest_plate + thickness + 1.0)
        throw scene::refusal(
            s, "box.ceiling",
            fmt::format("box.ceiling = {} is too low: the plate rises to {:.4g} and the layer is {:.4g} thick at the "
                        "start",
                        s.box.ceiling, highest_plate, thickness));
}

/// Refuses what no machine holds, with an estimate, before it is tried.
void check_frames(const Scene& s) {
    constexpr double largest = 8e9;  // bytes
    const double states = static_cast<double>(s.sample.frames * s.sample.frame_cycles);
    const double frames = states * 6.0 * 8.0 * static_cast<double>(s.number_of_particles);
    if (frames > largest)
        throw scene::refusal(s, "sample.frames",
                             fmt::format("{:.3g} whole states of {} particles need {:.3g} GB; at most 8 are allowed",
                                         states, s.number_of_particles, 1e-9 * frames));
}

void check(const Scene& s) {
    if (s.kind != Kind::layer) return;
    check_ceiling(s);
    check_frames(s);
}

}  // namespace

const scene::KeyOwner keys{"md", describe_shared, describe_own, check};

scene::Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    return scene::read_scene(path, scene::alone(keys), overrides);
}

}  // namespace shaken::md
