// SPDX-License-Identifier: MIT
// Trajectories in H5MD 1.1 (de Buyl, Colberg, Hoefling 2014): one file a run, read by MDAnalysis and h5py.
// Positions, velocities and box edges share one step and time; units are in /parameters/units.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "files/hdf5.hpp"
#include "files/provenance.hpp"
#include "md/audit.hpp"
#include "md/snapshot.hpp"

namespace shaken::md {

class H5mdWriter {
  public:
    /// Makes the file, replacing one that exists. Throws files::CannotCreate.
    H5mdWriter(const std::filesystem::path& path, const Box& box, const files::Provenance& provenance);

    /// One frame. `step` counts frames, events or phases as the caller likes, and must rise; `time` in sqrt(sigma/g).
    void append(const Snapshot& snapshot, std::int64_t step, double time);
    /// What has been appended survives the death of the process. Throws files::WriteFailed.
    void flush() { file_.flush(); }
    void close() { file_.close(); }
    /// For datasets of the caller's own, under /observables or groups of its name.
    files::Hdf5File& file() { return file_; }

  private:
    files::Hdf5File file_;
    Box box_;
    bool linked_ = false;
};

/// The frames of /particles/all, velocities and spins (where there are any) included. Throws files::NoInput,
/// files::Damaged.
struct H5mdFrames {
    std::vector<std::int64_t> step;
    std::vector<double> time;
    std::vector<Snapshot> frames;  // cycle and time_in_cycle are not stored: zero
    std::vector<double> phase;     // ft of each, where the file says it
    std::array<double, 3> box{};   // of the last frame, sigma
};
H5mdFrames read_h5md(const std::filesystem::path& path);

}  // namespace shaken::md
