// SPDX-License-Identifier: MIT
// The closures there are. To add one: a header beside these, and its type in a list below.
#pragma once

#include "continuum/choice.hpp"
#include "continuum/closures/carnahan_starling.hpp"
#include "continuum/closures/garzo_dufty.hpp"
#include "continuum/closures/goldshtein.hpp"
#include "continuum/closures/jenkins_richman.hpp"
#include "continuum/closures/jenkins_richman_bocquet.hpp"
#include "continuum/closures/jenkins_richman_dense.hpp"
#include "continuum/closures/jenkins_richman_fluid.hpp"

namespace shaken::continuum {

using PairCorrelations = Choices<Goldshtein, CarnahanStarling>;
using Closures = Choices<JenkinsRichman, JenkinsRichmanDense, JenkinsRichmanFluid, JenkinsRichmanBocquet, GarzoDufty>;

}  // namespace shaken::continuum
