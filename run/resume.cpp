// SPDX-License-Identifier: MIT
#include "run/resume.hpp"

#include <fmt/format.h>

#include "continuum/resolve.hpp"
#include "files/errors.hpp"
#include "run/continuum_layer.hpp"
#include "run/md_gas.hpp"
#include "run/md_layer.hpp"
#include "compare/scenes.hpp"
#include "scene/read_scene.hpp"

namespace shaken::run {

namespace {

template <class Record>
void restore_output(const EngineFiles& files, const Resumed& from, const scene::Scene& scene) {
    Record record(scene);
    record.restore(from.in);
    record.write({files.output(), files.stream(), from.origin.stream_length, from.origin.scene_text, from.origin.parent,
                  from.origin.before});
}

}  // namespace

bool is_verification(scene::Kind kind) {
    return kind == scene::Kind::riemann || kind == scene::Kind::piston || kind == scene::Kind::column ||
           kind == scene::Kind::wave || kind == scene::Kind::cooling_flow;
}

Resumed read_checkpoint(const EngineFiles& files) {
    files::CheckpointReader in(files.checkpoint());
    const std::string path = files.checkpoint().string(), engine = in.take_text("engine"), text = in.take_text("scene");
    if (engine != files.engine)
        throw files::Damaged(fmt::format("{}: is a checkpoint of {}, not of {}", path, engine, files.engine));
    if (in.has("frames/count"))
        throw files::Damaged(fmt::format("{}: is of an earlier version of this program; begin the run anew", path));
    const bool is_finished = !in.has("stream_length");
    Origin origin{text, path, in.take_one<Spent>("spent"),
                  is_finished ? 0 : in.take_one<std::uint64_t>("stream_length")};
    const auto next_sample = in.take_one<std::int64_t>("next_sample");
    return {std::move(in), compare::parse_scene(text, path + " (scene)"), std::move(origin), next_sample, is_finished};
}

void restore_outputs(const std::filesystem::path& folder) {
    for (const char* engine : {"md", "continuum"}) {
        const EngineFiles files{folder, engine};
        if (!std::filesystem::exists(files.checkpoint()) || !std::filesystem::exists(files.stream())) continue;
        const FolderLock lock(folder, engine);
        const Resumed from = read_checkpoint(files);
        if (from.is_finished) continue;
        if (from.scene.kind == scene::Kind::layer && files.engine == "continuum")
            restore_output<ContinuumLayerRecord>(files, from, continuum::resolve(from.scene));
        else if (from.scene.kind == scene::Kind::layer)
            restore_output<MdLayerRecord>(files, from, from.scene);
        else if (files.engine == "md")
            restore_output<MdGasRecord>(files, from, from.scene);
    }
}

}  // namespace shaken::run
