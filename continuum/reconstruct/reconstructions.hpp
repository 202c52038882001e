// SPDX-License-Identifier: MIT
// The schemes there are: a reconstruction and the time integrator that goes with it. To add one: its header beside
// these, and a struct in the list with its name and the keys of [continuum] that have no part in it.
#pragma once

#include <array>
#include <string_view>

#include "continuum/choice.hpp"
#include "continuum/reconstruct/limiters.hpp"
#include "continuum/reconstruct/muscl.hpp"
#include "continuum/reconstruct/weno5.hpp"
#include "continuum/time_integrator.hpp"

namespace shaken::continuum {

/// Second order in space and time: MUSCL along columns, WENO across them, where cells are wide (kernels.cpp).
struct SchemeMuscl {
    static constexpr std::string_view name = "muscl";
    static constexpr std::string_view words = "finite volumes, second order in space and time";
    static constexpr std::array<std::string_view, 2> unused{"artificial_dissipation", "diffusion_factor"};
    static constexpr std::span<const Stage> stages = ssp_rk2;

    template <class Use>
    static bool with_limiter(const scene::Choice& limiter, const Use& use) {
        return choose(Limiters{}, "continuum.limiter", limiter, [&](auto l) { return use(Muscl<decltype(l)>{}); });
    }
};

/// Fifth order in space (one dimension, without transport), third in time.
struct SchemeWeno5 {
    static constexpr std::string_view name = "weno5";
    static constexpr std::string_view words = "finite volumes, fifth order in space (waves along z), third in time";
    static constexpr std::array<std::string_view, 3> unused{"limiter", "artificial_dissipation", "diffusion_factor"};
    static constexpr std::span<const Stage> stages = ssp_rk3;

    template <class Use>
    static bool with_limiter(const scene::Choice& limiter, const Use& use) {
        choose(Limiters{}, "continuum.limiter", limiter, [](auto) { return true; });
        return use(Weno5<>{});
    }
};

/// The source's finite differences (continuum/ftcs/): no fluxes, so nothing is reconstructed.
struct SchemeFtcs {
    static constexpr std::string_view name = "ftcs";
    static constexpr std::string_view words = "the source's finite differences, first order in time; for comparison";
    static constexpr std::array<std::string_view, 3> unused{"flux", "limiter", "cfl"};
    static constexpr std::span<const Stage> stages = forward_euler;

    template <class Use>
    static bool with_limiter(const scene::Choice& limiter, const Use& use) {
        choose(Limiters{}, "continuum.limiter", limiter, [](auto) { return true; });
        return use(Muscl<LimiterFirstOrder>{});
    }
};

using Schemes = Choices<SchemeMuscl, SchemeWeno5, SchemeFtcs>;

}  // namespace shaken::continuum
