// SPDX-License-Identifier: MIT
#include "compare/layout.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shaken::compare {

namespace {

bool is_doubled(const std::optional<int>& period) { return period.value_or(1) > 1; }

// Of the area: less is some bins that swing for reasons of their own.
constexpr double worth_saying = 0.01;

}  // namespace

std::optional<int> Periods::longest() const {
    std::optional<int> longest;
    for (const std::optional<int>& period : of_runs) longest = std::max(longest, period);
    return longest;
}

Layouts layouts_of(const Periods& md, const Periods& continuum) {
    const auto layout = [](const Periods& found) {
        return Layout{found.longest(), is_doubled(found.longest()) && found.keeps_flows_apart, 1};
    };
    Layouts both{layout(md), layout(continuum)};
    if (both.md.apart || both.continuum.apart) both.md.cycles = both.continuum.cycles = 2;
    return both;
}

std::vector<std::string> notes_of_period(const std::string& engine, const Periods& found, const Layout& layout) {
    std::vector<std::string> notes;
    if (layout.apart)
        notes.push_back(
            fmt::format("{} has a period of {}: even and odd cycles are averaged apart, and the one with the higher "
                        "centre of mass comes first (0 <= ft < 1).",
                        engine, in_words(layout.period)));
    else if (is_doubled(layout.period))
        notes.push_back(
            fmt::format("{} has a period of {}, and the average mixes its flows: the file keeps sums over all cycles "
                        "only, an earlier version wrote it. T and the errors hold their difference; run it again.",
                        engine, in_words(layout.period)));
    if (layout.period == 4)
        notes.push_back(
            fmt::format("{}: each of the two averages mixes two flows, and T and the errors hold their "
                        "difference.",
                        engine));
    const auto doubled = std::count_if(found.of_runs.begin(), found.of_runs.end(), is_doubled);
    if (doubled > 0 && doubled < static_cast<std::ptrdiff_t>(found.of_runs.size()))
        notes.push_back(
            fmt::format("{}: {} of {} runs alternate from cycle to cycle.", engine, doubled, found.of_runs.size()));
    if (layout.cycles > 1 && !layout.apart)
        notes.push_back(
            fmt::format("{} is averaged over all its cycles (period: {}), and shown twice beside the two "
                        "cycles of the other engine.",
                        engine, in_words(layout.period)));
    if (found.opposite_share >= worth_saying)
        notes.push_back(
            fmt::format("{}: {:.2g} % of the area alternates opposite to the rest, in other regions of the layer or in "
                        "the crests of waves; averages over the area mix both.",
                        engine, 100.0 * found.opposite_share));
    return notes;
}

std::string in_words(const std::optional<int>& period) {
    if (!period) return "too few cycles to tell";
    return *period == 1 ? "1 cycle" : fmt::format("{} cycles", *period);
}

}  // namespace shaken::compare
