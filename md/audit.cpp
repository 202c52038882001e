// SPDX-License-Identifier: MIT
#include "md/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "md/errors.hpp"

namespace shaken::md {

namespace {

double shortest(double difference, double length) { return difference - length * std::nearbyint(difference / length); }

}  // namespace

Audit audit(const Snapshot& snapshot, const Box& box) {
    const auto& r = snapshot.position;
    Audit result;
    for (std::size_t i = 0; i < r.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a)
            if (!std::isfinite(r[i][a]) || !std::isfinite(snapshot.velocity[i][a]))
                throw InvariantBroken(
                    fmt::format("md: particle {} has a coordinate or velocity that is not finite", i));
        if (box.periodic_z) continue;
        const double plate = box.plate ? box.plate->position(snapshot.time_in_cycle) : 0.0;
        result.deepest_in_plate = std::max(result.deepest_in_plate, plate + 0.5 - r[i][2]);
        result.deepest_in_ceiling = std::max(result.deepest_in_ceiling, r[i][2] + 0.5 - box.z);
    }
    // Columns one diameter wide in x, each sorted by height: a particle meets those of nine columns within one
    // diameter.
    const auto columns_x = std::max<std::int64_t>(1, static_cast<std::int64_t>(box.x));
    const auto columns_y = std::max<std::int64_t>(1, static_cast<std::int64_t>(box.y));
    std::vector<std::vector<std::uint32_t>> columns(static_cast<std::size_t>(columns_x * columns_y));
    const auto across = [](double position, double length, std::int64_t count) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(position / length * static_cast<double>(count)), 0,
                                        count - 1);
    };
    for (std::uint32_t i = 0; i < r.size(); ++i)
        columns[static_cast<std::size_t>(across(r[i][1], box.y, columns_y) * columns_x +
                                         across(r[i][0], box.x, columns_x))]
            .push_back(i);
    for (auto& column : columns)
        std::sort(column.begin(), column.end(), [&](auto a, auto b) { return r[a][2] < r[b][2]; });

    double nearest = 1.0;
    const auto examine = [&](std::uint32_t i, const std::vector<std::uint32_t>& column, double height) {
        const auto first = std::lower_bound(column.begin(), column.end(), height - 1.0,
                                            [&](std::uint32_t j, double z) { return r[j][2] < z; });
        for (auto at = first; at != column.end() && r[*at][2] <= height + 1.0; ++at) {
            if (*at <= i) continue;
            const double x = shortest(r[*at][0] - r[i][0], box.x), y = shortest(r[*at][1] - r[i][1], box.y);
            const double z = r[*at][2] - height;
            const double squared = x * x + y * y + z * z;
            if (squared < nearest) {
                nearest = squared;
                result.first = i;
                result.second = *at;
            }
        }
    };
    for (std::uint32_t i = 0; i < r.size(); ++i) {
        const std::int64_t ix = across(r[i][0], box.x, columns_x), iy = across(r[i][1], box.y, columns_y);
        for (std::int64_t dy = -1; dy <= 1; ++dy)
            for (std::int64_t dx = -1; dx <= 1; ++dx) {
                const auto& column = columns[static_cast<std::size_t>((iy + dy + columns_y) % columns_y * columns_x +
                                                                      (ix + dx + columns_x) % columns_x)];
                examine(i, column, r[i][2]);
                if (!box.periodic_z) continue;
                examine(i, column, r[i][2] - box.z);
                examine(i, column, r[i][2] + box.z);
            }
    }
    result.largest_overlap = 1.0 - std::sqrt(nearest);
    return result;
}

}  // namespace shaken::md
