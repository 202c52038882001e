// SPDX-License-Identifier: MIT
// Errors of cycles that do not scatter: none, but for phases, which are known to the step between samples alone.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "compare/summary.hpp"
#include "synthetic.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

namespace {

const scene::PlateMotion motion{5.0, 0.1};

compare::Measured measured(std::int64_t blocks) {
    return compare::measure(synthetic::run_with_front(blocks, 0.0), motion, synthetic::ideal_gas());
}

/// Every ..._error of a summary by its name, wherever it stands.
void collect(const nlohmann::ordered_json& part, std::map<std::string, nlohmann::ordered_json>& errors) {
    for (const auto& [key, value] : part.items()) {
        if (value.is_object()) collect(value, errors);
        if (key.ends_with("_error") && !value.is_null()) errors[key] = value;
    }
}

}  // namespace

TEST_CASE("errors of made-up cycles without scatter are what the resolution of phases alone gives") {
    std::map<std::string, nlohmann::ordered_json> errors;
    collect(compare::summarise(measured(4), measured(1), {}, {}, {}), errors);
    for (const char* key : {"formation_phase_error", "leaving_phase_error", "mean_speed_error", "max_mach_error",
                            "shock_mach_error", "zcm_error", "zcm_rms_percent_error", "density_rms_error"})
        CHECK(errors.contains(key));
    const double resolution = 1.0 / 40.0 / std::sqrt(12.0);  // of a uniform distribution between two sampled phases
    for (const auto& [key, error] : errors) {
        INFO(key);
        const bool of_phase = key == "formation_phase_error" || key == "fully_formed_phase_error";
        // Round-off: a replica averages three equal blocks instead of four.
        for (const double found :
             error.is_array() ? error.get<std::vector<double>>() : std::vector{error.get<double>()})
            CHECK(found == Approx(of_phase ? resolution : 0.0).margin(1e-10));
    }
}
