// SPDX-License-Identifier: MIT
// Every parameter of a scene, declared once: name, type, unit, allowed range, default, words. The same declaration
// reads the scene file and --set, words the error messages, prints the resolved scene and the list of keys.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace shaken::scene {

/// An interval of numbers; `open_lower` excludes the lower end. The upper end is included unless infinite.
struct Range {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool open_lower = false;

    bool contains(double value) const { return (open_lower ? value > lower : value >= lower) && value <= upper; }
    std::string text() const;  // "[0, 1]", "greater than 0"
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, unbounded, true};
/// Of a frequency: a cycle of more than a million units of time has a clock that is too coarse for contacts.
inline constexpr Range not_at_rest{1e-6, unbounded};
inline constexpr Range at_least_zero{0.0, unbounded, false};
inline constexpr Range fractions{0.0, 1.0};
inline constexpr Range widths{2.0, 1e6};

/// What a key shapes, which decides between which runs it may differ.
enum class Part {
    experiment,  // what is simulated, and how it is measured
    start,       // where a run starts from: what a layer forgets
    length,      // how long it runs, and what it keeps of that
    method,      // how it is computed: speed and round-off, never the statistics
    label,       // what it is called
};

/// What is said of a parameter besides its value.
struct About {
    std::string_view key;
    std::string_view unit;  // empty: dimensionless
    std::string_view words;
    Part part = Part::experiment;
};

/// One of the names that a key may have.
struct Name {
    std::string name, words;
    std::string reference;  // empty where the words say all
};

/// Visits the parameters of a scene in the order of the file. Not for hot code.
class ParameterVisitor {
  public:
    virtual ~ParameterVisitor() = default;
    /// The engine whose keys follow; empty: keys of no engine alone.
    virtual void owner(std::string_view /*engine*/) {}
    virtual void section(std::string_view name, std::string_view words) = 0;
    virtual void number(const About&, double& value, const Range&) = 0;
    virtual void optional_number(const About&, std::optional<double>& value, const Range&) = 0;
    virtual void whole(const About&, std::int64_t& value, const Range&) = 0;
    virtual void optional_whole(const About&, std::optional<std::int64_t>& value, const Range&) = 0;
    virtual void seed(const About&, std::uint64_t& value) = 0;
    virtual void text(const About&, std::string& value) = 0;
    virtual void choice(const About&, Choice& value, const std::vector<Name>& names) = 0;
    virtual void kind(const About&, Kind& value) = 0;
    virtual void restitution(const About&, Restitution& value) = 0;
    virtual void friction(const About&, Friction& value) = 0;
    virtual void remedy(const About&, CollapseRemedy& value) = 0;
};

/// Shows every parameter of the scene's kind and of its owners to the visitor. `[scene]` comes first: its kind decides
/// the rest.
void describe(Scene& scene, ParameterVisitor& visitor);

/// Names of the scene kinds, in the order of enum Kind.
const std::vector<std::string>& kind_names();

/// Names of the restitution laws that a table { law = ... } may ask for.
const std::vector<std::string>& restitution_law_names();

/// Names of the friction laws and of the remedies against collapse, in the order of their enums.
const std::vector<std::string>& friction_law_names();
const std::vector<std::string>& collapse_remedy_names();

}  // namespace shaken::scene
