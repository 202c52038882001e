// SPDX-License-Identifier: MIT
#include "fields/phase_moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shaken::fields {

namespace {

enum Moment : std::size_t { mass, momentum_x, momentum_y, momentum_z, second_xx, second_yy, second_zz };

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = 1e-12;

bool is_kept(const std::vector<bool>& kept, std::int64_t block) {
    return kept.empty() || kept.at(static_cast<std::size_t>(block));
}

/// Samples over degrees of freedom, of a mean taken from the samples themselves.
double freedom_lost_to_the_mean(Deposits deposits, double mass) {
    if (deposits == Deposits::cells) return 1.0;
    return mass > 1.0 ? mass / (mass - 1.0) : unknown;
}

}  // namespace

std::vector<bool> all_but(std::int64_t block, std::int64_t blocks) {
    std::vector<bool> kept(static_cast<std::size_t>(blocks), true);
    kept.at(static_cast<std::size_t>(block)) = false;
    return kept;
}

PhaseMoments::PhaseMoments(Deposits deposits, std::int64_t phases, Bins bins, double area, std::int64_t cycles,
                           std::int64_t blocks, Heights heights)
    : deposits_(deposits),
      phases_(phases),
      cycles_(cycles),
      blocks_(blocks),
      bins_(bins),
      area_(area),
      heights_(heights) {
    if (phases < 1 || bins.count < 1 || cycles < 1 || blocks < 1 || blocks > cycles || !(area > 0.0)) {
        throw std::invalid_argument(fmt::format("PhaseMoments: {} phases, {} bins, {} cycles, {} blocks, area {}",
                                                phases, bins.count, cycles, blocks, area));
    }
    sums_.resize(static_cast<std::size_t>(blocks * phases * bins.count) * moments);
    samples_.resize(static_cast<std::size_t>(blocks * phases));
    if (heights == Heights::kept) centre_of_mass_.assign(static_cast<std::size_t>(cycles * phases), unknown);
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) is_second_.push_back(cycle % 2 != 0);
    second_sums_.resize(sums_.size());
    second_samples_.resize(samples_.size());
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
    const auto sample = static_cast<std::size_t>(block_of(cycle) * phases_ + phase);
    ++samples_[sample];
    if (keeps_flows_apart() && is_of(Flow::second, cycle)) ++second_samples_[sample];
}

bool PhaseMoments::is_of(Flow flow, std::int64_t cycle) const {
    return flow == Flow::both || is_second_[static_cast<std::size_t>(cycle)] == (flow == Flow::second);
}

void PhaseMoments::deposit(std::int64_t bin, const std::array<double, moments>& amounts) {
    const std::size_t first = offset(block_of(cycle_), phase_, bin);
    for (std::size_t k = 0; k < moments; ++k) sums_[first + k] += amounts[k];
    if (!keeps_flows_apart() || !is_of(Flow::second, cycle_)) return;
    for (std::size_t k = 0; k < moments; ++k) second_sums_[first + k] += amounts[k];
}

void PhaseMoments::add_particle(double height_above_plate, const std::array<double, 3>& velocity) {
    const std::int64_t bin = bins_.index(height_above_plate);
    if (!bins_.contains(bin)) return;
    std::array<double, moments> amounts{};
    amounts[mass] = 1.0;
    for (std::size_t d = 0; d < 3; ++d) {
        amounts[momentum_x + d] = velocity[d];
        amounts[second_xx + d] = velocity[d] * velocity[d];
    }
    deposit(bin, amounts);
}

void PhaseMoments::add_slab(double lower, double upper, double density, const std::array<double, 3>& velocity,
                            double temperature, double area_share) {
    const std::int64_t first = std::max<std::int64_t>(bins_.index(lower), 0);
    const std::int64_t last = std::min(bins_.index(upper), bins_.count - 1);
    for (std::int64_t bin = first; bin <= last; ++bin) {
        const double overlap = std::min(upper, bins_.edge(bin + 1)) - std::max(lower, bins_.edge(bin));
        if (overlap <= 0.0) continue;
        const double slab_mass = density * overlap * area_ * area_share;
        std::array<double, moments> amounts{};
        amounts[mass] = slab_mass;
        for (std::size_t d = 0; d < 3; ++d) {
            amounts[momentum_x + d] = slab_mass * velocity[d];
            amounts[second_xx + d] = slab_mass * (velocity[d] * velocity[d] + temperature);
        }
        deposit(bin, amounts);
    }
}

void PhaseMoments::set_centre_of_mass(double height_lab) {
    latest_centre_of_mass_ = height_lab;
    if (heights_ == Heights::kept) centre_of_mass_[static_cast<std::size_t>(cycle_ * phases_ + phase_)] = height_lab;
}

void PhaseMoments::expect_apart(Flow flow) const {
    if (flow != Flow::both && !keeps_flows_apart())
        throw std::invalid_argument("PhaseMoments: even and odd cycles were not kept apart");
}

std::int64_t PhaseMoments::add_block(std::vector<double>& total, std::int64_t block, std::int64_t phase,
                                     Flow flow) const {
    const std::size_t begin = offset(block, phase, 0), sample = static_cast<std::size_t>(block * phases_ + phase);
    if (flow == Flow::both) {
        for (std::size_t i = 0; i < total.size(); ++i) total[i] += sums_[begin + i];
        return samples_[sample];
    }
    if (flow == Flow::second) {
        for (std::size_t i = 0; i < total.size(); ++i) total[i] += second_sums_[begin + i];
        return second_samples_[sample];
    }
    for (std::size_t bin = 0; bin < total.size(); bin += moments) {
        const double *all = &sums_[begin + bin], *second = &second_sums_[begin + bin];
        // Less mass than the round-off of the difference is none.
        if (all[mass] - second[mass] <= round_off * all[mass]) continue;
        for (std::size_t k = 0; k < moments; ++k) total[bin + k] += all[k] - second[k];
    }
    return samples_[sample] - second_samples_[sample];
}

Profile PhaseMoments::profile(std::int64_t phase, const scene::PlateMotion& motion, const std::vector<bool>& kept,
                              Flow flow) const {
    expect_apart(flow);
    const auto count = static_cast<std::size_t>(bins_.count);
    std::vector<double> total(count * moments, 0.0);
    std::int64_t samples = 0;
    for (std::int64_t block = 0; block < blocks_; ++block) {
        if (!is_kept(kept, block)) continue;
        samples += add_block(total, block, phase, flow);
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

std::vector<double> PhaseMoments::centres_of_mass(std::int64_t phase, Flow flow) const {
    std::vector<double> heights;
    for (std::int64_t cycle = 0; cycle < cycles_; ++cycle) {
        const double height = centre_of_mass_[static_cast<std::size_t>(cycle * phases_ + phase)];
        if (!std::isnan(height) && is_of(flow, cycle)) heights.push_back(height);
    }
    return heights;
}

std::pair<double, double> PhaseMoments::mean_centre_of_mass(std::int64_t phase, const std::vector<bool>& kept,
                                                            Flow flow) const {
    std::vector<double> block_sum(static_cast<std::size_t>(blocks_), 0.0), block_count(block_sum);
    for (std::int64_t cycle = 0; cycle < cycles_; ++cycle) {
        const double height = centre_of_mass_[static_cast<std::size_t>(cycle * phases_ + phase)];
        if (std::isnan(height) || !is_kept(kept, block_of(cycle)) || !is_of(flow, cycle)) continue;
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
    is_second_.insert(is_second_.end(), other.is_second_.begin(), other.is_second_.end());
    if (keeps_flows_apart() && other.keeps_flows_apart()) {
        second_sums_.insert(second_sums_.end(), other.second_sums_.begin(), other.second_sums_.end());
        second_samples_.insert(second_samples_.end(), other.second_samples_.begin(), other.second_samples_.end());
    } else {
        second_sums_.clear();
        second_samples_.clear();
    }
    blocks_ += other.blocks_;
    cycles_ += other.cycles_;
}

void PhaseMoments::exchange_flows() {
    is_second_.flip();
    if (!keeps_flows_apart()) return;
    std::vector<double> first;
    std::vector<std::int64_t> first_samples;
    for (std::int64_t block = 0; block < blocks_; ++block) {
        for (std::int64_t phase = 0; phase < phases_; ++phase) {
            std::vector<double> sums(static_cast<std::size_t>(bins_.count * moments), 0.0);
            first_samples.push_back(add_block(sums, block, phase, Flow::first));
            first.insert(first.end(), sums.begin(), sums.end());
        }
    }
    second_sums_ = std::move(first);
    second_samples_ = std::move(first_samples);
}

PhaseMoments PhaseMoments::in_whole_periods() const {
    if (cycles_ >= 2 * blocks_ || blocks_ == 1) return *this;
    PhaseMoments joined(deposits_, phases_, bins_, area_, cycles_, (blocks_ + 1) / 2);
    const auto add = [this, &joined](const auto& from, auto& to) {
        const std::size_t length = from.size() / static_cast<std::size_t>(blocks_);
        to.assign(to.empty() || from.empty() ? 0 : length * static_cast<std::size_t>(joined.blocks_), 0);
        for (std::size_t i = 0; i < from.size(); ++i) to[i / length / 2 * length + i % length] += from[i];
    };
    add(sums_, joined.sums_);
    add(samples_, joined.samples_);
    add(second_sums_, joined.second_sums_);
    add(second_samples_, joined.second_samples_);
    joined.centre_of_mass_ = centre_of_mass_;
    joined.is_second_ = is_second_;
    return joined;
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
    return first;  // of one cycle, so that nothing of it belongs to a second flow
}

std::optional<PhaseMoments> PhaseMoments::reached() const {
    const auto is_sampled = [](double height) { return !std::isnan(height); };
    const auto last = std::find_if(centre_of_mass_.rbegin(), centre_of_mass_.rend(), is_sampled);
    const std::int64_t whole = (centre_of_mass_.rend() - last) / phases_;
    if (whole == cycles_) return *this;
    if (whole == 0) return std::nullopt;
    const std::int64_t blocks = block_of(whole);  // those before the one that the next cycle belongs to
    std::int64_t cycles = whole;
    while (blocks > 0 && block_of(cycles - 1) == blocks) --cycles;
    PhaseMoments part(deposits_, phases_, bins_, area_, cycles, std::max<std::int64_t>(1, blocks));
    const auto take = [](const auto& from, auto& to) { to.assign(from.begin(), from.begin() + std::ssize(to)); };
    take(sums_, part.sums_);
    take(samples_, part.samples_);
    take(centre_of_mass_, part.centre_of_mass_);
    if (keeps_flows_apart()) {
        take(second_sums_, part.second_sums_);
        take(second_samples_, part.second_samples_);
    } else {
        part.second_sums_.clear();
        part.second_samples_.clear();
    }
    return part;
}

}  // namespace shaken::fields
