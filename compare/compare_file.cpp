// SPDX-License-Identifier: MIT
#include "compare/compare_file.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "files/hdf5.hpp"

namespace shaken::compare {

namespace {

using OfPhase = std::function<double(const Analysis&, std::size_t phase)>;
using OfBin = std::function<double(const Analysis&, std::size_t phase, std::size_t bin)>;

/// Writes one engine's group. Errors are written where the run has blocks of cycles to take them from.
class EngineGroup {
  public:
    EngineGroup(files::Hdf5File& file, std::string group, const Measured& measured)
        : file_(file),
          group_(std::move(group)),
          measured_(measured),
          phases_(measured.all.profiles.size()),
          bins_(static_cast<std::size_t>(measured.all.profiles.front().bins.count)) {}

    using Estimator = Estimate (Measured::*)(const std::function<double(const Analysis&)>&) const;

    /// Shape (phases).
    void phases(const std::string& name, const std::string& unit, const OfPhase& number,
                Estimator estimate = &Measured::estimate_from_halves) const {
        std::vector<double> values, errors;
        for (std::size_t p = 0; p < phases_; ++p) {
            const Estimate e = (measured_.*estimate)([&](const Analysis& a) { return number(a, p); });
            values.push_back(e.value);
            errors.push_back(e.error);
        }
        write(name, unit, values, errors, {phases_});
    }

    /// Shape (phases, bins).
    void bins(const std::string& name, const std::string& unit, const OfBin& number) const {
        std::vector<double> values, errors;
        for (std::size_t p = 0; p < phases_; ++p) {
            for (std::size_t i = 0; i < bins_; ++i) {
                const Estimate e = measured_.estimate([&](const Analysis& a) { return number(a, p, i); });
                values.push_back(e.value);
                errors.push_back(e.error);
            }
        }
        write(name, unit, values, errors, {phases_, bins_});
    }

  private:
    void write(const std::string& name, const std::string& unit, const std::vector<double>& values,
               const std::vector<double>& errors, const files::Shape& shape) const {
        const std::string path = group_ + "/" + name;
        file_.write<double>(path, values, shape);
        file_.attribute(path, "unit", unit);
        if (measured_.without_block.empty()) return;
        file_.write<double>(path + "_error", errors, shape);
        file_.attribute(path + "_error", "unit", unit);
    }

    files::Hdf5File& file_;
    std::string group_;
    const Measured& measured_;
    std::size_t phases_, bins_;
};

OfBin of_profile(std::vector<double> fields::Profile::*member) {
    return [member](const Analysis& a, std::size_t p, std::size_t i) { return (a.profiles[p].*member)[i]; };
}

OfPhase of_layer(double Layer::*member) {
    return [member](const Analysis& a, std::size_t p) {
        const std::optional<Layer>& layer = a.measures[p].layer;
        return layer ? (*layer).*member : std::nan("");
    };
}

OfPhase of_shock(const std::function<double(const Shock&)>& number) {
    return [number](const Analysis& a, std::size_t p) {
        const std::optional<Shock>& shock = a.measures[p].shock;
        return shock ? number(*shock) : std::nan("");
    };
}

void write_profiles(const EngineGroup& group, const Medium& medium) {
    group.bins("density", "sigma^-3", of_profile(&fields::Profile::density));
    group.bins("velocity", "sqrt(g sigma)", of_profile(&fields::Profile::velocity));
    group.bins("temperature", "g sigma", of_profile(&fields::Profile::temperature));
    group.bins("temperature_z", "g sigma", of_profile(&fields::Profile::temperature_z));
    group.bins("temperature_x", "g sigma", of_profile(&fields::Profile::temperature_x));
    group.bins("mach", "1",
               [&](const Analysis& a, std::size_t p, std::size_t i) { return mach_number(a.profiles[p], i, medium); });
    group.bins("mean_free_path", "sigma", [&](const Analysis& a, std::size_t p, std::size_t i) {
        return mean_free_path(a.profiles[p], i, medium);
    });
}

void write_measures(const EngineGroup& group) {
    group.phases(
        "centre_of_mass", "sigma", [](const Analysis& a, std::size_t p) { return a.centre_of_mass[p]; },
        &Measured::estimate);
    group.phases("layer/lower", "sigma", of_layer(&Layer::lower));
    group.phases("layer/upper", "sigma", of_layer(&Layer::upper));
    group.phases("max_mach", "1", [](const Analysis& a, std::size_t p) { return a.measures[p].maximum_mach.value; });
    group.phases("max_mach_height", "sigma",
                 [](const Analysis& a, std::size_t p) { return a.measures[p].maximum_mach.height; });
    group.phases("shock/location", "sigma", of_shock([](const Shock& s) { return s.location; }));
    group.phases("shock/top", "sigma", of_shock([](const Shock& s) { return s.top; }));
    group.phases("shock/foot", "sigma", of_shock([](const Shock& s) { return s.foot; }));
    group.phases("shock/width", "sigma", of_shock([](const Shock& s) { return s.width(); }));
    group.phases("shock/slope_width", "sigma", of_shock([](const Shock& s) { return s.slope_width(); }));
    group.phases("shock/mach_above", "1", of_shock([](const Shock& s) { return s.mach_above; }));
    group.phases("shock/width_over_mean_free_path", "1",
                 of_shock([](const Shock& s) { return s.width() / s.mean_free_path; }));
    group.phases("shock/width_over_mean_free_path_foot", "1",
                 of_shock([](const Shock& s) { return s.width() / s.mean_free_path_foot; }));
    group.phases("shock/slope_width_over_mean_free_path_foot", "1",
                 of_shock([](const Shock& s) { return s.slope_width() / s.mean_free_path_foot; }));
    group.phases("shock/inside_layer", "1", of_shock([](const Shock& s) { return s.inside_layer ? 1.0 : 0.0; }));
}

/// The phases between which the shock was followed, NaN where there was none.
void write_history(files::Hdf5File& file, const std::string& group, const std::optional<ShockHistory>& history) {
    const auto number = [&](double ShockHistory::*member) { return history ? (*history).*member : std::nan(""); };
    file.write(group + "/formation_phase", number(&ShockHistory::formation_phase));
    file.write(group + "/fully_formed_phase", number(&ShockHistory::fully_formed_phase));
    file.write(group + "/fully_formed_speed", number(&ShockHistory::fully_formed_speed));
    file.write(group + "/fitted_speed", number(&ShockHistory::fitted_speed));
    file.write(group + "/leaving_phase", number(&ShockHistory::leaving_phase));
    file.write(group + "/mean_speed", number(&ShockHistory::mean_speed));
}

void write_histories(files::Hdf5File& file, const std::string& group, const Measured& measured) {
    write_history(file, group + "/shock", measured.all.history);
    if (measured.layout.cycles > 1) write_history(file, group + "/shock/second_cycle", measured.all.second_history);
    std::vector<std::int64_t> followed;
    for (std::size_t p = 0; p < measured.all.measures.size(); ++p)
        followed.push_back(measured.all.follows(static_cast<std::int64_t>(p)) ? 1 : 0);
    file.write(group + "/shock/followed", followed);
}

void write_axes(files::Hdf5File& file, const Analysis& analysis) {
    const fields::Bins& bins = analysis.profiles.front().bins;
    std::vector<double> phase, plate_height, plate_velocity, height;
    for (const fields::Profile& profile : analysis.profiles) {
        phase.push_back(profile.phase);
        plate_height.push_back(profile.plate_height);
        plate_velocity.push_back(profile.plate_velocity);
    }
    for (std::int64_t i = 0; i < bins.count; ++i) height.push_back(bins.centre(i));
    const auto write = [&](const std::string& name, const std::string& unit, const std::vector<double>& values) {
        file.write(name, values);
        file.attribute(name, "unit", unit);
    };
    write("/phase", "1", phase);
    write("/height", "sigma", height);
    write("/plate/height", "sigma", plate_height);
    write("/plate/velocity", "sqrt(g sigma)", plate_velocity);
}

void write_engine(files::Hdf5File& file, const std::string& name, const Measured& measured, const Medium& medium) {
    const EngineGroup group(file, name, measured);
    write_profiles(group, medium);
    write_measures(group);
    write_histories(file, name, measured);
    file.attribute(name, "period", static_cast<std::int64_t>(measured.layout.period.value_or(0)));
}

}  // namespace

void write_compare_file(const std::filesystem::path& path, const Measured& md, const Measured& continuum,
                        const Medium& medium, const files::Provenance& provenance) {
    const auto& ours = continuum.all.profiles;
    const auto& theirs = md.all.profiles;
    if (ours.empty() || ours.size() != theirs.size() || ours.front().bins.count != theirs.front().bins.count ||
        ours.front().bins.width != theirs.front().bins.width) {
        throw std::invalid_argument(
            "compare.h5: the two engines were sampled at different phases or on different bins");
    }
    files::Hdf5File file(path, files::Open::create);
    files::write_provenance(file, provenance);
    write_axes(file, md.all);
    file.attribute("/phase", "period", md.layout.cycles);
    write_engine(file, "/md", md, medium);
    write_engine(file, "/continuum", continuum, medium);
    file.close();
}

}  // namespace shaken::compare
