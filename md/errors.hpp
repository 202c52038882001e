// SPDX-License-Identifier: MIT
// What can go wrong in the event-driven engine, one type a kind; app/ maps each to its exit code.
#pragma once

#include <stdexcept>

namespace shaken::md {

struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};
struct CannotSetUp : Error {
    using Error::Error;
};  // the scene asks for what no initial state can give
struct InvariantBroken : Error {
    using Error::Error;
};  // overlap, lost particle, NaN: ours
struct Stalled : Error {
    using Error::Error;
};  // inelastic collapse: time no longer advances

}  // namespace shaken::md
