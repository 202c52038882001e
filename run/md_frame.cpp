// SPDX-License-Identifier: MIT
#include "run/md_frame.hpp"

#include <fmt/format.h>

#include <array>

#include "files/errors.hpp"

namespace shaken::run {

namespace {

using Vectors = std::vector<std::array<double, 3>>;

}  // namespace

std::vector<double> packed(const md::Snapshot& frame) {
    std::vector<double> record{static_cast<double>(frame.cycle), frame.time_in_cycle,
                               static_cast<double>(frame.position.size())};
    record.reserve(3 + 3 * (frame.position.size() + frame.velocity.size() + frame.spin.size()));
    for (const Vectors* vectors : {&frame.position, &frame.velocity, &frame.spin})
        for (const auto& v : *vectors) record.insert(record.end(), v.begin(), v.end());
    return record;
}

md::Snapshot unpacked(std::span<const double> record) {
    const std::size_t particles = record.size() < 3 ? 0 : static_cast<std::size_t>(record[2]);
    const std::size_t vectors = record.size() < 3 ? 0 : (record.size() - 3) / 3;
    if (record.size() != 3 + 3 * vectors || (vectors != 2 * particles && vectors != 3 * particles))
        throw files::Damaged(fmt::format("a whole state of {} numbers", record.size()));
    md::Snapshot frame;
    frame.cycle = static_cast<std::int64_t>(record[0]);
    frame.time_in_cycle = record[1];
    std::size_t at = 3;
    const auto take = [&](Vectors& to, std::size_t count) {
        to.resize(count);
        for (auto& v : to)
            for (double& x : v) x = record[at++];
    };
    take(frame.position, particles);
    take(frame.velocity, particles);
    take(frame.spin, vectors - 2 * particles);
    return frame;
}

}  // namespace shaken::run
