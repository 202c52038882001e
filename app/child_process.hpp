// SPDX-License-Identifier: MIT
// Other programs: this command again as a child, and the Python that draws.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shaken::app {

/// A running child; its standard streams are ours.
class ChildProcess {
  public:
    enum class Kind {
        plain,
        silent,     // what it says goes nowhere; too brief to be stopped
        listening,  // calls catch_signals(), for which the signals of app/signals.hpp wait
    };
    /// Starts `program` (a path, or a name to be found on PATH). Throws std::runtime_error if it cannot be started.
    ChildProcess(const std::string& program, const std::vector<std::string>& arguments, Kind kind = Kind::plain);
    /// Exit code if it has ended (128 + signal if killed by one), nothing while it runs.
    std::optional<int> poll();
    int wait();
    /// wait(), but passes a wish to stop on to the child.
    int wait_or_stop();
    void signal(int number) const;

  private:
    static int code_of(int wait_status);
    pid_t pid_ = -1;
    std::optional<int> code_;
};

/// Path of the running command.
std::filesystem::path own_path();

/// Folder of what the command needs at run time besides itself: the installed share/shaken, or the source tree.
std::filesystem::path share_folder();

/// A Python 3 that has matplotlib, h5py and numpy: $SHAKEN_PYTHON, python3 on PATH, /usr/bin/python3, in that order.
/// Throws files::NoInput with the names of the packages if there is none.
std::string drawing_python();

}  // namespace shaken::app
