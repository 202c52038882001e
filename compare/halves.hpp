// SPDX-License-Identifier: MIT
// Standard errors from halves of the blocks of cycles, for numbers that move in steps or jump from one maximum to
// another (phases, places and widths of shocks). Leaving one block out seldom moves such a number, and then B - 1 times
// too much; halves move it as another run does (Shao and Wu 1989: many blocks must be left out). The error is half the
// interval that holds the middle 68 % of the halves, each deviation times sqrt(m/(B - m)) for m of B blocks kept: in a
// few of them there is another shock, or none. Right for means too, where leaving one out is less noisy
// (jackknife.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace shaken::compare {

/// Which blocks are kept: pinned random halves, each followed by its complement, so that each block is in half of them;
/// at most twenty pairs, no pair twice. None for fewer than two blocks.
std::vector<std::vector<bool>> halves_of_blocks(std::size_t blocks);

/// `values` from these halves. NaN where no more than half of them is finite: what one block alone has seen is.
double error_from_halves(std::span<const double> values, const std::vector<std::vector<bool>>& halves);

}  // namespace shaken::compare
