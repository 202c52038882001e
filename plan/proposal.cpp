// SPDX-License-Identifier: MIT
#include "plan/proposal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/choices.hpp"
#include "plan/rules.hpp"
#include "plan/table.hpp"
#include "scene/read_scene.hpp"

namespace shaken::plan {

namespace {

constexpr double trial_budget = 6.0;   // CPU seconds an engine
constexpr double budget_share = 0.2;   // of a wished time, an engine
constexpr double largest_error = 0.2;  // a plan for --seconds never aims at more
constexpr double error_step = 0.891;   // ten a factor of root ten

struct Both {
    ContinuumPlan continuum;
    MdPlan md;
    double seconds() const { return continuum.seconds + md.seconds; }
};

Both choose(Trials& trials, double error) {
    Both both;
    both.continuum = choose_continuum(trials, error);
    both.md = choose_md(trials, both.continuum, error);
    return both;
}

void refuse_others(const scene::Scene& scene) {
    if (scene.kind != scene::Kind::layer)
        throw CannotPlan("plan: only a shaken layer has a z_cm(ft) to plan for; this scene is of another kind");
    if (!scene.initial.file.empty())
        throw CannotPlan(
            "plan: a scene that starts from a file is followed, not averaged; plan it without initial.file");
}

/// The finest plan that the time allows.
std::pair<double, Both> choose_for(Trials& trials, double seconds) {
    double error = largest_error;
    Both kept = choose(trials, error);
    if (kept.seconds() > seconds)
        throw CannotPlan(fmt::format(
            "plan: --seconds {:g} is too short here; the least plan takes {:.2g} s (continuum {:.2g}, MD {:.2g}), with "
            "errors of {} and {}",
            seconds, kept.seconds(), kept.continuum.seconds, kept.md.seconds, per_cent(kept.continuum.error()),
            per_cent(kept.md.error())));
    const double floor = measured_table().floor();
    for (double next = error * error_step; next > floor; next *= error_step) {
        const Both tried = choose(trials, next);
        if (tried.seconds() > seconds) break;
        kept = tried;
        error = next;
    }
    return {error, kept};
}

std::vector<Reason> reasons_of(Trials& trials, const Proposal& p) {
    const scene::Scene& scene = trials.scene();
    const ContinuumPlan& c = p.continuum;
    const double wavelength = pattern_wavelength(scene);
    const std::string box = fmt::format("{:g} x {:g}", scene.box.x, scene.box.y);
    std::vector<Reason> reasons;
    const auto say = [&](std::string key, std::string value, std::string words) {
        reasons.push_back({std::move(key), std::move(value), std::move(words)});
    };
    if (c.dimension == 1)
        say("dimension", "1",
            fmt::format(
                "no wave fits: the box is {}, a pattern's wave {:.3g} long (H (1 + 1.1 f*^-1.32)); one column gives "
                "the same z_cm as a grid of them{}",
                box, wavelength,
                may_hold_pattern(scene)
                    ? "; but ch4_shock, in a box as wide for its wave, had one, and z_cm 4 % off: look "
                      "at `shaken patterns` of the MD, at several phases"
                    : ""));
    else
        say("dimension", fmt::format("{}", c.dimension),
            fmt::format("waves of {:.3g} fit along {} of {}", wavelength, c.dimension == 2 ? "one side" : "both sides",
                        box));
    const Scheme& scheme = measured_table().cheapest(0.5 * p.aimed);
    say("scheme", c.scheme,
        fmt::format("takes the least time for this error in the measured table (order {:.2g} in z_cm)",
                    scheme.error.order));
    say("spacing", fmt::format("{:g}", c.spacing),
        fmt::format("columns of this scene, each grid twice as fine as the last, leave {}", per_cent(c.grid)));
    if (c.dimension > 1)
        say("spacing_horizontal", fmt::format("{:.3g}", c.spacing_horizontal),
            fmt::format("{:g} cells a wave: its fading rate is 3 % off, z_cm {}", cells_a_wavelength,
                        per_cent(c.columns)));
    say("cfl", fmt::format("{:g}", scene.continuum.cfl),
        "the scene's: the error of the step is part of that of the spacing, with which it falls");
    say("lid", fmt::format("{:g}", c.lid),
        fmt::format("z_cm differs by {} from that under a lid at 400", per_cent(c.lid_error)));
    say("rows", fmt::format("{:.0f}", c.lid / c.spacing), "all up to the lid: gas reaches it, so none can be left out");
    if (p.md.cell > 0.0)
        say("box", fmt::format("{:.4g} x {:.4g}", p.md.box_x, p.md.box_y),
            fmt::format("{} particles in place of {}: a flat layer's z_cm differs by {} in so small a cell",
                        p.md.particles, scene.number_of_particles, per_cent(p.md.cell)));
    else
        say("box", box,
            p.md.particles <= flat_box(scene).number && c.dimension == 1 ? "the scene's, small enough"
            : c.dimension > 1                                            ? "the scene's, for its waves"
            : p.md.small_cell_may_collapse
                ? fmt::format("the scene's: grains may collapse in a cell of {:g}", flat_width)
                : fmt::format("the scene's: z_cm in a cell of {:g} would differ by {}", flat_width,
                              per_cent(flat_width_error)));
    say("spins", scene.particles.friction.law == scene::FrictionLaw::none ? "none" : "followed",
        scene.particles.friction.law == scene::FrictionLaw::none ? "without friction nothing turns"
                                                                 : "the scene has friction");
    say("settle", fmt::format("{}", c.settle),
        fmt::format("cycles; a column then keeps {} of its start{}", per_cent(c.start),
                    c.dimension > 1 ? ", and the scene's own time is kept for the pattern to grow" : ""));
    say("average", fmt::format("{} x {}", p.md.seeds, p.md.average),
        fmt::format("cycles of MD; ten blocks are the least that give an error, which falls as 1/sqrt(cycles seeds)"));
    if (p.md.drift > 0.0)
        say("drift", per_cent(p.md.drift),
            "the trial's MD went on changing after the column had settled: no number of cycles here ends that, longer "
            "settling may");
    say("continuum cycles", fmt::format("{}", c.average),
        c.average > 2 ? "the flow does not come back after two cycles" : "the flow comes back after one or two");
    return reasons;
}

std::vector<std::string> settings_of(const scene::Scene& scene, const Proposal& p) {
    const ContinuumPlan& c = p.continuum;
    std::vector<std::string> settings;
    const auto set = [&](const std::string& key, const std::string& value) { settings.push_back(key + "=" + value); };
    set("continuum.dimension", fmt::format("{}", c.dimension));
    set("continuum.scheme", fmt::format("\"{}\"", c.scheme));
    set("continuum.spacing", scene::written_number(c.spacing));
    if (c.dimension > 1) set("continuum.spacing_horizontal", scene::written_number(c.spacing_horizontal));
    set("continuum.lid", scene::written_number(c.lid));
    set("sample.settle", fmt::format("{}", c.settle));
    set("sample.average", fmt::format("{}", p.md.average));
    if (p.md.particles != scene.number_of_particles) {
        set("particles.number", fmt::format("{}", p.md.particles));
        set("box.x", scene::written_number(p.md.box_x));
        set("box.y", scene::written_number(p.md.box_y));
    }
    if (c.dimension == 1 && scene.initial.uneven()) {
        set("initial.noise", "0.0");
        set("initial.wave", "0.0");
    }
    if (c.dimension > 1 && !scene.initial.uneven()) set("initial.noise", "0.01");
    if (scene.sample.map_bin > std::min(p.md.box_x, p.md.box_y)) set("sample.map_bin", "0.0");
    return settings;
}

}  // namespace

Proposal propose(const scene::Scene& scene, const Wish& wish) {
    refuse_others(scene);
    const double floor = measured_table().floor();
    if (wish.error && *wish.error < floor)
        throw CannotPlan(
            fmt::format("plan: --error {} is below what any grid of the measured table reaches; the least is {}",
                        per_cent(*wish.error), per_cent(floor)));
    Trials trials(scene, wish.seconds ? std::min(trial_budget, budget_share * *wish.seconds) : trial_budget);
    Proposal p;
    p.wish = wish;
    Both both;
    if (wish.error) {
        p.aimed = *wish.error;
        both = choose(trials, p.aimed);
    } else {
        std::tie(p.aimed, both) = choose_for(trials, *wish.seconds);
    }
    p.continuum = both.continuum;
    p.md = both.md;
    p.settings = settings_of(scene, p);
    p.reasons = reasons_of(trials, p);
    p.trial_seconds = trials.spent();
    return p;
}

}  // namespace shaken::plan
