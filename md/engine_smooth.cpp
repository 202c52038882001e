// SPDX-License-Identifier: MIT
#include "md/event_loop_choice.hpp"

namespace shaken::md {

std::unique_ptr<Engine> make_smooth_engine(const Setup& setup) { return choose_event_loop<false>(setup); }

}  // namespace shaken::md
