// SPDX-License-Identifier: MIT
#include "fields/field_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "files/atomic_write.hpp"

namespace shaken::fields {

namespace {

std::string frame_group(std::size_t number) { return fmt::format("/frames/{:05}", number); }

}  // namespace

FieldFile::FieldFile(files::Hdf5File& file, const std::filesystem::path& path, Grid grid)
    : file_(file), path_(path), grid_(grid) {
    file_.write<std::int64_t>("/grid/cells", grid_.cells, {3});
    file_.write<double>("/grid/spacing", grid_.spacing, {3});
}

void FieldFile::add_frame(double time, std::int64_t cycle, double phase, double lower_edge,
                          const std::vector<std::pair<std::string, std::span<const double>>>& fields) {
    const std::string group = frame_group(frames_.size());
    Frame frame{time, lower_edge, {}};
    const auto u = [](std::int64_t n) { return static_cast<std::uint64_t>(n); };
    for (const auto& [name, values] : fields) {
        if (static_cast<std::int64_t>(values.size()) != grid_.size()) {
            throw std::invalid_argument(
                fmt::format("field {} has {} values for {} cells", name, values.size(), grid_.size()));
        }
        file_.write<double>(group + "/" + name, values, {u(grid_.cells[2]), u(grid_.cells[1]), u(grid_.cells[0])});
        frame.fields.push_back(name);
    }
    file_.write(group + "/time", time);
    file_.write(group + "/cycle", cycle);
    file_.write(group + "/phase", phase);
    file_.write(group + "/lower_edge", lower_edge);
    frames_.push_back(std::move(frame));
}

void FieldFile::write_xdmf() const {
    const auto [nx, ny, nz] = grid_.cells;
    const auto [dx, dy, dz] = grid_.spacing;
    std::string text =
        "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
        "<Grid Name=\"shaken\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        text += fmt::format(
            "<Grid Name=\"frame {}\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
            "<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
            "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n"
            "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} 0 0</DataItem>\n"
            "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} {} {}</DataItem>\n"
            "</Geometry>\n",
            i, frames_[i].time, nz + 1, ny + 1, nx + 1, frames_[i].lower_edge, dz, dy, dx);
        for (const std::string& name : frames_[i].fields) {
            text += fmt::format(
                "<Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Cell\">\n"
                "<DataItem Dimensions=\"{} {} {}\" NumberType=\"Float\" Precision=\"8\" "
                "Format=\"HDF\">{}:{}/{}</DataItem>\n"
                "</Attribute>\n",
                name, nz, ny, nx, path_.filename().string(), frame_group(i), name);
        }
        text += "</Grid>\n";
    }
    text += "</Grid>\n</Domain>\n</Xdmf>\n";
    std::filesystem::path xdmf = path_;
    files::write_atomically(xdmf.replace_extension(".xdmf"), text);
}

}  // namespace shaken::fields
