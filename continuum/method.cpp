// SPDX-License-Identifier: MIT
#include "continuum/method.hpp"

#include "continuum/evolution.hpp"
#include "continuum/ftcs/ftcs.hpp"

namespace shaken::continuum {

std::unique_ptr<Method> make_method(Setup setup) {
    if (setup.choices.scheme.name == Ftcs::name) return std::make_unique<Ftcs>(std::move(setup));
    return std::make_unique<Evolution>(std::move(setup));
}

}  // namespace shaken::continuum
