// SPDX-License-Identifier: MIT
// PhaseMoments in checkpoints and HDF5 files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fields/phase_moments.hpp"
#include "files/errors.hpp"

namespace shaken::fields {

void PhaseMoments::part_blocks_of_one_cycle() {
    const std::size_t sums = sums_.size() / static_cast<std::size_t>(blocks_);
    const auto samples = static_cast<std::size_t>(phases_);
    second_sums_.assign(sums_.size(), 0.0);
    second_samples_.assign(samples_.size(), 0);
    for (std::size_t block = 1; block < is_second_.size(); block += 2) {
        std::copy_n(&sums_[block * sums], sums, &second_sums_[block * sums]);
        std::copy_n(&samples_[block * samples], samples, &second_samples_[block * samples]);
    }
}

void PhaseMoments::save(files::CheckpointWriter& out, const std::string& prefix) const {
    out.put(prefix + "sums", sums_);
    out.put(prefix + "samples", samples_);
    out.put(prefix + "centre_of_mass", centre_of_mass_);
    if (blocks_ == cycles_ || !keeps_flows_apart()) return;
    out.put(prefix + "odd_sums", second_sums_);
    out.put(prefix + "odd_samples", second_samples_);
}

void PhaseMoments::restore(const files::CheckpointReader& in, const std::string& prefix) {
    in.take_into(prefix + "sums", std::span(sums_));
    in.take_into(prefix + "samples", std::span(samples_));
    in.take_into(prefix + "centre_of_mass", std::span(centre_of_mass_));
    if (blocks_ == cycles_) {
        part_blocks_of_one_cycle();
    } else if (in.has(prefix + "odd_sums")) {
        in.take_into(prefix + "odd_sums", std::span(second_sums_));
        in.take_into(prefix + "odd_samples", std::span(second_samples_));
    } else {  // an earlier version's
        second_sums_.clear();
        second_samples_.clear();
    }
}

void PhaseMoments::write(files::Hdf5File& file, const std::string& group) const {
    const auto u = [](std::int64_t n) { return static_cast<std::uint64_t>(n); };
    file.write<double>(group + "/sums", sums_, {u(blocks_), u(phases_), u(bins_.count), moments});
    file.write<std::int64_t>(group + "/samples", samples_, {u(blocks_), u(phases_)});
    if (heights_ == Heights::kept)
        file.write<double>(group + "/centre_of_mass", centre_of_mass_, {u(cycles_), u(phases_)});
    if (blocks_ < cycles_ && keeps_flows_apart()) {
        file.write<double>(group + "/odd_sums", second_sums_, {u(blocks_), u(phases_), u(bins_.count), moments});
        file.write<std::int64_t>(group + "/odd_samples", second_samples_, {u(blocks_), u(phases_)});
    }
    file.write(group + "/bin_lower", bins_.lower);
    file.write(group + "/bin_width", bins_.width);
    file.write(group + "/area", area_);
    file.attribute(group + "/sums", "moments", "mass, momentum x y z, second moment xx yy zz; sums over samples");
    file.write_text(group + "/deposits", deposits_ == Deposits::particles ? "particles" : "cells");
}

PhaseMoments PhaseMoments::read(const files::Hdf5File& file, const std::string& group) {
    const files::Shape shape = file.shape(group + "/sums"), cycles = file.shape(group + "/centre_of_mass");
    if (shape.size() != 4 || shape[3] != moments || cycles.size() != 2 || cycles[1] != shape[1]) {
        throw files::Damaged(fmt::format("{}: not a set of phase moments", group));
    }
    const Bins bins{file.read_number(group + "/bin_lower"), file.read_number(group + "/bin_width"),
                    static_cast<std::int64_t>(shape[2])};
    const bool is_of_particles =
        file.has(group + "/deposits") ? file.read_text(group + "/deposits") == "particles" : file.has("/h5md");
    PhaseMoments result(is_of_particles ? Deposits::particles : Deposits::cells, static_cast<std::int64_t>(shape[1]),
                        bins, file.read_number(group + "/area"), static_cast<std::int64_t>(cycles[0]),
                        static_cast<std::int64_t>(shape[0]));
    result.sums_ = file.read<double>(group + "/sums");
    result.samples_ = file.read<std::int64_t>(group + "/samples");
    result.centre_of_mass_ = file.read<double>(group + "/centre_of_mass");
    if (!std::all_of(result.sums_.begin(), result.sums_.end(), [](double x) { return std::isfinite(x); }))
        throw files::Damaged(fmt::format("{}/sums: holds what is not a number", group));
    if (result.blocks_ == result.cycles_) {
        result.part_blocks_of_one_cycle();
        return result;
    }
    result.second_sums_.clear();
    result.second_samples_.clear();
    if (!file.has(group + "/odd_sums")) return result;  // an earlier version's
    if (file.shape(group + "/odd_sums") != shape)
        throw files::Damaged(fmt::format("{}/odd_sums: not of the shape of {}/sums", group, group));
    result.second_sums_ = file.read<double>(group + "/odd_sums");
    result.second_samples_ = file.read<std::int64_t>(group + "/odd_samples");
    if (!std::all_of(result.second_sums_.begin(), result.second_sums_.end(), [](double x) { return std::isfinite(x); }))
        throw files::Damaged(fmt::format("{}/odd_sums: holds what is not a number", group));
    return result;
}

}  // namespace shaken::fields
