// SPDX-License-Identifier: MIT
#include "scene/text_visitor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/read_scene.hpp"

namespace shaken::scene {

std::string written_number(double value) {
    const std::string digits = fmt::format("{}", value);
    return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
}

namespace {

std::string toml_text(const std::string& value) {
    std::string quoted = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

std::string toml_restitution(const Restitution& law) {
    if (const auto* constant = std::get_if<RestitutionConstant>(&law)) return written_number(constant->e0);
    const auto& velocity = std::get<RestitutionVelocity>(law);
    return fmt::format("{{ law = \"velocity\", e0 = {}, v0 = {} }}", written_number(velocity.e0),
                       written_number(velocity.v0));
}

std::string toml_friction(const Friction& friction) {
    const std::string law = toml_text(friction_law_names()[static_cast<std::size_t>(friction.law)]);
    if (friction.law == FrictionLaw::none) return law;
    return fmt::format("{{ law = {}, beta0 = {}, mu = {} }}", law, written_number(friction.beta0),
                       written_number(friction.mu));
}

std::string one_of(const std::vector<std::string>& names) { return fmt::format("one of {}", fmt::join(names, ", ")); }

}  // namespace

void TextVisitor::say(const About& a, std::optional<std::string> value, std::string allowed, std::vector<Name> names) {
    key({section_, a, owner_, std::move(value), std::move(allowed), std::move(names)});
}

void TextVisitor::section(std::string_view name, std::string_view) { section_ = name; }
void TextVisitor::number(const About& a, double& value, const Range& r) { say(a, written_number(value), r.text()); }
void TextVisitor::optional_number(const About& a, std::optional<double>& value, const Range& r) {
    say(a, value ? std::optional(written_number(*value)) : std::nullopt, r.text());
}
void TextVisitor::whole(const About& a, std::int64_t& value, const Range& r) {
    say(a, fmt::format("{}", value), "whole, " + r.text());
}
void TextVisitor::optional_whole(const About& a, std::optional<std::int64_t>& value, const Range& r) {
    say(a, value ? std::optional(fmt::format("{}", *value)) : std::nullopt, "whole, " + r.text());
}
void TextVisitor::seed(const About& a, std::uint64_t& value) { say(a, fmt::format("{}", value), "whole, at least 0"); }
void TextVisitor::text(const About& a, std::string& value) { say(a, toml_text(value), "text"); }
void TextVisitor::choice(const About& a, Choice& value, const std::vector<Name>& names) {
    std::vector<std::string> known;
    for (const Name& name : names) known.push_back(name.name);
    say(a, toml_text(value.name), one_of(known), names);
}
void TextVisitor::kind(const About& a, Kind& value) {
    say(a, toml_text(kind_names()[static_cast<std::size_t>(value)]), one_of(kind_names()));
}
void TextVisitor::restitution(const About& a, Restitution& value) { say(a, toml_restitution(value), ""); }
void TextVisitor::friction(const About& a, Friction& value) { say(a, toml_friction(value), ""); }
void TextVisitor::remedy(const About& a, CollapseRemedy& value) {
    say(a, toml_text(collapse_remedy_names()[static_cast<std::size_t>(value)]), one_of(collapse_remedy_names()));
}

std::vector<KeyText> keys_of(const Scene& scene) {
    struct Collector : TextVisitor {
        std::vector<KeyText> all;
        void key(const KeyText& key) override { all.push_back(key); }
    } collector;
    Scene copy = scene;
    describe(copy, collector);
    return collector.all;
}

}  // namespace shaken::scene
