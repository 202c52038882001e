// SPDX-License-Identifier: MIT
// TERM, INT and HUP ask a run to stop with a checkpoint, USR1 asks for a checkpoint. The handlers only set flags.
#pragma once

namespace shaken::app {

void catch_signals();
bool stop_requested();
/// True once for each USR1.
bool take_checkpoint_request();

}  // namespace shaken::app
