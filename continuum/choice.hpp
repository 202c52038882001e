// SPDX-License-Identifier: MIT
// A choice by name: a list of types, each with its name, is the one table of what there is. The chosen type is handed
// to a callable as a template argument, once, when a solver is built.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/errors.hpp"
#include "scene/parameters.hpp"

namespace shaken::continuum {

template <class... Types>
struct Choices {
    static std::vector<std::string> names() { return {std::string(Types::name)...}; }
    /// Names with words and references.
    static std::vector<scene::Name> described() { return {describe<Types>()...}; }

  private:
    template <class Type>
    static scene::Name describe() {
        scene::Name type{std::string(Type::name), std::string(Type::words), {}};
        if constexpr (requires { Type::reference; }) type.reference = Type::reference;
        return type;
    }
};

/// Calls use(T{}) for the T of the list that carries the chosen name and returns what it returns. Throws
/// scene::SceneError, showing the list, if none does.
template <class Use, class First, class... Rest>
auto choose(Choices<First, Rest...> list, const std::string& parameter, const scene::Choice& choice, Use&& use) {
    using Result = decltype(use(First{}));
    Result result{};
    bool found = false;
    const auto consider = [&](auto candidate) {
        if (found || choice.name != decltype(candidate)::name) return;
        result = use(candidate);
        found = true;
    };
    consider(First{});
    (consider(Rest{}), ...);
    if (!found) throw scene::unknown_choice(parameter, choice, list.names());
    return result;
}

}  // namespace shaken::continuum
