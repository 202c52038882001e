// SPDX-License-Identifier: MIT
#include "scene/resolve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/errors.hpp"

namespace shaken::scene {

namespace {

/// Depth as poured of one particle a unit area (thesis section 4.2: 10 a unit area are about 9 deep).
constexpr double depth_of_one_per_area = 0.9;

class Resolver {
  public:
    explicit Resolver(Scene& scene) : s_(scene) {}

    void layer() {
        particles();
        motion();
        if (s_.sample.phases % 20 != 0) {
            fail("sample.phases", fmt::format("sample.phases = {} is not a multiple of 20", s_.sample.phases));
        }
        if (s_.sample.frames > 0 && s_.sample.phases % s_.sample.frames != 0) {
            fail("sample.frames", fmt::format("sample.frames = {} does not divide sample.phases = {}", s_.sample.frames,
                                              s_.sample.phases));
        }
        if (s_.sample.frame_cycles > s_.sample.settle + s_.sample.average) {
            fail("sample.frame_cycles", fmt::format("sample.frame_cycles = {} are more than the {} cycles of the run",
                                                    s_.sample.frame_cycles, s_.sample.settle + s_.sample.average));
        }
        if (s_.sample.phases % s_.sample.maps != 0) {
            fail("sample.maps",
                 fmt::format("sample.maps = {} does not divide sample.phases = {}", s_.sample.maps, s_.sample.phases));
        }
        if (s_.sample.map_bin > std::min(s_.box.x, s_.box.y)) {
            fail("sample.map_bin", fmt::format("sample.map_bin = {} is wider than the box, {} x {}", s_.sample.map_bin,
                                               s_.box.x, s_.box.y));
        }
        maps();
    }

    void uniform() {
        auto& p = s_.particles;
        Uniform& u = s_.uniform;
        if (p.number && u.side) {
            fail("box.side", fmt::format("box.side contradicts particles.number ({}): give one of them",
                                         line_of("particles.number")));
        }
        if (!p.number && !u.side) fail("particles", "particles.number or box.side is needed");
        const double volume_of_one = std::numbers::pi / 6.0 / s_.initial.volume_fraction;
        const double wanted = p.number ? static_cast<double>(*p.number) : *u.side * *u.side * *u.side / volume_of_one;
        if (wanted < 1.5 || wanted > 1e9) {
            fail(p.number ? "particles.number" : "box.side",
                 fmt::format("{:.3g} particles cannot be a gas in a box; allowed: 2 to 1e9", wanted));
        }
        s_.number_of_particles = std::llround(wanted);
        const double side = cube_root(static_cast<double>(s_.number_of_particles) * volume_of_one);
        s_.box = {side, side, side};
        const auto intervals = [&](const char* key, double time) {
            const double count = time / u.interval, whole = std::nearbyint(count);
            if (std::abs(count - whole) > 1e-6 * std::max(1.0, whole)) {
                fail(key, fmt::format("{} = {} is not a whole number of sample.interval = {}", key, time, u.interval));
            }
            if (whole > 1e7) {
                fail(key, fmt::format("{} = {} is {:.3g} times sample.interval = {}; at most 1e7 are allowed", key,
                                      time, whole, u.interval));
            }
            return static_cast<std::int64_t>(whole);
        };
        s_.sample.phases = s_.sample.maps = 1;
        s_.sample.frames = 0;
        s_.sample.settle = intervals("sample.settle", u.settle);
        s_.sample.average = intervals("sample.duration", u.duration);
        if (s_.sample.average < 1)
            fail("sample.duration",
                 fmt::format("sample.duration = {} is below sample.interval = {}", u.duration, u.interval));
        if (u.frames > s_.sample.average) {
            fail("sample.frames", fmt::format("sample.frames = {} are more than the {} sample instants of "
                                              "sample.duration",
                                              u.frames, s_.sample.average));
        }
        s_.motion = {0.0, 1.0 / u.interval};
    }

  private:
    [[noreturn]] void fail(const std::string& key, const std::string& message) const {
        throw refusal(s_, key, message);
    }
    std::string line_of(const std::string& key) const {
        const Place& place = s_.written.at(key);
        return fmt::format("{}:{}", place.source, place.line);
    }

    void particles() {
        auto& p = s_.particles;
        if (p.number && p.depth) {
            fail("particles.depth", fmt::format("particles.depth contradicts particles.number ({}): give one of them",
                                                line_of("particles.number")));
        }
        if (!p.number && !p.depth) fail("particles", "particles.number or particles.depth is needed");
        const double area = s_.box.x * s_.box.y;
        const double wanted = p.number ? static_cast<double>(*p.number) : *p.depth * area / depth_of_one_per_area;
        if (wanted < 0.5 || wanted > 1e9) {
            fail("particles.depth",
                 fmt::format("particles.depth = {} on {} x {} is {:.3g} particles; allowed: 1 to 1e9", *p.depth,
                             s_.box.x, s_.box.y, wanted));
        }
        s_.number_of_particles = std::llround(wanted);
        s_.depth = depth_of_one_per_area * static_cast<double>(s_.number_of_particles) / area;
    }

    void motion() {
        auto& p = s_.plate;
        if (p.frequency && p.frequency_star) {
            fail("plate.frequency_star",
                 fmt::format("plate.frequency_star contradicts plate.frequency ({}): give one of them",
                             line_of("plate.frequency")));
        }
        if (!p.frequency && !p.frequency_star) fail("plate", "plate.frequency or plate.frequency_star is needed");
        const double frequency = p.frequency ? *p.frequency : *p.frequency_star / std::sqrt(s_.depth);
        s_.motion = PlateMotion::from_acceleration(p.acceleration, frequency);
    }

    /// Refuses what no machine holds, with an estimate, before it is tried.
    void maps() const {
        constexpr double largest = 8e9;  // bytes
        if (s_.sample.map_bin <= 0.0) return;
        const double heights = 8.0 * static_cast<double>(s_.sample.maps * (s_.sample.settle + s_.sample.average)) *
                               (s_.box.x / s_.sample.map_bin) * (s_.box.y / s_.sample.map_bin);
        if (heights > largest) {
            fail("sample.map_bin",
                 fmt::format("sample.map_bin = {} with {} maps a cycle needs {:.3g} GB; at most {:.3g} are allowed",
                             s_.sample.map_bin, s_.sample.maps, 1e-9 * heights, 1e-9 * largest));
        }
    }

    Scene& s_;
};

}  // namespace

void resolve(Scene& scene) {
    if (scene.kind == Kind::layer) Resolver(scene).layer();
    if (scene.kind == Kind::uniform) Resolver(scene).uniform();
    for (const KeyOwner* owner : scene.owners.list) owner->check(scene);
}

}  // namespace shaken::scene
