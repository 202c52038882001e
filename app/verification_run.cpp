// SPDX-License-Identifier: MIT
#include "app/verification_run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/exit_codes.hpp"
#include "app/run_folder.hpp"
#include "continuum/resolve.hpp"
#include "continuum/verification.hpp"
#include "files/atomic_write.hpp"
#include "scene/errors.hpp"
#include "scene/read_scene.hpp"

namespace shaken::app {

bool is_verification(scene::Kind kind) {
    return kind == scene::Kind::riemann || kind == scene::Kind::piston || kind == scene::Kind::column ||
           kind == scene::Kind::wave || kind == scene::Kind::cooling_flow;
}

void refuse_verification(const scene::Scene& scene, const std::string& command) {
    if (is_verification(scene.kind))
        throw scene::SceneError({},
                                fmt::format("shaken {}: a scene of this kind is for the continuum alone; run it with: "
                                            "shaken continuum",
                                            command));
}

int run_verification(const scene::Scene& given, const EngineOptions& options) {
    const scene::Scene scene = continuum::resolve_alone(given);
    const continuum::Verification v =
        continuum::verify(scene);  // first: a scene it refuses must cost no earlier output
    prepare_folder(options.out, options.overwrite, scene::print_scene(scene));
    files::write_atomically(options.out / "scene.toml", scene::print_scene(scene));
    const bool known = v.why_no_exact.empty();
    std::string csv = "height,volume_fraction,velocity,temperature";
    csv += known ? ",exact_volume_fraction,exact_velocity,exact_temperature\n" : "\n";
    for (std::size_t i = 0; i < v.height.size(); ++i) {
        csv += fmt::format("{:.6g},{:.10g},{:.10g},{:.10g}", v.height[i], v.volume_fraction[i], v.velocity[i],
                           v.temperature[i]);
        csv += known ? fmt::format(",{:.10g},{:.10g},{:.10g}\n", v.exact_volume_fraction[i], v.exact_velocity[i],
                                   v.exact_temperature[i])
                     : "\n";
    }
    files::write_atomically(options.out / "verification.csv", csv);
    nlohmann::ordered_json summary;
    summary["steps"] = v.steps;
    fmt::print("continuum: {} cells, {} steps\n", v.height.size(), v.steps);
    for (const continuum::Checked& number : v.numbers) {
        if (!number.why_no_exact.empty()) {
            fmt::print("{:36} {:.8g}   no exact value: {}\n", number.name, number.computed, number.why_no_exact);
            summary[number.name] = {{"computed", number.computed}, {"why_no_exact", number.why_no_exact}};
            continue;
        }
        fmt::print("{:36} {:.8g}   exact {:.8g}   error {:.3g}\n", number.name, number.computed, number.exact,
                   number.relative_error());
        summary[number.name] = {
            {"computed", number.computed}, {"exact", number.exact}, {"error", number.relative_error()}};
    }
    if (known) {
        fmt::print("mean error: volume fraction {:.3g}, velocity {:.3g}, temperature {:.3g}\n", v.volume_fraction_error,
                   v.velocity_error, v.temperature_error);
        summary["mean_error"] = {{"volume_fraction", v.volume_fraction_error},
                                 {"velocity", v.velocity_error},
                                 {"temperature", v.temperature_error}};
    } else {
        fmt::print("no exact profile: {}\n", v.why_no_exact);
    }
    files::write_atomically(options.out / "summary.json", summary.dump(2) + "\n");
    return exit_code::done;
}

}  // namespace shaken::app
