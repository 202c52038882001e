// SPDX-License-Identifier: MIT
#include "scene/read_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "scene/errors.hpp"
#include "scene/parameters.hpp"
#include "scene/resolve.hpp"

namespace shaken::scene {

namespace {

/// Texts that values came from, by source name, so that a message can show the line.
using Sources = std::map<std::string, std::string>;

Place place_of(const toml::source_region& region, const Sources& sources) {
    Place place;
    place.source = region.path ? *region.path : std::string();
    place.line = static_cast<int>(region.begin.line);
    place.column = static_cast<int>(region.begin.column);
    if (const auto found = sources.find(place.source); found != sources.end()) {
        std::istringstream lines(found->second);
        for (int i = 0; i < place.line && std::getline(lines, place.text); ++i) {
        }
    }
    return place;
}

/// The value as a user would write it.
std::string described(const toml::node& node) {
    if (const auto number = node.value_exact<double>()) return written_number(*number);
    std::ostringstream out;
    node.visit([&](const auto& value) { out << toml::node_view<const toml::node>(&value); });
    return out.str();
}

std::string type_name(const toml::node& node) {
    std::ostringstream out;
    out << node.type();
    return out.str();
}

/// Fills a scene from a table and remembers where each value stood and which keys were asked for.
class Reader : public ParameterVisitor {
  public:
    Reader(const toml::table& table, const Sources& sources) : table_(table), sources_(sources) {}

    std::map<std::string, Place> places;

    void section(std::string_view name, std::string_view) override {
        section_ = name;
        known_[section_];
        // "initial.left" is the section [initial.left], a table inside the table [initial].
        if (const std::size_t dot = name.find('.'); dot != std::string_view::npos) {
            known_[std::string(name.substr(0, dot))];
        }
        keys_ = &table_;
        for (std::size_t from = 0; keys_ && from <= name.size();) {
            const std::size_t dot = std::min(name.find('.', from), name.size());
            const toml::node* node = keys_->get(name.substr(from, dot - from));
            if (node && !node->is_table()) {
                throw SceneError(place(*node),
                                 fmt::format("[{}] must be a section, not {}", name.substr(0, dot), type_name(*node)));
            }
            keys_ = node ? node->as_table() : nullptr;
            from = dot + 1;
        }
    }
    void number(const About& a, double& value, const Range& range) override {
        if (const toml::node* node = find(a)) value = number_in(*node, full(a.key), range);
    }
    void optional_number(const About& a, std::optional<double>& value, const Range& range) override {
        if (const toml::node* node = find(a)) value = number_in(*node, full(a.key), range);
    }
    void whole(const About& a, std::int64_t& value, const Range& range) override {
        if (const toml::node* node = find(a)) value = whole_in(*node, full(a.key), range);
    }
    void optional_whole(const About& a, std::optional<std::int64_t>& value, const Range& range) override {
        if (const toml::node* node = find(a)) value = whole_in(*node, full(a.key), range);
    }
    void seed(const About& a, std::uint64_t& value) override {
        if (const toml::node* node = find(a)) {
            value = static_cast<std::uint64_t>(whole_in(*node, full(a.key), {0.0, 9.2e18}));
        }
    }
    void text(const About& a, std::string& value) override {
        if (const toml::node* node = find(a)) value = text_in(*node, full(a.key));
    }
    void choice(const About& a, Choice& value, const std::vector<Name>&) override {
        const toml::node* node = find(a);
        if (!node) return;
        const auto whole = node->value_exact<std::int64_t>();
        value = {whole ? fmt::format("{}", *whole) : text_in(*node, full(a.key)), place(*node)};
    }
    void kind(const About& a, Kind& value) override {
        const toml::node* node = find(a);
        if (!node) return;
        value = static_cast<Kind>(named(*node, full(a.key), kind_names()));
    }
    void restitution(const About& a, Restitution& value) override {
        const toml::node* node = find(a);
        if (!node) return;
        const toml::table* law = node->as_table();
        if (!law) {
            value = RestitutionConstant{number_in(*node, full(a.key), coefficient)};
            return;
        }
        value = restitution_law(*law, full(a.key), place(*node));
    }
    void friction(const About& a, Friction& value) override {
        const toml::node* node = find(a);
        if (!node) return;
        const std::string name = full(a.key);
        const toml::table* table = node->as_table();
        if (!table) {
            value.law = static_cast<FrictionLaw>(named(*node, name, friction_law_names()));
            if (value.law != FrictionLaw::none)
                throw SceneError(place(*node),
                                 fmt::format("{0} needs its numbers: {0} = {{ law = {1}, beta0 = 0.35, mu = 0.5 }}",
                                             name, described(*node)));
            return;
        }
        static const std::vector<std::string> known{"law", "beta0", "mu"};
        for (const auto& [key, entry] : *table) {
            const std::string word(key.str());
            if (std::find(known.begin(), known.end(), word) == known.end())
                throw SceneError(place_of(key.source(), sources_),
                                 fmt::format("{}.{} is unknown; known: {}", name, word, fmt::join(known, ", ")));
        }
        for (const std::string& word : known)
            if (!table->contains(word))
                throw SceneError(place(*node), fmt::format("{} = {{ ... }} needs {}; known laws: {}", name, word,
                                                           fmt::join(friction_law_names(), ", ")));
        value.law = static_cast<FrictionLaw>(named(*table->get("law"), name + ".law", friction_law_names()));
        value.beta0 = number_in(*table->get("beta0"), name + ".beta0", {-1.0, 1.0});
        value.mu = number_in(*table->get("mu"), name + ".mu", at_least_zero);
    }
    void remedy(const About& a, CollapseRemedy& value) override {
        if (const toml::node* node = find(a))
            value = static_cast<CollapseRemedy>(named(*node, full(a.key), collapse_remedy_names()));
    }

    /// Throws at the first key that no parameter asked for.
    void refuse_unknown_keys() const {
        for (const auto& [section_key, node] : table_) {
            const std::string name(section_key.str());
            const auto known = known_.find(name);
            if (known == known_.end()) throw unknown_section(section_key, name);
            refuse_unknown_keys(*node.as_table(), name);
        }
    }

  private:
    static constexpr Range coefficient{0.0, 1.0};

    void refuse_unknown_keys(const toml::table& section, const std::string& name) const {
        for (const auto& [key, value] : section) {
            const std::string word(key.str()), nested = fmt::format("{}.{}", name, word);
            if (value.is_table() && known_.contains(nested)) {
                refuse_unknown_keys(*value.as_table(), nested);
            } else if (const auto& known = known_.at(name); !known.contains(word)) {
                throw unknown_key(key, name, word, known);
            }
        }
    }

    std::string full(std::string_view key) const { return fmt::format("{}.{}", section_, key); }
    Place place(const toml::node& node) const { return place_of(node.source(), sources_); }

    const toml::node* find(const About& about) {
        known_[section_].insert(std::string(about.key));
        const toml::node* node = keys_ ? keys_->get(about.key) : nullptr;
        if (node) places[full(about.key)] = place(*node);
        return node;
    }
    /// Which of the names is written there.
    std::size_t named(const toml::node& node, const std::string& parameter,
                      const std::vector<std::string>& names) const {
        const Choice name{text_in(node, parameter), place(node)};
        const auto found = std::find(names.begin(), names.end(), name.name);
        if (found == names.end()) throw unknown_choice(parameter, name, names);
        return static_cast<std::size_t>(found - names.begin());
    }
    double number_in(const toml::node& node, const std::string& name, const Range& range) const {
        const auto whole = node.value_exact<std::int64_t>();
        const std::optional<double> value = whole ? static_cast<double>(*whole) : node.value_exact<double>();
        if (!value) {
            throw SceneError(place(node),
                             fmt::format("{} must be a number ({}), not {}", name, range.text(), type_name(node)));
        }
        if (!std::isfinite(*value)) {
            throw SceneError(place(node), fmt::format("{} = {} is not a finite number; allowed: {}", name,
                                                      described(node), range.text()));
        }
        if (!range.contains(*value)) throw outside(node, name, range);
        return *value;
    }
    std::int64_t whole_in(const toml::node& node, const std::string& name, const Range& range) const {
        const auto value = node.value_exact<std::int64_t>();
        if (!value) {
            throw SceneError(place(node), fmt::format("{} must be a whole number ({}), not {}", name, range.text(),
                                                      described(node)));
        }
        if (!range.contains(static_cast<double>(*value))) throw outside(node, name, range);
        return *value;
    }
    std::string text_in(const toml::node& node, const std::string& name) const {
        const auto value = node.value_exact<std::string>();
        if (!value)
            throw SceneError(place(node), fmt::format("{} must be a text in quotes, not {}", name, described(node)));
        return *value;
    }
    SceneError outside(const toml::node& node, const std::string& name, const Range& range) const {
        const bool interval = range.lower > -unbounded && range.upper < unbounded;
        return SceneError(place(node), fmt::format("{} = {} {} {}", name, described(node),
                                                   interval ? "is outside" : "must be", range.text()));
    }
    Restitution restitution_law(const toml::table& table, const std::string& name, const Place& where) const {
        static const std::vector<std::string> known{"law", "e0", "v0"};
        for (const auto& [key, value] : table) {
            const std::string word(key.str());
            if (std::find(known.begin(), known.end(), word) == known.end()) {
                throw SceneError(place_of(key.source(), sources_),
                                 fmt::format("{}.{} is unknown; known: {}", name, word, fmt::join(known, ", ")));
            }
        }
        const toml::node* law = table.get("law");
        if (!law)
            throw SceneError(where, fmt::format("{} = {{ ... }} needs law; known: {}", name,
                                                fmt::join(restitution_law_names(), ", ")));
        const Choice chosen{text_in(*law, name + ".law"), place(*law)};
        const auto& laws = restitution_law_names();
        if (std::find(laws.begin(), laws.end(), chosen.name) == laws.end()) {
            throw unknown_choice(name + ".law", chosen, laws);
        }
        const toml::node* e0 = table.get("e0");
        const toml::node* v0 = table.get("v0");
        if (!e0) throw SceneError(where, fmt::format("{} = {{ law = \"{}\" }} needs e0 in [0, 1]", name, chosen.name));
        const double coefficient_fast = number_in(*e0, name + ".e0", coefficient);
        if (chosen.name == "constant") {
            if (v0) throw SceneError(place(*v0), fmt::format("{}.v0 belongs to the law \"velocity\"", name));
            return RestitutionConstant{coefficient_fast};
        }
        if (chosen.name == "velocity") {
            return RestitutionVelocity{coefficient_fast, v0 ? number_in(*v0, name + ".v0", positive) : 1.0};
        }
        throw unknown_choice(name + ".law", chosen, restitution_law_names());
    }
    SceneError unknown_section(const toml::key& key, const std::string& name) const {
        std::vector<std::string> names;
        for (const auto& [section, keys] : known_) names.push_back(section);
        std::string message = fmt::format("[{}] is unknown; known sections: {}", name, fmt::join(names, ", "));
        if (const std::string near = nearest_word(name, names); !near.empty())
            message += fmt::format("; did you mean [{}]?", near);
        return SceneError(place_of(key.source(), sources_), message);
    }
    SceneError unknown_key(const toml::key& key, const std::string& section, const std::string& word,
                           const std::set<std::string>& known) const {
        const std::vector<std::string> names(known.begin(), known.end());
        std::string message =
            fmt::format("{}.{} is unknown; known in [{}]: {}", section, word, section, fmt::join(names, ", "));
        std::string near = nearest_word(word, names);
        for (const auto& [other, keys] : known_) {
            if (keys.contains(word)) near = other + "." + word;
        }
        if (!near.empty()) message += fmt::format("; did you mean {}?", near);
        return SceneError(place_of(key.source(), sources_), message);
    }

    const toml::table& table_;
    const Sources& sources_;
    std::string section_;
    const toml::table* keys_ = nullptr;
    std::map<std::string, std::set<std::string>> known_;
};

/// The parser recurses along dotted keys; no scene needs lines that would exhaust its stack.
void refuse_long_lines(const std::string& text, const std::string& source) {
    constexpr std::size_t longest = 10000;  // characters
    std::size_t start = 0;
    for (int line = 1; start < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        if (end - start > longest) {
            throw SceneError({source, line, 1, text.substr(start, 100)},
                             fmt::format("the line has {} characters; at most {} are allowed", end - start, longest));
        }
        start = end + 1;
    }
}

toml::table parse_toml(const std::string& text, const std::string& source, const Sources& sources) {
    refuse_long_lines(text, source);
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        throw SceneError(place_of(error.source(), sources), std::string(error.description()));
    }
}

void merge(toml::table& into, toml::table&& from) {
    for (auto&& [key, node] : from) {
        toml::table* existing = into.contains(key.str()) ? into.get(key.str())->as_table() : nullptr;
        if (existing && node.is_table())
            merge(*existing, std::move(*node.as_table()));
        else
            into.insert_or_assign(key, std::move(node));
    }
}

/// "section.key=value" as a line of TOML; a value that is no TOML literal is taken as a text, so that
/// --set continuum.flux=hll needs no quotes inside the shell's.
toml::table parse_override(const std::string& written, Sources& sources) {
    const std::size_t equals = written.find('=');
    const std::string source = fmt::format("--set {}", written);  // each override is a source of its own
    if (equals == std::string::npos || equals == 0 || written.substr(0, equals).find('.') == std::string::npos) {
        throw SceneError(Place{source, 0, 0, ""}, "is not of the form section.key=value");
    }
    const std::string key = written.substr(0, equals), value = written.substr(equals + 1);
    const std::string line = fmt::format("{} = {}", key, value);
    sources[source] = line;
    try {
        return toml::parse(line, source);
    } catch (const toml::parse_error&) {
        const std::string quoted = fmt::format("{} = \"{}\"", key, value);
        sources[source] = quoted;
        return parse_toml(quoted, source, sources);
    }
}

/// An override of one member of an exclusive pair takes the place of the file's other member.
void drop_rivals(toml::table& table, const toml::table& override_table) {
    static constexpr std::string_view pairs[][2] = {{"particles.number", "particles.depth"},
                                                    {"particles.number", "box.side"},
                                                    {"plate.frequency", "plate.frequency_star"}};
    const auto drop = [&](std::string_view given, std::string_view rival) {
        const std::size_t dot = rival.find('.');
        toml::node* section = table.get(rival.substr(0, dot));
        if (override_table.at_path(given) && section && section->is_table())
            section->as_table()->erase(rival.substr(dot + 1));
    };
    for (const auto& [one, other] : pairs) {
        drop(one, other);
        drop(other, one);
    }
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& source, const KeyOwners& owners,
                  const std::vector<std::string>& overrides) {
    Sources sources{{source, text}};
    toml::table table = parse_toml(text, source, sources);
    std::vector<toml::table> given;
    for (const std::string& written : overrides) {
        given.push_back(parse_override(written, sources));
    }
    for (const toml::table& t : given) drop_rivals(table, t);
    for (toml::table& t : given) merge(table, std::move(t));

    Scene scene;
    scene.owners = owners;
    scene.source = source;
    Reader reader(table, sources);
    describe(scene, reader);
    if (owners.all) reader.refuse_unknown_keys();
    if (scene.name.empty()) scene.name = std::filesystem::path(source).stem().string();
    scene.written = reader.places;
    resolve(scene);
    return scene;
}

Scene read_scene(const std::filesystem::path& path, const KeyOwners& owners,
                 const std::vector<std::string>& overrides) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw NoSceneFile(fmt::format("{}: {}", path.string(), error ? error.message() : "is not a file"));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw NoSceneFile(fmt::format("{}: {}", path.string(), std::strerror(errno)));
    std::ostringstream text;
    text << file.rdbuf();
    return parse_scene(text.str(), path.string(), owners, overrides);
}

}  // namespace shaken::scene
