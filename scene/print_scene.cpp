// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "scene/parameters.hpp"
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

/// Writes "key = value", with the words of the declaration behind each line when `explain` is set.
class Printer : public ParameterVisitor {
  public:
    Printer(const Scene& scene, bool explain) : without_part_(scene.without_part), explain_(explain) {}
    std::string result;

    void section(std::string_view name, std::string_view words) override {
        section_ = name;
        result +=
            fmt::format("{}[{}]{}\n", result.empty() ? "" : "\n", name, explain_ ? fmt::format("  # {}", words) : "");
    }
    void number(const About& a, double& value, const Range& r) override { line(a, written_number(value), r.text()); }
    void optional_number(const About& a, std::optional<double>& value, const Range& r) override {
        if (value)
            line(a, written_number(*value), r.text());
        else
            absent(a, r.text());
    }
    void whole(const About& a, std::int64_t& value, const Range& r) override {
        line(a, fmt::format("{}", value), "whole, " + r.text());
    }
    void optional_whole(const About& a, std::optional<std::int64_t>& value, const Range& r) override {
        if (value)
            line(a, fmt::format("{}", *value), "whole, " + r.text());
        else
            absent(a, "whole, " + r.text());
    }
    void seed(const About& a, std::uint64_t& value) override { line(a, fmt::format("{}", value), "whole, at least 0"); }
    void text(const About& a, std::string& value) override { line(a, toml_text(value), "text"); }
    void choice(const About& a, Choice& value) override { line(a, toml_text(value.name), "a name"); }
    void kind(const About& a, Kind& value) override {
        line(a, toml_text(kind_names()[static_cast<std::size_t>(value)]),
             fmt::format("one of {}", fmt::join(kind_names(), ", ")));
    }
    void restitution(const About& a, Restitution& value) override { line(a, toml_restitution(value), ""); }
    void friction(const About& a, Friction& value) override { line(a, toml_friction(value), ""); }
    void remedy(const About& a, CollapseRemedy& value) override {
        line(a, toml_text(collapse_remedy_names()[static_cast<std::size_t>(value)]), "");
    }

  private:
    void line(const About& a, const std::string& value, const std::string& allowed) {
        if (without_part_.contains(fmt::format("{}.{}", section_, a.key))) return;
        result += fmt::format("{} = {}{}\n", a.key, value, explanation(a, allowed));
    }
    void absent(const About& a, const std::string& allowed) {
        if (explain_) result += fmt::format("# {} ={}\n", a.key, explanation(a, allowed));
    }
    std::string explanation(const About& a, const std::string& allowed) const {
        if (!explain_) return "";
        std::string words = fmt::format("  # {}", a.words);
        if (!a.unit.empty()) words += fmt::format("; in {}", a.unit);
        if (!allowed.empty()) words += fmt::format("; {}", allowed);
        return words;
    }

    const std::set<std::string>& without_part_;
    bool explain_;
    std::string section_;
};

}  // namespace

std::string print_scene(const Scene& scene) {
    Scene copy = scene;
    Printer printer(scene, false);
    describe(copy, printer);
    return printer.result;
}

std::string list_parameters() {
    Scene defaults;
    Printer printer(defaults, true);
    describe(defaults, printer);
    return printer.result;
}

}  // namespace shaken::scene
