// SPDX-License-Identifier: MIT
// Phase averages: sums of mass, momentum and second moments of velocity, by phase of the cycle and height above the
// plate. One rule for both engines: particles deposit themselves, continuum cells deposit the same moments of the
// distribution they stand for, so a difference between profiles is never one of averaging. In particular a gradient
// of u inside a bin adds to T alike in both (about (du/dz)^2 width^2 / 12 / 3).
// Particles scatter about a mean taken from themselves, which costs each component one degree of freedom: T of M of
// them is M/(M - 1) times their mean square deviation, and unknown for M = 1. A cell knows its mean and has T already.
// Sums are kept in blocks of cycles, from which standard errors follow by leaving blocks out.
// A layer whose period is two cycles has two flows, of even and of odd cycles: the sums of the second are kept beside
// those of all, so that each can be averaged apart. The first is the difference, to round-off of the sum of both.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fields/bins.hpp"
#include "fields/profile.hpp"
#include "files/checkpoint.hpp"
#include "files/hdf5.hpp"
#include "scene/plate_motion.hpp"

namespace shaken::fields {

/// What is deposited.
enum class Deposits { particles, cells };

/// Whose cycles: all, or every other one. The second flow is that of odd cycles until exchange_flows().
enum class Flow { both, first, second };

/// Whether the height of the centre of mass of every cycle is kept here, or by whoever asks for the latest one: memory
/// then does not grow with the cycles.
enum class Heights { kept, passed_on };

/// Which of so many blocks are kept where one is left out.
std::vector<bool> all_but(std::int64_t block, std::int64_t blocks);

class PhaseMoments {
  public:
    /// Moments kept for each bin: mass, three momenta, three diagonal second moments.
    static constexpr int moments = 7;

    /// area: horizontal area of the cell, sigma^2. cycles: how many will be averaged. blocks <= cycles.
    PhaseMoments(Deposits deposits, std::int64_t phases, Bins bins, double area, std::int64_t cycles,
                 std::int64_t blocks, Heights heights = Heights::kept);

    /// Names the instant that the following deposits belong to: cycle counts from 0 at the start of averaging.
    void begin_sample(std::int64_t cycle, std::int64_t phase);
    /// One particle of unit mass.
    void add_particle(double height_above_plate, const std::array<double, 3>& velocity);
    /// One continuum cell between two heights: number density, lab-frame velocity, isotropic temperature; shared among
    /// the bins it overlaps. `area_share` is the cell's share of the horizontal area (1 for a column).
    void add_slab(double lower, double upper, double density, const std::array<double, 3>& velocity, double temperature,
                  double area_share = 1.0);

    std::int64_t phases() const { return phases_; }
    std::int64_t blocks() const { return blocks_; }
    std::int64_t cycles() const { return cycles_; }
    const Bins& bins() const { return bins_; }
    double area() const { return area_; }

    /// Averages over all blocks, or over those with a true entry in `kept`, of a flow that keeps_flows_apart(), else
    /// std::invalid_argument. NaN where unknown: everything at a phase that was never sampled, u and T of an empty bin,
    /// T of one that a single particle visited.
    Profile profile(std::int64_t phase, const scene::PlateMotion& motion, const std::vector<bool>& kept = {},
                    Flow flow = Flow::both) const;

    /// Height of the centre of mass, lab frame, of every particle or slab ever deposited at this phase and cycle.
    /// Shape (cycles, phases); NaN where not sampled.
    const std::vector<double>& centre_of_mass() const { return centre_of_mass_; }
    /// The same of one phase, of every cycle of a flow at which it was sampled.
    std::vector<double> centres_of_mass(std::int64_t phase, Flow flow = Flow::both) const;
    /// Set by the owner of the sample, which knows all the mass (bins may end below the ceiling).
    void set_centre_of_mass(double height_lab);
    double latest_centre_of_mass() const { return latest_centre_of_mass_; }
    /// Mean over cycles and its standard error over blocks, at a phase; NaN where unknown.
    std::pair<double, double> mean_centre_of_mass(std::int64_t phase, const std::vector<bool>& kept = {},
                                                  Flow flow = Flow::both) const;

    /// False for what an earlier version wrote of blocks of more than one cycle.
    bool keeps_flows_apart() const { return !second_sums_.empty(); }
    /// The second flow becomes the first.
    void exchange_flows();
    /// Joins neighbouring blocks where some hold a single cycle, so that leaving a block out leaves out whole periods
    /// of two; otherwise as it is.
    PhaseMoments in_whole_periods() const;

    /// Takes the blocks of another run of the same layer and engine in after its own: the average is then over both,
    /// flow by flow, and errors are over the blocks of both. Throws std::invalid_argument unless deposits, phases,
    /// bins, area and cycles in a block agree.
    void append(const PhaseMoments& other);
    /// Of every phase the first cycle that has it, as one block: a run that began in the middle of a cycle, followed
    /// until that phase comes again. Throws std::invalid_argument where cycles share a block, since a block keeps sums.
    PhaseMoments first_cycle() const;
    /// Of a run that was stopped or killed: its whole blocks, or, before the end of the first, its whole cycles as one;
    /// nothing before the end of the first cycle. A run that ended is as it was.
    std::optional<PhaseMoments> reached() const;

    /// Of a run that sampled itself: neither appended to nor exchanged.
    void save(files::CheckpointWriter& out, const std::string& prefix) const;
    void restore(const files::CheckpointReader& in, const std::string& prefix);
    /// Heights that are passed on are not written here: GROUP/centre_of_mass (cycles, phases) is their keeper's.
    void write(files::Hdf5File& file, const std::string& group) const;
    /// A file that does not say what was deposited holds particles if it is an H5MD file.
    static PhaseMoments read(const files::Hdf5File& file, const std::string& group);

  private:
    std::size_t offset(std::int64_t block, std::int64_t phase, std::int64_t bin) const;
    void deposit(std::int64_t bin, const std::array<double, moments>& amounts);
    void expect_apart(Flow flow) const;
    /// Adds a block's sums of a flow at a phase to `total`, (bins, moments); how many samples it holds.
    std::int64_t add_block(std::vector<double>& total, std::int64_t block, std::int64_t phase, Flow flow) const;
    bool is_of(Flow flow, std::int64_t cycle) const;
    /// Where each block is one cycle, the second flow is the blocks of its cycles.
    void part_blocks_of_one_cycle();
    std::int64_t block_of(std::int64_t cycle) const { return cycle * blocks_ / cycles_; }

    Deposits deposits_;
    std::int64_t phases_, cycles_, blocks_;
    Bins bins_;
    double area_;
    std::int64_t cycle_ = 0, phase_ = 0;
    Heights heights_;
    double latest_centre_of_mass_ = 0.0;
    std::vector<double> sums_;            // (blocks, phases, bins, moments)
    std::vector<std::int64_t> samples_;   // (blocks, phases)
    std::vector<double> centre_of_mass_;  // (cycles, phases); empty where passed on
    std::vector<bool> is_second_;         // (cycles)
    // Of the second flow alone, shapes as above; empty where it is not known.
    std::vector<double> second_sums_;
    std::vector<std::int64_t> second_samples_;
};

}  // namespace shaken::fields
