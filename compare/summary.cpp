// SPDX-License-Identifier: MIT
#include "compare/summary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace shaken::compare {

namespace {

using Json = nlohmann::ordered_json;
using Number = std::function<double(const Analysis&)>;

constexpr double profile_phase = 0.22;  // where the source shows a fully formed shock (figures 4.3 to 4.5)
constexpr double half_diameter = 0.5;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json value_or_null(const std::optional<double>& value) { return value ? finite_or_null(*value) : Json(nullptr); }

/// Puts a number under a key, and its standard error beside it where the engine has one.
void put(Json& object, const std::string& key, const Estimate& estimate, bool with_error) {
    object[key] = finite_or_null(estimate.value);
    if (with_error) object[key + "_error"] = finite_or_null(estimate.error);
}

Number of_history(std::int64_t cycle, double ShockHistory::*member) {
    return [cycle, member](const Analysis& a) {
        const std::optional<ShockHistory>& history = cycle == 0 ? a.history : a.second_history;
        return history ? (*history).*member : std::nan("");
    };
}

/// A number of the shock at the phase nearest to ft, of so many cycles.
Number of_shock_at(double phase, std::int64_t cycles, const std::function<double(const Shock&)>& number) {
    return [phase, cycles, number](const Analysis& a) {
        const std::optional<Shock>& shock = a.measures[nearest_phase(phase, a.measures.size(), cycles)].shock;
        return shock ? number(*shock) : std::nan("");
    };
}

/// A phase known only to one of the sampled phases has at least the error of a uniform distribution of that width.
void put_resolved(Json& object, const std::string& key, Estimate estimate, double step, bool with_error) {
    estimate.error = std::hypot(estimate.error, step / std::sqrt(12.0));
    put(object, key, estimate, with_error);
    if (with_error) object[key + "_resolution"] = step;
}

Json centre_of_mass_errors(const Measured& measured, std::int64_t phases) {
    Json errors = Json::array();
    for (std::int64_t k = 0; k < phases; ++k) {
        const auto height = [k, phases](const Analysis& a) {
            return at_equal_phases(a.centre_of_mass, phases)[static_cast<std::size_t>(k)];
        };
        errors.push_back(finite_or_null(measured.estimate(height).error));
    }
    return errors;
}

/// What the shock that forms in a cycle is like.
void put_shock(Json& out, const Measured& measured, std::int64_t cycle, bool with_error) {
    const std::int64_t cycles = measured.layout.cycles;
    const double step = static_cast<double>(cycles) / static_cast<double>(measured.all.measures.size());
    Json& shock = out["shock"];
    const auto history = [&](double ShockHistory::*member) {
        return measured.estimate_from_halves(of_history(cycle, member));
    };
    put_resolved(shock, "formation_phase", history(&ShockHistory::formation_phase), step, with_error);
    put_resolved(shock, "fully_formed_phase", history(&ShockHistory::fully_formed_phase), step, with_error);
    put(shock, "leaving_phase", history(&ShockHistory::leaving_phase), with_error);
    put(shock, "mean_speed", history(&ShockHistory::mean_speed), with_error);
    put(shock, "fully_formed_speed", history(&ShockHistory::fully_formed_speed), with_error);
    put(shock, "fitted_speed", history(&ShockHistory::fitted_speed), with_error);

    put(out, "max_mach", history(&ShockHistory::approach_mach), with_error);
    const auto at_profile_phase = [&](const std::function<double(const Shock&)>& number) {
        return measured.estimate_from_halves(of_shock_at(static_cast<double>(cycle) + profile_phase, cycles, number));
    };
    put(out, "width_over_mean_free_path", at_profile_phase([](const Shock& s) { return s.width() / s.mean_free_path; }),
        with_error);
    put(out, "width_over_mean_free_path_foot",
        at_profile_phase([](const Shock& s) { return s.width() / s.mean_free_path_foot; }), with_error);
    put(out, "slope_width_over_mean_free_path_foot",
        at_profile_phase([](const Shock& s) { return s.slope_width() / s.mean_free_path_foot; }), with_error);
    put(out, "shock_slope_width", at_profile_phase([](const Shock& s) { return s.slope_width(); }), with_error);
    put(out, "shock_width", at_profile_phase([](const Shock& s) { return s.width(); }), with_error);
    put(out, "shock_mach", at_profile_phase([](const Shock& s) { return s.mach_above; }), with_error);
}

Json engine(const Measured& measured, bool with_error) {
    const std::int64_t phases = compared_phases * measured.layout.cycles;
    Json out;
    out["period"] = measured.layout.period ? Json(*measured.layout.period) : Json(nullptr);
    out["zcm"] = at_equal_phases(measured.all.centre_of_mass, phases);
    if (with_error) out["zcm_error"] = centre_of_mass_errors(measured, phases);
    if (with_error) {
        out["memory_cycles"] = finite_or_null(measured.memory.cycles);
        out["too_short"] = !measured.memory.is_long_enough;
    }
    put_shock(out, measured, 0, with_error);
    if (measured.layout.cycles > 1) put_shock(out["second_cycle"], measured, 1, with_error);
    return out;
}

/// A number of the pair of engines; its error is that of MD, the continuum having none of this kind.
using NumberOfBoth = std::function<double(const Analysis& continuum, const Analysis& md)>;

Estimate of_both(const Measured& md, const Analysis& continuum, const NumberOfBoth& number) {
    return md.estimate([&](const Analysis& a) { return number(continuum, a); });
}

Estimate of_both_shocks(const Measured& md, const Analysis& continuum, const NumberOfBoth& number) {
    return md.estimate_from_halves([&](const Analysis& a) { return number(continuum, a); });
}

}  // namespace

double centre_of_mass_rms_percent(const std::vector<double>& continuum, const std::vector<double>& md, double lift,
                                  std::int64_t cycles) {
    const std::vector<double> ours = at_equal_phases(continuum, compared_phases * cycles);
    const std::vector<double> theirs = at_equal_phases(md, compared_phases * cycles);
    double squares = 0.0;
    for (std::size_t k = 0; k < ours.size(); ++k) {
        const double relative = (ours[k] + lift - theirs[k]) / theirs[k];
        squares += relative * relative;
    }
    return 100.0 * std::sqrt(squares / static_cast<double>(ours.size()));
}

double shock_location_rms(const Analysis& continuum, const Analysis& md, double lift, Life life) {
    if (continuum.measures.size() != md.measures.size()) return std::nan("");
    const auto is_counted = [&](const Analysis& a, std::int64_t phase) {
        return life == Life::formation_to_leaving ? a.follows(phase) : a.follows_fully_formed(phase);
    };
    double squares = 0.0;
    std::int64_t phases = 0;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(md.measures.size()); ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!is_counted(md, i) || !is_counted(continuum, i)) continue;
        if (!md.measures[k].shock || !continuum.measures[k].shock) continue;
        const double difference = continuum.measures[k].shock->location + lift - md.measures[k].shock->location;
        squares += difference * difference;
        ++phases;
    }
    return phases > 0 ? std::sqrt(squares / static_cast<double>(phases)) : std::nan("");
}

double profile_rms(const Analysis& continuum, const Analysis& md, Field field, double lift) {
    const auto value = [field](const fields::Profile& p, std::size_t bin) {
        switch (field) {
            case Field::density:
                return p.density[bin];
            case Field::velocity:
                return p.velocity[bin] - p.plate_velocity;
            case Field::temperature:
                return p.temperature[bin];
        }
        return std::nan("");
    };
    double squares = 0.0, whole = 0.0;
    for (std::size_t phase = 0; phase < md.profiles.size(); ++phase) {
        const fields::Profile &theirs = md.profiles[phase], &ours = continuum.profiles.at(phase);
        for (std::size_t bin = 0; bin < theirs.density.size(); ++bin) {
            if (!(theirs.volume_fraction(static_cast<std::int64_t>(bin)) > layer_volume_fraction)) continue;
            const double place = std::max(0.0, static_cast<double>(bin) - lift / ours.bins.width);
            const auto below = static_cast<std::size_t>(place);
            const std::size_t above = std::min(below + 1, ours.density.size() - 1);
            const double share = place - static_cast<double>(below);
            const double read =
                share == 0.0 ? value(ours, below) : (1.0 - share) * value(ours, below) + share * value(ours, above);
            const double reference = value(theirs, bin);
            if (!std::isfinite(read) || !std::isfinite(reference)) continue;
            squares += (read - reference) * (read - reference);
            whole += reference * reference;
        }
    }
    return std::sqrt(squares / whole);
}

nlohmann::ordered_json summarise(const Measured& md, const Measured& continuum, const scene::Scene& scene,
                                 const Cost& md_cost, const Cost& continuum_cost) {
    Json out;
    out["scene"] = scene.name;
    Json& md_out = out["md"] = engine(md, true);
    md_out["collisions_per_particle_per_cycle"] = value_or_null(md_cost.collisions_per_particle_per_cycle);
    md_out["collisions_per_particle_per_cycle_error"] = value_or_null(md_cost.collisions_per_particle_per_cycle_error);
    md_out["wall_seconds"] = value_or_null(md_cost.wall_seconds);
    md_out["cpu_seconds"] = value_or_null(md_cost.cpu_seconds);

    Json& continuum_out = out["continuum"] = engine(continuum, false);
    continuum_out["steps_per_cycle"] = value_or_null(continuum_cost.steps_per_cycle);
    continuum_out["wall_seconds"] = value_or_null(continuum_cost.wall_seconds);
    continuum_out["cpu_seconds"] = value_or_null(continuum_cost.cpu_seconds);

    const auto rms_percent = [cycles = md.layout.cycles](double lift) {
        return [lift, cycles](const Analysis& c, const Analysis& m) {
            return centre_of_mass_rms_percent(c.centre_of_mass, m.centre_of_mass, lift, cycles);
        };
    };
    put(out, "zcm_rms_percent", of_both(md, continuum.all, rms_percent(0.0)), true);
    put(out, "zcm_rms_percent_half_diameter", of_both(md, continuum.all, rms_percent(half_diameter)), true);
    const auto location_rms = [](double lift, Life life) {
        return [lift, life](const Analysis& c, const Analysis& m) { return shock_location_rms(c, m, lift, life); };
    };
    for (const auto& [suffix, life] :
         {std::pair{"", Life::formation_to_leaving}, std::pair{"_fully_formed", Life::fully_formed_to_leaving}}) {
        const std::string key = std::string("shock_location_rms") + suffix;
        put(out, key, of_both_shocks(md, continuum.all, location_rms(0.0, life)), true);
        put(out, key + "_half_diameter", of_both_shocks(md, continuum.all, location_rms(half_diameter, life)), true);
    }
    if (continuum.all.profiles.size() != md.all.profiles.size()) return out;
    for (const auto& [name, field] : {std::pair{"density", Field::density}, std::pair{"velocity", Field::velocity},
                                      std::pair{"temperature", Field::temperature}}) {
        for (const auto& [suffix, lift] : {std::pair{"", 0.0}, std::pair{"_half_diameter", half_diameter}}) {
            const auto rms = [of = field, up = lift](const Analysis& c, const Analysis& m) {
                return profile_rms(c, m, of, up);
            };
            put(out, std::string(name) + "_rms" + suffix, of_both(md, continuum.all, rms), true);
        }
    }
    return out;
}

}  // namespace shaken::compare
