// SPDX-License-Identifier: MIT
#include "run/verification.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "files/atomic_write.hpp"
#include "files/provenance.hpp"

namespace shaken::run {

namespace {

std::string csv_of(const continuum::Verification& v) {
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
    return csv;
}

std::string summary_of(const continuum::Verification& v) {
    nlohmann::ordered_json summary;
    summary["steps"] = v.steps;
    for (const continuum::Checked& number : v.numbers) {
        if (number.why_no_exact.empty())
            summary[number.name] = {
                {"computed", number.computed}, {"exact", number.exact}, {"error", number.relative_error()}};
        else
            summary[number.name] = {{"computed", number.computed}, {"why_no_exact", number.why_no_exact}};
    }
    if (v.why_no_exact.empty())
        summary["mean_error"] = {{"volume_fraction", v.volume_fraction_error},
                                 {"velocity", v.velocity_error},
                                 {"temperature", v.temperature_error}};
    return summary.dump(2) + "\n";
}

}  // namespace

VerificationRun::VerificationRun(const scene::Scene& scene) : scene_(scene) { continuum::refuse_unverifiable(scene); }

bool VerificationRun::advance_and_sample(const AskedToStop& stop, const Emit&) {
    found_ = continuum::verify_unless(stop, scene_);
    return found_.has_value();
}

void VerificationRun::write(const Output& output) const {
    const continuum::Verification& v = *found_;
    files::Hdf5File file(output.aside(), files::Open::create);
    files::write_provenance(file, {output.scene_text, scene_.initial.seed, output.parent});
    for (const auto& [name, values] : {std::pair{"height", &v.height},
                                       {"volume_fraction", &v.volume_fraction},
                                       {"velocity", &v.velocity},
                                       {"temperature", &v.temperature},
                                       {"exact_volume_fraction", &v.exact_volume_fraction},
                                       {"exact_velocity", &v.exact_velocity},
                                       {"exact_temperature", &v.exact_temperature}})
        if (!values->empty()) file.write(std::string("/verification/") + name, *values);
    write_spent(file, output.spent);
    file.close();
    files::write_atomically(output.path.parent_path() / "verification.csv", csv_of(v));
    files::write_atomically(output.path.parent_path() / "summary.json", summary_of(v));
    std::filesystem::rename(output.aside(), output.path);  // last: it says that the others are there
}

}  // namespace shaken::run
