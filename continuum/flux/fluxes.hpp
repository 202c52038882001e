// SPDX-License-Identifier: MIT
// The numerical fluxes there are. To add one: a header beside these, and its type in the list.
#pragma once

#include "continuum/choice.hpp"
#include "continuum/flux/hll.hpp"
#include "continuum/flux/hllc.hpp"

namespace shaken::continuum {

using Fluxes = Choices<FluxHllc, FluxHll>;

}  // namespace shaken::continuum
