// SPDX-License-Identifier: MIT
// What the records of both engines hand to the stream alike.
#pragma once

#include <vector>

#include "fields/height_maps.hpp"
#include "run/stream.hpp"
#include "scene/schedule.hpp"

namespace shaken::run {

/// Hands the maps that a sampler has just made to the stream.
template <class Sampler>
void emit_maps(Sampler& sampler, const Emit& emit) {
    const fields::HeightMaps& maps = sampler.maps();
    for (std::size_t row = 0; row < maps.rows(); ++row) {
        std::vector<double> record{static_cast<double>(maps.cycle(row)), maps.phase(row)};
        const std::vector<double> heights = maps.row(row);
        record.insert(record.end(), heights.begin(), heights.end());
        emit(Stream::map, record);
    }
    sampler.clear_maps();
}

/// The height of the centre of mass at an averaged instant, to the stream.
inline void emit_height(const scene::Schedule& schedule, const scene::Instant& at, double height, const Emit& emit) {
    if (!schedule.is_averaged(at.cycle)) return;
    const double record[]{static_cast<double>(schedule.averaged_cycle(at.cycle)), static_cast<double>(at.phase_index),
                          height};
    emit(Stream::height, record);
}

}  // namespace shaken::run
