// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "scene/read_scene.hpp"
#include "scene/text_visitor.hpp"

namespace shaken::scene {

namespace {

/// Writes "key = value", with the words of the declaration behind each line when `explain` is set.
class Printer : public TextVisitor {
  public:
    Printer(const Scene& scene, bool explain) : without_part_(scene.without_part), explain_(explain) {}
    std::string result;

    void section(std::string_view name, std::string_view words) override {
        TextVisitor::section(name, words);
        result +=
            fmt::format("{}[{}]{}\n", result.empty() ? "" : "\n", name, explain_ ? fmt::format("  # {}", words) : "");
    }
    void key(const KeyText& key) override {
        if (without_part_.contains(key.full())) return;
        if (key.value) result += fmt::format("{} = {}{}\n", key.about.key, *key.value, explanation(key));
        if (!key.value && explain_) result += fmt::format("# {} ={}\n", key.about.key, explanation(key));
    }

  private:
    std::string explanation(const KeyText& key) const {
        if (!explain_) return "";
        std::string words = fmt::format("  # {}", key.about.words);
        if (!key.about.unit.empty()) words += fmt::format("; in {}", key.about.unit);
        if (!key.allowed.empty()) words += fmt::format("; {}", key.allowed);
        if (!key.owner.empty() && key.section != key.owner) words += fmt::format(" ({})", key.owner);
        return words;
    }

    const std::set<std::string>& without_part_;
    bool explain_;
};

}  // namespace

std::string print_scene(const Scene& scene) {
    Scene copy = scene;
    Printer printer(scene, false);
    describe(copy, printer);
    return printer.result;
}

std::string list_parameters(Kind kind, const KeyOwners& owners) {
    Scene defaults;
    defaults.kind = kind;
    defaults.owners = owners;
    Printer printer(defaults, true);
    describe(defaults, printer);
    return printer.result;
}

}  // namespace shaken::scene
