// SPDX-License-Identifier: MIT
// Every key as text, whatever its type: what printing, listing and comparing scenes have in common.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/parameters.hpp"

namespace shaken::scene {

/// A key as shown to a TextVisitor.
struct KeyText {
    std::string section;
    About about;
    std::string owner;                 // the engine that alone acts on it; empty: no engine alone
    std::optional<std::string> value;  // as TOML; none where none is given
    std::string allowed;               // "[0, 1]"; empty where the words say it
    std::vector<Name> names;           // of a key that is chosen by name

    std::string full() const { return section + "." + std::string(about.key); }
};

class TextVisitor : public ParameterVisitor {
  public:
    virtual void key(const KeyText& key) = 0;

    void owner(std::string_view engine) override { owner_ = engine; }
    void section(std::string_view name, std::string_view words) override;
    void number(const About& a, double& value, const Range& r) override;
    void optional_number(const About& a, std::optional<double>& value, const Range& r) override;
    void whole(const About& a, std::int64_t& value, const Range& r) override;
    void optional_whole(const About& a, std::optional<std::int64_t>& value, const Range& r) override;
    void seed(const About& a, std::uint64_t& value) override;
    void text(const About& a, std::string& value) override;
    void choice(const About& a, Choice& value, const std::vector<Name>& names) override;
    void kind(const About& a, Kind& value) override;
    void restitution(const About& a, Restitution& value) override;
    void friction(const About& a, Friction& value) override;
    void remedy(const About& a, CollapseRemedy& value) override;

  private:
    void say(const About& a, std::optional<std::string> value, std::string allowed, std::vector<Name> names = {});
    std::string section_, owner_;
};

/// All keys of a scene, in the order of the file.
std::vector<KeyText> keys_of(const Scene& scene);

}  // namespace shaken::scene
