// SPDX-License-Identifier: MIT
// TERM, INT and HUP ask a run to stop with a checkpoint, USR1 asks for a checkpoint. The handlers only set flags.
// A child is born with these signals held back and lets them in once it listens, so that none is lost or deadly before.
#pragma once

#include <csignal>

namespace shaken::app {

/// From here on the signals set flags; those that came while they were held back do so now.
void catch_signals();
bool stop_requested();
/// True once for each USR1.
bool take_checkpoint_request();

/// Holds the signals back while it lives, then puts things as they were.
class SignalsHeld {
  public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    /// In a child that never listens: the signals end it, also those that came meanwhile.
    void let_in_to_end_it() const;

  private:
    sigset_t before_;
};

}  // namespace shaken::app
