// SPDX-License-Identifier: MIT
#include "continuum/names.hpp"

#include "continuum/boundary/named.hpp"
#include "continuum/closures/closures.hpp"
#include "continuum/flux/fluxes.hpp"
#include "continuum/reconstruct/limiters.hpp"
#include "continuum/reconstruct/reconstructions.hpp"

namespace shaken::continuum {

std::vector<std::pair<std::string, std::vector<std::string>>> known_names() {
    return {{"scheme", Schemes::names()},
            {"flux", Fluxes::names()},
            {"limiter", Limiters::names()},
            {"closure", Closures::names()},
            {"pair_correlation", PairCorrelations::names()},
            {"lower", ends_below_layer()},
            {"upper", ends_above_layer()}};
}

}  // namespace shaken::continuum
