// SPDX-License-Identifier: MIT
#include "compare/shock_history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shaken::compare {

namespace {

constexpr double longest_gap = 0.01;   // of a cycle
constexpr double shortest_run = 0.03;  // of a cycle
// A location moves by noise, up to the window of the slopes (sigma), and at a speed that nothing in a shaken layer
// exceeds: twice that of the shock of elastic spheres at Gamma 3 (sqrt(g sigma)).
constexpr double furthest_by_noise = 2.0;
constexpr double fastest = 40.0;

struct Run {
    std::int64_t first = 0, last = 0;
    std::int64_t length() const { return last - first + 1; }
};

/// Slope of the line of least squares through points (x, y).
class Slope {
  public:
    void add(double x, double y) {
        count_ += 1.0;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    void clear() { *this = Slope{}; }
    double value() const { return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_); }

  private:
    double count_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

/// The longest circular run of true values that begins in [from, to), gaps up to `gap` bridged; empty where there is
/// none. Where that is not the whole round, a run that comes in from before is not counted.
std::optional<Run> longest_run(const std::vector<bool>& is_set, std::int64_t gap, std::int64_t from, std::int64_t to) {
    const auto count = static_cast<std::int64_t>(is_set.size());
    const auto at = [&](std::int64_t i) { return is_set[static_cast<std::size_t>((i + count) % count)]; };
    const auto comes_in = [&](std::int64_t start) {
        for (std::int64_t before = start - gap - 1; before < start; ++before)
            if (at(before)) return true;
        return false;
    };
    std::optional<Run> best;
    for (std::int64_t start = from; start < to; ++start) {
        if (!at(start) || (to - from < count && comes_in(start))) continue;
        Run run{start, start};
        for (std::int64_t i = start + 1; i < start + count && i - run.last <= gap + 1; ++i) {
            if (at(i)) run.last = i;
        }
        if (!best || run.length() > best->length()) best = run;
    }
    return best;
}

}  // namespace

PhaseMeasures measure_phase(const fields::Profile& profile, const Medium& medium, const ShockCriteria& criteria) {
    PhaseMeasures measures;
    measures.phase = profile.phase;
    measures.layer = find_layer(profile);
    if (!measures.layer) return measures;
    const std::vector<double> mach = mach_numbers(profile, medium);
    measures.maximum_mach = maximum_mach(profile, mach, *measures.layer);
    measures.shock = find_shock(profile, *measures.layer, mach, medium, criteria);
    return measures;
}

std::optional<ShockHistory> follow_shock(const std::vector<PhaseMeasures>& phases, double frequency,
                                         std::int64_t cycles, std::int64_t in_cycle) {
    const auto count = static_cast<std::int64_t>(phases.size()), a_cycle = count / cycles;
    const double step = 1.0 / static_cast<double>(a_cycle);
    const auto gap = static_cast<std::int64_t>(std::floor(longest_gap * static_cast<double>(a_cycle)));
    const auto at = [&](std::int64_t i) -> const PhaseMeasures& {
        return phases[static_cast<std::size_t>(((i % count) + count) % count)];
    };

    std::vector<bool> inside(phases.size());
    std::transform(phases.begin(), phases.end(), inside.begin(),
                   [](const PhaseMeasures& m) { return m.shock && m.shock->inside_layer; });
    std::optional<Run> run = longest_run(inside, gap, in_cycle * a_cycle, (in_cycle + 1) * a_cycle);
    const auto is_inside = [&](std::int64_t i) { return at(i).shock && at(i).shock->inside_layer; };
    while (run && run->length() > 1 && !is_inside(run->first + 1)) {
        do ++run->first;
        while (!is_inside(run->first));
    }
    if (!run || static_cast<double>(run->length()) < shortest_run * static_cast<double>(a_cycle)) return std::nullopt;

    ShockHistory history;
    history.first = run->first;
    history.formation_phase = at(run->first).phase;
    history.formation_location = at(run->first).shock->location;
    history.approach_mach = at(run->first - 1).maximum_mach.value;
    history.leaving_phase = history.leaving_location = history.mean_speed = std::nan("");
    history.fully_formed_phase = history.fully_formed_speed = history.fitted_speed = std::nan("");

    const auto reaches = [&](std::int64_t from, std::int64_t to) {
        const double farthest = furthest_by_noise + fastest * static_cast<double>(to - from) * step / frequency;
        return std::abs(at(to).shock->location - at(from).shock->location) <= farthest;
    };
    const auto is_noise = [&](std::int64_t i, std::int64_t last_followed) {
        if (reaches(last_followed, i)) return false;
        for (std::int64_t later = i + 1; later - last_followed <= gap + 1; ++later)
            if (at(later).shock && reaches(last_followed, later)) return true;
        return false;
    };
    Slope slope;
    double excess_before = std::nan(""), fully_formed_location = std::nan("");
    std::int64_t before = run->first;
    history.last = run->first;
    for (std::int64_t i = run->first; i < run->first + count && i - before <= gap + 1; ++i) {
        if (!at(i).shock || !at(i).layer) continue;
        const Shock& shock = *at(i).shock;
        if (i > run->first && is_noise(i, before)) {
            history.passed_over.push_back(i % count);
            continue;
        }
        const double excess = shock.location - at(i).layer->upper;
        const double phase = history.formation_phase + static_cast<double>(i - run->first) * step;
        if (excess >= 0.0) {
            const double phase_before = history.formation_phase + static_cast<double>(before - run->first) * step;
            const double share = excess_before / (excess_before - excess);
            const double location_before = at(before).shock->location;
            history.leaving_phase = phase_before + share * (phase - phase_before);
            history.leaving_location = location_before + share * (shock.location - location_before);
            const auto speed_from = [&](double location, double since) {
                return (history.leaving_location - location) * frequency / (history.leaving_phase - since);
            };
            history.mean_speed = speed_from(history.formation_location, history.formation_phase);
            history.fully_formed_speed = speed_from(fully_formed_location, history.fully_formed_phase);
            if (!std::isnan(history.fully_formed_phase)) history.fitted_speed = slope.value() * frequency;
            break;
        }
        const bool has_left_plate = shock.top - at(i).layer->lower > shock.location - shock.top;
        if (has_left_plate)
            slope.add(phase - history.formation_phase, shock.location);
        else
            slope.clear();
        if (!has_left_plate) {
            history.fully_formed_phase = std::nan("");
        } else if (std::isnan(history.fully_formed_phase)) {
            history.fully_formed_phase = phase;
            history.first_fully_formed = i;
            fully_formed_location = shock.location;
        }
        excess_before = excess;
        before = i;
        history.last = i;
    }
    return history;
}

}  // namespace shaken::compare
