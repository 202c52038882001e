// SPDX-License-Identifier: MIT
// A printed scene parses to the values it was printed from: every key of every kind, values unlike the defaults and
// unlike each other, so that no key can lend its value to another.
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

#include "compare/scenes.hpp"
#include "scene/parameters.hpp"
#include "scene/read_scene.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace scene;

using compare::parse_scene;

namespace {

/// Every value by "section.key", in all its digits; empty where none is given.
class Values : public ParameterVisitor {
  public:
    explicit Values(Scene scene) { describe(scene, *this); }
    std::map<std::string, std::string> by_key;

    void section(std::string_view name, std::string_view) override { section_ = name; }
    void number(const About& a, double& value, const Range&) override { put(a, fmt::format("{}", value)); }
    void optional_number(const About& a, std::optional<double>& value, const Range&) override {
        put(a, value ? fmt::format("{}", *value) : "");
    }
    void whole(const About& a, std::int64_t& value, const Range&) override { put(a, fmt::format("{}", value)); }
    void optional_whole(const About& a, std::optional<std::int64_t>& value, const Range&) override {
        put(a, value ? fmt::format("{}", *value) : "");
    }
    void seed(const About& a, std::uint64_t& value) override { put(a, fmt::format("{}", value)); }
    void text(const About& a, std::string& value) override { put(a, value); }
    void choice(const About& a, Choice& value, const std::vector<Name>&) override { put(a, value.name); }
    void kind(const About& a, Kind& value) override { put(a, kind_names()[static_cast<std::size_t>(value)]); }
    void restitution(const About& a, Restitution& value) override {
        const auto* law = std::get_if<RestitutionVelocity>(&value);
        put(a,
            law ? fmt::format("{} {}", law->e0, law->v0) : fmt::format("{}", std::get<RestitutionConstant>(value).e0));
    }
    void friction(const About& a, Friction& value) override {
        put(a, fmt::format("{} {} {}", static_cast<int>(value.law), value.beta0, value.mu));
    }
    void remedy(const About& a, CollapseRemedy& value) override {
        put(a, fmt::format("remedy {}", static_cast<int>(value)));
    }

  private:
    void put(const About& a, const std::string& value) { by_key[fmt::format("{}.{}", section_, a.key)] = value; }
    std::string section_;
};

/// A scene, and the keys that another of the same kind gives in its place.
struct Full {
    std::string text;
    std::set<std::string> elsewhere;
};

const std::string names = R"(scheme = "s"
flux = "f"
limiter = "l"
closure = "c"
pair_correlation = "p"
transport = "t"
)";

const std::string contacts = R"(restitution = { law = "velocity", e0 = 0.7123456789012345, v0 = 1.3 }
friction = { law = "walton", beta0 = 0.36, mu = 0.52 }
collapse = "contact_time"
collapse_speed = 0.013
collapse_time = 2.5e-4
)";

const std::string initial_and_sample = R"([initial]
volume_fraction = 0.31
temperature = 1.7
noise = 0.12
wave = 0.17
wave_x = 5
wave_y = 3
seed = 9007199254740993
file = "an \"earlier\" \\ run.h5"
phase = 0.35
[sample]
phases = 220
settle = 11
average = 51
bin = 0.55
frames = 22
frame_cycles = 4
maps = 10
map_bin = 1.9
[md]
seed = 77
shell = 0.44
contacts_between_sorts = 123
frames_per_cycle = 17
)";

const std::string continuum_of_layer = "[continuum]\n" + names + R"(dimension = "1"
restitution = 0.83
spacing = 0.22
spacing_horizontal = 2.2
lid = 70.0
cfl = 0.73
artificial_dissipation = 0.11
diffusion_factor = 0.14
floor_density = 2e-7
floor_temperature = 3e-4
)";

std::string scene_of(const std::string& kind) { return "[scene]\nname = \"n\"\nkind = \"" + kind + "\"\n"; }

std::string tube(const std::string& kind, const std::string& more) {
    return scene_of(kind) +
           "[tube]\nlength = 11.5\ntime = 0.61\nrestitution = " + (kind == "column" ? "0.94" : "0.93") + "\n" + more +
           "[continuum]\n" + names +
           "spacing = 0.025\ncfl = 0.71\nartificial_dissipation = 0.12\ndiffusion_factor = 0.13\n"
           "floor_density = 3e-7\n";
}

std::vector<Full> scenes() {
    const std::string gas = "volume_fraction = 0.21\ntemperature = 1.9\n";
    return {
        {scene_of("layer") +
             "[plate]\nacceleration = 3.2512345678901234\nfrequency = 0.095\n[particles]\nnumber = 3931\n" + contacts +
             "[box]\nx = 21.0\ny = 23.5\nceiling = 190.0\n" + initial_and_sample + continuum_of_layer +
             "lower = \"end\"\nupper = \"heated\"\nupper_temperature = 1.6\n",
         {"plate.frequency_star", "particles.depth", "continuum.lower_temperature"}},
        {scene_of("layer") + "[plate]\nacceleration = 3.25\nfrequency_star = 0.41\n[particles]\ndepth = 7.3\n" +
             contacts + "[box]\nx = 21.0\ny = 23.5\nceiling = 190.0\n" + initial_and_sample + continuum_of_layer +
             "lower = \"heated\"\nupper = \"end\"\nlower_temperature = 1.5\n",
         {"plate.frequency", "particles.number", "continuum.upper_temperature"}},
        {scene_of("uniform") + "[particles]\nnumber = 4001\n" + contacts +
             "[initial]\nvolume_fraction = 0.32\ntemperature = 1.8\nseed = 78\nfile = \"g\"\n[sample]\ninterval = "
             "0.25\nsettle = 5.0\n"
             "duration = 20.0\nframes = 3\n[md]\nseed = 79\nshell = 0.45\ncontacts_between_sorts = 124\n[continuum]\n" +
             names + "restitution = 0.84\n",
         {"box.side"}},
        {scene_of("uniform") + "[particles]\n" + contacts +
             "[box]\nside = 19.5\n[initial]\nvolume_fraction = 0.32\ntemperature = 1.8\nseed = 78\nfile = "
             "\"g\"\n[sample]\ninterval = 0.25\n"
             "settle = 5.0\nduration = 20.0\nframes = 3\n[md]\nseed = 79\nshell = 0.45\ncontacts_between_sorts = "
             "124\n[continuum]\n" +
             names + "restitution = 0.84\n",
         {"particles.number"}},
        {tube("riemann",
              "lower = \"heated\"\nupper = \"end\"\nlower_temperature = 1.4\nspeed = "
              "2.5\n[initial.left]\nvolume_fraction = 0.41\n"
              "velocity = 0.3\ntemperature = 1.1\n[initial.right]\nvolume_fraction = 0.06\nvelocity = "
              "-0.4\ntemperature = 1.2\n"),
         {"tube.upper_temperature"}},
        {tube("riemann",
              "lower = \"end\"\nupper = \"heated\"\nupper_temperature = 1.3\nspeed = "
              "2.5\n[initial.left]\nvolume_fraction = 0.41\n"
              "velocity = 0.3\ntemperature = 1.1\n[initial.right]\nvolume_fraction = 0.06\nvelocity = "
              "-0.4\ntemperature = 1.2\n"),
         {"tube.lower_temperature"}},
        {tube("piston", "speed = 2.5\n[initial]\n" + gas), {}},
        {tube("column", "wall_temperature = 1.4\n[initial]\n" + gas + "number_per_area = 2.4\n"), {}},
        {tube("wave", "[initial]\n" + gas + "amplitude = 2e-4\n"), {}},
        {tube("cooling_flow", "[initial]\nvolume_fraction = 0.03\ntemperature = 1.9\n"), {}},
    };
}

}  // namespace

TEST_CASE("a printed scene parses to the values it was printed from, every key of every kind") {
    std::set<std::string> kinds;
    for (const Full& full : scenes()) {
        const Scene scene = parse_scene(full.text, "full.toml");
        const std::map<std::string, std::string> given = Values(scene).by_key;
        INFO(print_scene(scene));
        CHECK(Values(parse_scene(print_scene(scene), "printed.toml")).by_key == given);

        Scene defaults;
        defaults.kind = scene.kind;
        defaults.owners = scene.owners;
        const std::map<std::string, std::string> usual = Values(defaults).by_key;
        std::map<std::string, std::string> of_value;
        for (const auto& [key, value] : given) {
            INFO(key << " = " << value << ", which is also the value of " << of_value[value]);
            CHECK(value.empty() == full.elsewhere.contains(key));  // a new key asks for a value here
            if (value.empty() || key == "scene.kind") continue;
            CHECK(value != usual.at(key));
            CHECK(of_value[value].empty());
            of_value[value] = key;
        }
        kinds.insert(given.at("scene.kind"));
    }
    CHECK(kinds == std::set<std::string>(kind_names().begin(), kind_names().end()));
}
