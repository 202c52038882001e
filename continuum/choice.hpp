// SPDX-License-Identifier: MIT
// A choice by name: a list of types, each with its name, is the one table of what there is. The chosen type is handed
// to a callable as a template argument, once, when a solver is built.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/errors.hpp"

namespace shaken::continuum {

/// What a list says of one of its types.
struct Described {
    std::string name, words;
    std::string reference;  // empty where the words say all
};

template <class... Types>
struct Choices {
    static std::vector<std::string> names() { return {std::string(Types::name)...}; }
    static std::vector<Described> described() { return {describe<Types>()...}; }

  private:
    template <class Type>
    static Described describe() {
        Described type{std::string(Type::name), std::string(Type::words), {}};
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
