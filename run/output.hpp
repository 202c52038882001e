// SPDX-License-Identifier: MIT
// ENGINE.h5 of a run: what its record has summed up, and what its stream holds, written piece by piece with the memory
// of a few thousand rows or one frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/height_maps.hpp"
#include "files/hdf5.hpp"
#include "run/recording.hpp"
#include "run/stream.hpp"
#include "scene/schedule.hpp"

namespace shaken::run {

/// What an output is written from besides the record.
struct Output {
    std::filesystem::path path;  // of ENGINE.h5
    std::filesystem::path stream;
    std::uint64_t stream_length = 0;  // bytes that the checkpoint vouches for
    std::string scene_text;           // as printed when the run began
    std::string parent;               // checkpoint that it went on from, or empty
    Spent spent;

    /// Where it is written before it takes its name.
    std::filesystem::path aside() const { return path.string() + ".part"; }
};

/// Where the streams go.
struct Streams {
    std::vector<ColumnName> columns;                     // of the rows: /observables
    std::function<void(std::span<const double>)> frame;  // of each whole state, packed
    std::optional<scene::Schedule> heights = {};         // of a layer: /profiles/centre_of_mass, NaN where not sampled
    fields::HorizontalGrid grid = {};                    // of its maps: /height_maps, where there are any
};

/// Throws files::Damaged where rows have other columns, or a record is not what its kind says.
void write_streams(files::Hdf5File& file, const Output& output, const Streams& streams);

/// /run, and what took the time.
void write_spent(files::Hdf5File& file, const Spent& spent);

}  // namespace shaken::run
