// SPDX-License-Identifier: MIT
// How the cycles of both engines are averaged and laid out beside each other, and what is to be said of it. A layer of
// period two (fields/period.hpp) has two flows, averaged apart and shown over 0 <= ft < 2; were they averaged together,
// T would hold the difference of their velocities.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shaken::compare {

struct Layout {
    std::optional<int> period = {};  // in cycles: 1, 2 or 4; absent: too few to tell, or not asked
    bool apart = false;              // the first and the second cycle of a period of two are averaged apart
    std::int64_t cycles = 1;         // on the axis of phases; a cycle that is not apart is repeated
};

/// What was found of an engine's runs.
struct Periods {
    std::vector<std::optional<int>> of_runs;
    bool keeps_flows_apart = true;  // false: the files hold sums over all cycles only
    double opposite_share = 0.0;    // of the area, where there are height maps

    /// The longest that a run has; absent where no run is long enough to tell.
    std::optional<int> longest() const;
};

struct Layouts {
    Layout md, continuum;
};
/// Both over two cycles where either is averaged apart.
Layouts layouts_of(const Periods& md, const Periods& continuum);

/// Sentences on an engine ("The MD"), none for a period of one cycle beside one of one.
std::vector<std::string> notes_of_period(const std::string& engine, const Periods& found, const Layout& layout);

/// "2 cycles", or that there are too few to tell.
std::string in_words(const std::optional<int>& period);

}  // namespace shaken::compare
