// SPDX-License-Identifier: MIT
// The closures there are. To add one: a header beside these, with its formulas and its traits, and its type in a list
// below. Whoever has to know more of a closure than its formulas asks the traits, and never for a name.
#pragma once

#include <concepts>
#include <string_view>

#include "continuum/choice.hpp"
#include "continuum/closures/carnahan_starling.hpp"
#include "continuum/closures/garzo_dufty.hpp"
#include "continuum/closures/goldshtein.hpp"
#include "continuum/closures/jenkins_richman.hpp"
#include "continuum/closures/jenkins_richman_bocquet.hpp"
#include "continuum/closures/jenkins_richman_dense.hpp"
#include "continuum/closures/jenkins_richman_fluid.hpp"

namespace shaken::continuum {

template <class C>
concept IsClosure = requires(double x) {
    { C::name } -> std::convertible_to<std::string_view>;
    { C::words } -> std::convertible_to<std::string_view>;
    { C::reference } -> std::convertible_to<std::string_view>;
    // Whether it has a heat flux along the density gradient.
    { C::density_drives_heat } -> std::convertible_to<bool>;
    // Whether particles carry momentum and heat between their contacts: the terms in 1/G, by which viscosity and
    // conductivity of thin gas do not vanish with its density.
    { C::carries_between_contacts } -> std::convertible_to<bool>;
    { C::cooling_share(x) } -> std::same_as<double>;
    { C::template transport<Goldshtein>(x, x, x) } -> std::same_as<Transport>;
    { C::template cooling_rate<Goldshtein>(x, x) } -> std::same_as<double>;
};

template <IsClosure... Types>
using ClosureList = Choices<Types...>;

using PairCorrelations = Choices<Goldshtein, CarnahanStarling>;
using Closures =
    ClosureList<JenkinsRichman, JenkinsRichmanDense, JenkinsRichmanFluid, JenkinsRichmanBocquet, GarzoDufty>;

/// The traits of a chosen closure, without its formulas.
struct ClosureTraits {
    bool density_drives_heat = false, carries_between_contacts = true;
    double (*cooling_share)(double restitution) = nullptr;
};

/// Throws scene::SceneError, at its place, for a name that is not in the list.
inline ClosureTraits traits_of(const scene::Choice& closure) {
    return choose(Closures{}, "continuum.closure", closure, [](auto chosen) -> ClosureTraits {
        using Closure = decltype(chosen);
        return {Closure::density_drives_heat, Closure::carries_between_contacts, &Closure::cooling_share};
    });
}

/// Whether any formula of the closure is asked: none in an inviscid gas of elastic particles.
inline bool closure_has_part(const scene::Continuum& choices, double restitution) {
    return choices.transport.name != "inviscid" || restitution < 1.0;
}

}  // namespace shaken::continuum
