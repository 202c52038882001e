// SPDX-License-Identifier: MIT
#include "scene/errors.hpp"

#include <fmt/format.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace shaken::scene {

namespace {

/// What a terminal may be shown of a line: printable, and no longer than one.
std::string excerpt(const std::string& line) {
    constexpr std::size_t longest = 160;  // characters
    std::string shown = line.substr(0, longest);
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = c == '\t' ? ' ' : '?';
    }
    return line.size() > longest ? shown + " ..." : shown;
}

std::string pointing_at(const Place& place, const std::string& message) {
    if (place.source.empty()) return message;
    std::string text = place.line > 0 ? fmt::format("{}:{}:{}: {}", place.source, place.line, place.column, message)
                                      : fmt::format("{}: {}", place.source, message);
    if (!place.text.empty()) {
        text += fmt::format("\n{:>6} | {}", place.line, excerpt(place.text));
        if (place.column <= 160) text += fmt::format("\n       | {:>{}}", '^', std::max(1, place.column));
    }
    return text;
}

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> two_rows_up(b.size() + 1), row_up(b.size() + 1), row(b.size() + 1);
    std::iota(row_up.begin(), row_up.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({row_up[j] + 1, row[j - 1] + 1, row_up[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], two_rows_up[j - 2] + 1);
            }
        }
        std::swap(two_rows_up, row_up);
        std::swap(row_up, row);
    }
    return row_up[b.size()];
}

}  // namespace

SceneError::SceneError(const Place& where, const std::string& message)
    : std::runtime_error(pointing_at(where, message)), place(where) {}

SceneError refusal(const Scene& scene, const std::string& key, const std::string& message) {
    const auto written = scene.written.find(key);
    return {written == scene.written.end() ? Place{scene.source, 0, 0, ""} : written->second, message};
}

std::string nearest_word(const std::string& written, const std::vector<std::string>& known) {
    // The start of one word is more than a slip of the pen.
    if (written.size() > 2)
        for (const std::string& word : known)
            if (word.starts_with(written)) return word;
    std::string best;
    std::size_t least = std::max<std::size_t>(1, written.size() / 2);
    for (const std::string& word : known) {
        const std::size_t distance = edit_distance(written, word);
        if (distance <= least && (best.empty() || distance < least)) {
            least = distance;
            best = word;
        }
    }
    return best;
}

SceneError unknown_choice(const std::string& parameter, const Choice& choice, const std::vector<std::string>& known) {
    std::string message =
        fmt::format("{} = \"{}\" is unknown; known: {}", parameter, choice.name, fmt::join(known, ", "));
    const std::string near = nearest_word(choice.name, known);
    if (!near.empty()) message += fmt::format("; did you mean \"{}\"?", near);
    return SceneError(choice.place, message);
}

}  // namespace shaken::scene
