// SPDX-License-Identifier: MIT
#include "fields/phase_moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "files/errors.hpp"

namespace shaken::fields {

namespace {

enum Moment : std::size_t { mass, momentum_x, momentum_y, momentum_z, second_xx, second_yy, second_zz };

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Samples over degrees of freedom, of a mean taken from the samples themselves.
double freedom_lost_to_the_mean(Deposits deposits, double mass) {
    if (deposits == Deposits::cells) return 1.0;
    return mass > 1.0 ? mass / (mass - 1.0) : unknown;
}

}  // namespace

PhaseMoments::PhaseMoments(Deposits deposits, std::int64_t phases, Bins bins, double area, std::int64_t cycles,
                           std::int64_t blocks)
    : deposits_(deposits), phases_(phases), cycles_(cycles), blocks_(blocks), bins_(bins), area_(area) {
    if (phases < 1 || bins.count < 1 || cycles < 1 || blocks < 1 || blocks > cycles || !(area > 0.0)) {
        throw std::invalid_argument(fmt::format("PhaseMoments: {} phases, {} bins, {} cycles, {} blocks, area {}",
                                                phases, bins.count, cycles, blocks, area));
    }
    sums_.resize(static_cast<std::size_t>(blocks * phases * bins.count) * moments);
    samples_.resize(static_cast<std::size_t>(blocks * phases));
    centre_of_mass_.assign(static_cast<std::size_t>(cycles * phases), unknown);
}

std::size_t PhaseMoments::offset(std::int64_t block, std::int64_t phase, std::int64_t bin) const {
    return static_cast<std::size_t>((block * phases_ + phase) * bins_.count + bin) * moments;
}

void PhaseMoments::begin_sample(std::int64_t cycle, std::int64_t phase) {
    if (cycle < 0 || cycle >= cycles_ || phase < 0 || phase >= phases_) {
        throw std::out_of_range(fmt::format("PhaseMoments: no cycle {} phase {}", cycle, phase));
    }
    cycle_ = cycle;
    phase_ = phase;
    ++samples_[static_cast<std::size_t>(block_of(cycle) * phases_ + phase)];
}

void PhaseMoments::add_particle(double height_above_plate, const std::array<double, 3>& velocity) {
    const std::int64_t bin = bins_.index(height_above_plate);
    if (!bins_.contains(bin)) return;
    double* sum = &sums_[offset(block_of(cycle_), phase_, bin)];
    sum[mass] += 1.0;
    for (std::size_t d = 0; d < 3; ++d) {
        sum[momentum_x + d] += velocity[d];
        sum[second_xx + d] += velocity[d] * velocity[d];
    }
}

void PhaseMoments::add_slab(double lower, double upper, double density, const std::array<double, 3>& velocity,
                            double temperature, double area_share) {
    const std::int64_t first = std::max<std::int64_t>(bins_.index(lower), 0);
    const std::int64_t last = std::min(bins_.index(upper), bins_.count - 1);
    for (std::int64_t bin = first; bin <= last; ++bin) {
        const double overlap = std::min(upper, bins_.edge(bin + 1)) - std::max(lower, bins_.edge(bin));
        if (overlap <= 0.0) continue;
        const double slab_mass = density * overlap * area_ * area_share;
        double* sum = &sums_[offset(block_of(cycle_), phase_, bin)];
        sum[mass] += slab_mass;
        for (std::size_t d = 0; d < 3; ++d) {
            sum[momentum_x + d] += slab_mass * velocity[d];
            sum[second_xx + d] += slab_mass * (velocity[d] * velocity[d] + temperature);
        }
    }
}

void PhaseMoments::set_centre_of_mass(double height_lab) {
    centre_of_mass_[static_cast<std::size_t>(cycle_ * phases_ + phase_)] = height_lab;
}

Profile PhaseMoments::profile(std::int64_t phase, const scene::PlateMotion& motion,
                              std::optional<std::int64_t> left_out_block) const {
    const auto count = static_cast<std::size_t>(bins_.count);
    std::vector<double> total(count * moments, 0.0);
    std::int64_t samples = 0;
    for (std::int64_t block = 0; block < blocks_; ++block) {
        if (left_out_block && *left_out_block == block) continue;
        samples += samples_[static_cast<std::size_t>(block * phases_ + phase)];
        const double* sum = &sums_[offset(block, phase, 0)];
        for (std::size_t i = 0; i < total.size(); ++i) total[i] += sum[i];
    }
    Profile p;
    p.phase = static_cast<double>(phase) / static_cast<double>(phases_);
    p.bins = bins_;
    const double time = p.phase * motion.period();
    p.plate_height = motion.position(time);
    p.plate_velocity = motion.velocity(time);
    for (auto* field : {&p.density, &p.velocity, &p.temperature, &p.temperature_z, &p.temperature_x})
        field->assign(count, unknown);
    if (samples == 0) return p;
    const double bin_volume = area_ * bins_.width * static_cast<double>(samples);
    for (std::size_t i = 0; i < count; ++i) {
        const double* sum = &total[i * moments];
        p.density[i] = sum[mass] / bin_volume;
        if (sum[mass] <= 0.0) continue;
        p.velocity[i] = sum[momentum_z] / sum[mass];
        const double freedom = freedom_lost_to_the_mean(deposits_, sum[mass]);
        std::array<double, 3> variance{};
        for (std::size_t d = 0; d < 3; ++d) {
            const double mean = sum[momentum_x + d] / sum[mass];
            // Cancellation must not make it negative.
            variance[d] = freedom * std::max(0.0, sum[second_xx + d] / sum[mass] - mean * mean);
        }
        p.temperature[i] = (variance[0] + variance[1] + variance[2]) / 3.0;
        p.temperature_z[i] = variance[2];
        p.temperature_x[i] = 0.5 * (variance[0] + variance[1]);
    }
    return p;
}

std::pair<double, double> PhaseMoments::mean_centre_of_mass(std::int64_t phase,
                                                            std::optional<std::int64_t> left_out_block) const {
    std::vector<double> block_sum(static_cast<std::size_t>(blocks_), 0.0), block_count(block_sum);
    for (std::int64_t cycle = 0; cycle < cycles_; ++cycle) {
        const double height = centre_of_mass_[static_cast<std::size_t>(cycle * phases_ + phase)];
        if (std::isnan(height) || left_out_block == block_of(cycle)) continue;
        block_sum[static_cast<std::size_t>(block_of(cycle))] += height;
        block_count[static_cast<std::size_t>(block_of(cycle))] += 1.0;
    }
    double sum = 0.0, count = 0.0;
    for (std::size_t b = 0; b < block_sum.size(); ++b) {
        sum += block_sum[b];
        count += block_count[b];
    }
    const double mean = sum / count;
    double spread = 0.0, used = 0.0;
    for (std::size_t b = 0; b < block_sum.size(); ++b) {
        if (block_count[b] == 0.0) continue;
        const double deviation = block_sum[b] / block_count[b] - mean;
        spread += deviation * deviation;
        used += 1.0;
    }
    const double error = used > 1.0 ? std::sqrt(spread / (used * (used - 1.0))) : unknown;
    return {mean, error};
}

void PhaseMoments::append(const PhaseMoments& other) {
    const bool is_alike = deposits_ == other.deposits_ && phases_ == other.phases_ &&
                          bins_.lower == other.bins_.lower && bins_.width == other.bins_.width &&
                          bins_.count == other.bins_.count && area_ == other.area_;
    // Whole blocks of one length, so that cycles still fall into their own blocks when they are counted through.
    const bool is_even = cycles_ % blocks_ == 0 && other.cycles_ % other.blocks_ == 0 &&
                         cycles_ / blocks_ == other.cycles_ / other.blocks_;
    if (!is_alike || !is_even) {
        throw std::invalid_argument(fmt::format(
            "runs cannot be averaged: {} and {} phases, {} and {} bins, {} and {} cycles in {} and {} blocks", phases_,
            other.phases_, bins_.count, other.bins_.count, cycles_, other.cycles_, blocks_, other.blocks_));
    }
    sums_.insert(sums_.end(), other.sums_.begin(), other.sums_.end());
    samples_.insert(samples_.end(), other.samples_.begin(), other.samples_.end());
    centre_of_mass_.insert(centre_of_mass_.end(), other.centre_of_mass_.begin(), other.centre_of_mass_.end());
    blocks_ += other.blocks_;
    cycles_ += other.cycles_;
}

PhaseMoments PhaseMoments::first_cycle() const {
    if (blocks_ != cycles_) {
        throw std::invalid_argument(
            fmt::format("single cycles are kept of up to ten averaged; this run averaged {}", cycles_));
    }
    PhaseMoments first(deposits_, phases_, bins_, area_, 1, 1);
    const auto of_phase = static_cast<std::size_t>(bins_.count * moments);
    for (std::int64_t phase = 0; phase < phases_; ++phase) {
        const auto p = static_cast<std::size_t>(phase);
        for (std::int64_t cycle = 0; cycle < cycles_; ++cycle) {
            const auto i = static_cast<std::size_t>(cycle * phases_ + phase);
            if (samples_[i] == 0) continue;
            first.samples_[p] = samples_[i];
            first.centre_of_mass_[p] = centre_of_mass_[i];
            std::copy_n(&sums_[offset(cycle, phase, 0)], of_phase, &first.sums_[first.offset(0, phase, 0)]);
            break;
        }
    }
    return first;
}

void PhaseMoments::save(files::CheckpointWriter& out, const std::string& prefix) const {
    out.put(prefix + "sums", sums_);
    out.put(prefix + "samples", samples_);
    out.put(prefix + "centre_of_mass", centre_of_mass_);
}

void PhaseMoments::restore(const files::CheckpointReader& in, const std::string& prefix) {
    in.take_into(prefix + "sums", std::span(sums_));
    in.take_into(prefix + "samples", std::span(samples_));
    in.take_into(prefix + "centre_of_mass", std::span(centre_of_mass_));
}

void PhaseMoments::write(files::Hdf5File& file, const std::string& group) const {
    const auto u = [](std::int64_t n) { return static_cast<std::uint64_t>(n); };
    file.write<double>(group + "/sums", sums_, {u(blocks_), u(phases_), u(bins_.count), moments});
    file.write<std::int64_t>(group + "/samples", samples_, {u(blocks_), u(phases_)});
    file.write<double>(group + "/centre_of_mass", centre_of_mass_, {u(cycles_), u(phases_)});
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
    return result;
}

}  // namespace shaken::fields
