// SPDX-License-Identifier: MIT
#include "run/output.hpp"

#include <fmt/format.h>

#include <deque>
#include <limits>
#include <map>

#include "files/errors.hpp"
#include "files/record_log.hpp"

namespace shaken::run {

namespace {

/// Fills a dataset of known shape in order, some thousand values at a time.
template <class T>
class Filler {
  public:
    Filler(files::Hdf5File& file, std::string name, const files::Shape& shape) : file_(file), name_(std::move(name)) {
        file_.create<T>(name_, shape);
        for (std::size_t axis = 1; axis < shape.size(); ++axis) row_ *= shape[axis];
    }
    void push(T value) {
        values_.push_back(value);
        if (values_.size() >= held && values_.size() % row_ == 0) flush();
    }
    void flush() {
        file_.write_rows<T>(name_, rows_, values_);
        rows_ += values_.size() / row_;
        values_.clear();
    }
    std::uint64_t pushed() const { return rows_ * row_ + values_.size(); }

  private:
    static constexpr std::size_t held = 65536;  // as many as a compressed chunk has (files/hdf5.cpp)
    files::Hdf5File& file_;
    std::string name_;
    std::uint64_t rows_ = 0, row_ = 1;
    std::vector<T> values_;
};

std::uint64_t u(std::int64_t n) { return static_cast<std::uint64_t>(n); }

class Rows {
  public:
    Rows(files::Hdf5File& file, const std::vector<ColumnName>& columns, std::uint64_t rows)
        : step_(file, group(columns.front()) + "/step", {rows}), time_(file, group(columns.front()) + "/time", {rows}) {
        const std::string first = group(columns.front());
        for (const ColumnName& column : columns) {
            const std::string name = group(column);
            values_.emplace_back(file, name + "/value", files::Shape{rows});
            file.attribute(name + "/value", "unit", std::string_view(column.unit));
            if (name == first) continue;
            file.hard_link(first + "/step", name + "/step");
            file.hard_link(first + "/time", name + "/time");
        }
    }
    std::size_t width() const { return 2 + values_.size(); }
    void add(std::span<const double> record) {
        step_.push(static_cast<std::int64_t>(record[0]));
        time_.push(record[1]);
        for (std::size_t c = 0; c < values_.size(); ++c) values_[c].push(record[2 + c]);
    }
    void flush() {
        step_.flush();
        time_.flush();
        for (Filler<double>& column : values_) column.flush();
    }

  private:
    static std::string group(const ColumnName& column) { return "/observables/" + column.name; }
    Filler<std::int64_t> step_;
    Filler<double> time_;
    std::deque<Filler<double>> values_;
};

class CentresOfMass {
  public:
    CentresOfMass(files::Hdf5File& file, const scene::Schedule& schedule)
        : phases_(u(schedule.phases())),
          all_(u(schedule.averaged()) * phases_),
          heights_(file, "/profiles/centre_of_mass", {u(schedule.averaged()), phases_}) {}
    void add(std::span<const double> record) {
        pass_over(static_cast<std::uint64_t>(record[0]) * phases_ + static_cast<std::uint64_t>(record[1]));
        heights_.push(record[2]);
    }
    void flush() {
        pass_over(all_);
        heights_.flush();
    }

  private:
    void pass_over(std::uint64_t until) {
        while (heights_.pushed() < until) heights_.push(std::numeric_limits<double>::quiet_NaN());
    }
    std::uint64_t phases_, all_;
    Filler<double> heights_;
};

class Maps {
  public:
    Maps(files::Hdf5File& file, const fields::HorizontalGrid& grid, std::uint64_t maps)
        : cycle_(file, "/height_maps/cycle", {maps}),
          phase_(file, "/height_maps/phase", {maps}),
          height_(file, "/height_maps/height", {maps, u(grid.ny), u(grid.nx)}) {
        file.attribute("/height_maps", "length_x", grid.length_x);
        file.attribute("/height_maps", "length_y", grid.length_y);
    }
    void add(std::span<const double> record) {
        cycle_.push(static_cast<std::int64_t>(record[0]));
        phase_.push(record[1]);
        for (const double z : record.subspan(2)) height_.push(z);
    }
    void flush() {
        cycle_.flush();
        phase_.flush();
        height_.flush();
    }

  private:
    Filler<std::int64_t> cycle_;
    Filler<double> phase_, height_;
};

/// How many records of a kind; with the memory of none.
std::map<Stream, std::uint64_t> counted(const Output& output) {
    std::map<Stream, std::uint64_t> counts;
    for (files::RecordReader in(output.stream, output.stream_length); in.next();) ++counts[Stream(in.kind())];
    return counts;
}

}  // namespace

void write_streams(files::Hdf5File& file, const Output& output, const Streams& streams) {
    std::map<Stream, std::uint64_t> counts = counted(output);
    Rows rows(file, streams.columns, counts[Stream::row]);
    std::optional<CentresOfMass> heights;
    std::optional<Maps> maps;
    if (streams.heights) heights.emplace(file, *streams.heights);
    if (counts[Stream::map] > 0) maps.emplace(file, streams.grid, counts[Stream::map]);
    const auto expect = [&](bool is_right) {
        if (!is_right)
            throw files::Damaged(fmt::format("{}: a record is not as wide as this run's: written by another version?",
                                             output.stream.string()));
    };
    for (files::RecordReader in(output.stream, output.stream_length); in.next();) {
        const std::vector<double>& record = in.values();
        switch (Stream(in.kind())) {
            case Stream::row:
                expect(record.size() == rows.width());
                rows.add(record);
                break;
            case Stream::height:
                expect(heights && record.size() == 3);
                heights->add(record);
                break;
            case Stream::map:
                expect(record.size() == 2 + streams.grid.size());
                maps->add(record);
                break;
            case Stream::frame:
                streams.frame(record);
                break;
        }
    }
    rows.flush();
    if (heights) heights->flush();
    if (maps) maps->flush();
}

void write_spent(files::Hdf5File& file, const Spent& spent) {
    file.make_group("/run");
    file.attribute("/run", "wall_seconds", spent.wall);
    file.attribute("/run", "cpu_seconds", spent.cpu);
}

}  // namespace shaken::run
