// SPDX-License-Identifier: MIT
#include "continuum/initial_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuum/parameters.hpp"
#include "fields/period.hpp"
#include "fields/phase_moments.hpp"
#include "files/errors.hpp"
#include "files/hdf5.hpp"
#include "scene/errors.hpp"

namespace shaken::continuum {

namespace {

constexpr double nearest_allowed = 0.01;

double distance(double a, double b) {
    const double d = std::abs(a - b);
    return std::min(d, 1.0 - d);
}

[[noreturn]] void refuse_phase(const std::filesystem::path& path, double phase, double nearest) {
    throw scene::SceneError({}, fmt::format("initial.phase = {}: {} holds no state there; the nearest is at {:.6g}",
                                            phase, path.string(), nearest));
}

StoredFlow read_frame(const files::Hdf5File& file, const std::filesystem::path& path, double phase,
                      const scene::Scene& origin) {
    std::string best;
    double nearest = 2.0, found = 0.0;
    for (std::int64_t i = 0; file.has(fmt::format("/frames/{:05}", i)); ++i) {
        const std::string name = fmt::format("/frames/{:05}", i);
        const double here = file.read_number(name + "/phase");
        if (distance(here, phase) < nearest) {
            nearest = distance(here, phase);
            best = name;
            found = here;
        }
    }
    if (nearest > nearest_allowed) refuse_phase(path, phase, found);
    StoredFlow flow;
    const std::vector<std::int64_t> cells = file.read<std::int64_t>("/grid/cells");
    const std::vector<double> spacing = file.read<double>("/grid/spacing");
    if (cells.size() != 3 || spacing.size() != 3) throw files::Damaged(path.string() + ": /grid is not that of a box");
    std::copy(cells.begin(), cells.end(), flow.cells.begin());
    std::copy(spacing.begin(), spacing.end(), flow.spacing.begin());
    const auto wanted = static_cast<std::size_t>(cells[0] * cells[1] * cells[2]);
    const auto field = [&](const char* name) {
        std::vector<double> values = file.read<double>(fmt::format("{}/{}", best, name));
        if (values.size() != wanted)
            throw files::Damaged(
                fmt::format("{}: {}/{} has {} values, not {}", path.string(), best, name, values.size(), wanted));
        return values;
    };
    flow.density = field("density");
    flow.velocity_x = field("velocity_x");
    flow.velocity_y = field("velocity_y");
    flow.velocity_z = field("velocity_z");
    flow.temperature = field("temperature");
    const double plate = origin.motion.velocity(found * origin.motion.period());
    for (double& u : flow.velocity_z) u -= plate;
    return flow;
}

StoredFlow read_profile(const files::Hdf5File& file, const std::filesystem::path& path, double phase,
                        const scene::Scene& origin) {
    fields::PhaseMoments moments = fields::PhaseMoments::read(file, "/profiles");
    const bool alternates = fields::period_of(moments.centre_of_mass(), moments.phases()).value_or(1) > 1;
    if (fields::odd_cycles_are_higher(moments.centre_of_mass(), moments.phases())) moments.exchange_flows();
    const bool apart = alternates && moments.keeps_flows_apart();
    const double phases = static_cast<double>(moments.phases());
    const std::int64_t index = std::llround(phase * phases) % moments.phases();
    const double found = static_cast<double>(index) / phases;
    if (distance(found, phase) > nearest_allowed) refuse_phase(path, phase, found);
    const fields::Profile profile =
        moments.profile(index, origin.motion, {}, apart ? fields::Flow::first : fields::Flow::both);
    if (std::isnan(profile.density.front()))
        throw files::Damaged(
            fmt::format("{}: the run had not been averaged at ft = {:.6g} when it ended", path.string(), found));
    StoredFlow flow;
    flow.cells = {1, 1, profile.bins.count};
    flow.spacing = {1.0, 1.0, profile.bins.width};
    flow.lower = profile.bins.lower;
    flow.density = profile.density;
    flow.velocity_z = profile.velocity;
    flow.temperature = profile.temperature;
    flow.velocity_x.assign(flow.density.size(), 0.0);
    flow.velocity_y.assign(flow.density.size(), 0.0);
    double velocity = profile.plate_velocity, temperature = 0.0;
    for (std::size_t i = 0; i < flow.density.size(); ++i) {
        if (flow.density[i] > 0.0 && flow.temperature[i] > 0.0) {
            velocity = flow.velocity_z[i];
            temperature = flow.temperature[i];
        }
        flow.velocity_z[i] = velocity - profile.plate_velocity;
        flow.temperature[i] = temperature;
    }
    return flow;
}

}  // namespace

StoredFlow read_flow(const std::filesystem::path& path, double phase) {
    const files::Hdf5File file(path, files::Open::read);
    if (!file.has("/provenance/scene")) throw files::Damaged(path.string() + ": is no output of this program");
    const scene::Scene origin = parse_scene(file.read_text("/provenance/scene"), path.string() + " (scene)");
    if (file.has("/frames/00000")) return read_frame(file, path, phase, origin);
    if (file.has("/profiles/sums")) return read_profile(file, path, phase, origin);
    throw files::Damaged(path.string() + ": holds neither /frames nor /profiles to start from");
}

Interpolated interpolate(const StoredFlow& stored, const Grid& grid, std::int64_t ix, std::int64_t iy,
                         std::int64_t iz) {
    struct Place {
        std::int64_t below, above;
        double part;
    };
    const auto periodic = [](std::int64_t i, std::int64_t cells, std::int64_t stored_cells) -> Place {
        const double place =
            (static_cast<double>(i) + 0.5) / static_cast<double>(cells) * static_cast<double>(stored_cells) - 0.5;
        const auto low = static_cast<std::int64_t>(std::floor(place));
        return {(low + stored_cells) % stored_cells, (low + 1) % stored_cells, place - static_cast<double>(low)};
    };
    const Place x = periodic(ix, grid.nx, stored.cells[0]), y = periodic(iy, grid.ny, stored.cells[1]);
    const double height = (grid.centre(iz) - stored.lower) / stored.spacing[2] - 0.5;
    const double top = static_cast<double>(stored.cells[2] - 1);
    const double inside = std::clamp(height, 0.0, top);
    const std::int64_t low = std::min<std::int64_t>(static_cast<std::int64_t>(inside), stored.cells[2] - 1);
    const Place z{low, std::min<std::int64_t>(low + 1, stored.cells[2] - 1), inside - static_cast<double>(low)};
    const auto at = [&](const std::vector<double>& field) {
        const auto row = [&](std::int64_t k, std::int64_t j) {
            const std::int64_t start = (k * stored.cells[1] + j) * stored.cells[0];
            return (1.0 - x.part) * field[static_cast<std::size_t>(start + x.below)] +
                   x.part * field[static_cast<std::size_t>(start + x.above)];
        };
        const auto plane = [&](std::int64_t k) { return (1.0 - y.part) * row(k, y.below) + y.part * row(k, y.above); };
        return (1.0 - z.part) * plane(z.below) + z.part * plane(z.above);
    };
    const bool within = height >= -0.5 && height <= top + 0.5;
    return {within ? at(stored.density) : 0.0, at(stored.velocity_x), at(stored.velocity_y), at(stored.velocity_z),
            at(stored.temperature)};
}

}  // namespace shaken::continuum
