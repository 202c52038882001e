// SPDX-License-Identifier: MIT
#include "md/h5md.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "files/errors.hpp"
#include "shaken_version.hpp"

namespace shaken::md {

namespace {

const std::string group = "/particles/all";
/// H5MD 1.1 names no element for rotation; further elements may bear any name.
const std::string spin = "/angular_velocity";

std::span<const double> flat(const std::vector<std::array<double, 3>>& vectors) {
    return {vectors.empty() ? nullptr : vectors.front().data(), vectors.size() * 3};
}

}  // namespace

H5mdWriter::H5mdWriter(const std::filesystem::path& path, const Box& box, const files::Provenance& provenance)
    : file_(path, files::Open::create), box_(box) {
    file_.make_group("/h5md");
    constexpr std::array<std::int32_t, 2> version{1, 1};
    file_.attribute("/h5md", "version", std::span<const std::int32_t>(version));
    file_.make_group("/h5md/author");
    file_.attribute("/h5md/author", "name", std::string_view("the owner of this run"));
    file_.make_group("/h5md/creator");
    file_.attribute("/h5md/creator", "name", std::string_view("shaken"));
    file_.attribute("/h5md/creator", "version", std::string_view(version::number));
    file_.make_group(group + "/box");
    file_.attribute(group + "/box", "dimension", std::int64_t{3});
    const char* z = box.periodic_z ? "periodic" : "none";
    file_.attribute(group + "/box", "boundary", std::vector<std::string>{"periodic", "periodic", z});
    files::write_provenance(file_, provenance);
}

void H5mdWriter::append(const Snapshot& snapshot, std::int64_t step, double time) {
    const files::Shape vectors{snapshot.position.size(), 3};
    file_.append<std::int64_t>(group + "/position/step", std::span(&step, 1), files::Shape{});
    file_.append<double>(group + "/position/time", std::span(&time, 1), files::Shape{});
    file_.append<double>(group + "/position/value", flat(snapshot.position), vectors);
    file_.append<double>(group + "/velocity/value", flat(snapshot.velocity), vectors);
    if (!snapshot.spin.empty()) file_.append<double>(group + spin + "/value", flat(snapshot.spin), vectors);
    const std::array<double, 9> edges{box_.x, 0, 0, 0, box_.y, 0, 0, 0, box_.z};
    file_.append<double>(group + "/box/edges/value", std::span<const double>(edges), files::Shape{3, 3});
    if (linked_) return;
    std::vector<std::string> elements{"/velocity", "/box/edges"};
    if (!snapshot.spin.empty()) elements.push_back(spin);
    for (const std::string& element : elements)
        for (const std::string axis : {"/step", "/time"})
            file_.hard_link(group + "/position" + axis, group + element + axis);
    linked_ = true;
}

H5mdFrames read_h5md(const std::filesystem::path& path) {
    const files::Hdf5File file(path, files::Open::read);
    if (!file.has(group + "/position/value") || !file.has(group + "/velocity/value"))
        throw files::Damaged(path.string() + ": no positions and velocities in " + group);
    const files::Shape shape = file.shape(group + "/position/value");
    const auto positions = file.read<double>(group + "/position/value");
    const auto velocities = file.read<double>(group + "/velocity/value");
    H5mdFrames result{
        file.read<std::int64_t>(group + "/position/step"), file.read<double>(group + "/position/time"), {}, {}, {}};
    if (shape.size() != 3 || shape[2] != 3 || velocities.size() != positions.size() || result.step.size() != shape[0])
        throw files::Damaged(path.string() + ": positions, velocities and steps differ in number");
    const std::size_t particles = shape[1];
    std::vector<double> spins;
    if (file.has(group + spin + "/value")) spins = file.read<double>(group + spin + "/value");
    if (!spins.empty() && spins.size() != positions.size())
        throw files::Damaged(path.string() + ": positions and angular velocities differ in number");
    if (file.has(group + "/phase")) result.phase = file.read<double>(group + "/phase");
    if (!result.phase.empty() && result.phase.size() != shape[0])
        throw files::Damaged(path.string() + ": positions and phases differ in number");
    if (file.has(group + "/box/edges/value")) {
        const auto edges = file.read<double>(group + "/box/edges/value");
        if (edges.size() < 9) throw files::Damaged(path.string() + ": no edges of the box");
        for (std::size_t a = 0; a < 3; ++a) result.box[a] = edges[edges.size() - 9 + 4 * a];
    }
    for (std::size_t frame = 0; frame < shape[0]; ++frame) {
        Snapshot shot;
        shot.position.resize(particles);
        shot.velocity.resize(particles);
        shot.spin.resize(spins.empty() ? 0 : particles);
        for (std::size_t i = 0; i < particles; ++i)
            for (std::size_t a = 0; a < 3; ++a) {
                const std::size_t at = (frame * particles + i) * 3 + a;
                shot.position[i][a] = positions[at];
                shot.velocity[i][a] = velocities[at];
                if (!spins.empty()) shot.spin[i][a] = spins[at];
            }
        result.frames.push_back(std::move(shot));
    }
    return result;
}

}  // namespace shaken::md
