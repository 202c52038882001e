// SPDX-License-Identifier: MIT
#include "scene/key_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "scene/text_visitor.hpp"

namespace shaken::scene {

namespace {

/// A key as several kinds of scene have it.
struct Entry {
    KeyText key;
    std::vector<std::string> kinds;

    bool is(const KeyText& other) const {
        return key.full() == other.full() && key.about.words == other.about.words && key.value == other.value &&
               key.allowed == other.allowed;
    }
};

std::vector<Entry> every_key(const KeyOwners& owners) {
    std::vector<Entry> all;
    for (std::size_t k = 0; k < kind_names().size(); ++k) {
        Scene defaults;
        defaults.kind = static_cast<Kind>(k);
        defaults.owners = owners;
        for (KeyText key : keys_of(defaults)) {
            if (key.full() == "scene.kind") key.value.reset();
            const auto same = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.is(key); });
            if (same != all.end())
                same->kinds.push_back(kind_names()[k]);
            else
                all.push_back({key, {kind_names()[k]}});
        }
    }
    return all;
}

/// The lists of names, each with the keys that are chosen from it.
std::vector<std::pair<std::vector<std::string>, std::vector<Name>>> lists_of_names(const std::vector<Entry>& entries) {
    std::vector<std::pair<std::vector<std::string>, std::vector<Name>>> lists;
    for (const Entry& entry : entries) {
        if (entry.key.names.empty()) continue;
        const auto same = [&](const auto& list) {
            return std::equal(list.second.begin(), list.second.end(), entry.key.names.begin(), entry.key.names.end(),
                              [](const Name& a, const Name& b) { return a.name == b.name; });
        };
        const auto known = std::find_if(lists.begin(), lists.end(), same);
        if (known == lists.end())
            lists.push_back({{entry.key.full()}, entry.key.names});
        else if (std::find(known->first.begin(), known->first.end(), entry.key.full()) == known->first.end())
            known->first.push_back(entry.key.full());
    }
    return lists;
}

std::string words_of(const Name& name) {
    return name.reference.empty() ? name.words : fmt::format("{} ({})", name.words, name.reference);
}

/// Of text within a cell of a table.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += c == '|' ? "\\|" : std::string(1, c);
    return safe;
}

constexpr const char* head = R"(# The keys of a scene

Made by `shaken scene --keys --markdown`; a test holds it to that. `shaken scene --keys` prints the same as a commented scene of each kind.

Units: sphere diameter sigma, sphere mass m and gravity g are 1; no unit: a number without one. A key with an engine is owned by it: it alone acts on it, and runs of
the two engines that are compared may differ in it. They may also differ in the start, the length and the label; a part marked method changes speed and round-off only. "-": no default.
)";

const char* name_of(Part part) {
    switch (part) {
        case Part::start:
            return "start";
        case Part::length:
            return "length";
        case Part::method:
            return "method";
        case Part::label:
            return "label";
        case Part::experiment:
            break;
    }
    return "";
}

}  // namespace

std::string key_reference(const KeyOwners& owners) {
    const std::vector<Entry> entries = every_key(owners);
    std::vector<std::string> sections;
    for (const Entry& entry : entries)
        if (std::find(sections.begin(), sections.end(), entry.key.section) == sections.end())
            sections.push_back(entry.key.section);
    std::string text = head;
    for (const std::string& section : sections) {
        text += fmt::format(
            "\n## [{}]\n\n| key | unit | allowed | default | kinds | engine | part | meaning |\n"
            "|---|---|---|---|---|---|---|---|\n",
            section);
        for (const Entry& entry : entries) {
            if (entry.key.section != section) continue;
            const bool everywhere = entry.kinds.size() == kind_names().size();
            text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", entry.key.about.key,
                                entry.key.about.unit, cell(entry.key.allowed),
                                entry.key.value ? fmt::format("`{}`", cell(*entry.key.value)) : "-",
                                everywhere ? "all" : fmt::format("{}", fmt::join(entry.kinds, ", ")), entry.key.owner,
                                name_of(entry.key.about.part), cell(std::string(entry.key.about.words)));
        }
    }
    text += "\n## Names\n";
    for (const auto& [keys, names] : lists_of_names(entries)) {
        text += fmt::format("\n`{}`\n\n| name | what |\n|---|---|\n", fmt::join(keys, "`, `"));
        for (const Name& name : names) text += fmt::format("| `{}` | {} |\n", name.name, cell(words_of(name)));
    }
    return text;
}

std::string list_names(const KeyOwners& owners) {
    std::string text;
    for (const auto& [keys, names] : lists_of_names(every_key(owners))) {
        text += fmt::format("# {}\n", fmt::join(keys, ", "));
        for (const Name& name : names) text += fmt::format("#   {:<24} {}\n", name.name, words_of(name));
    }
    return text;
}

}  // namespace shaken::scene
