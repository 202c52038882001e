// SPDX-License-Identifier: MIT
#include "continuum/kernels.hpp"

#include "continuum/closures/closures.hpp"
#include "continuum/flux/fluxes.hpp"
#include "continuum/reconstruct/reconstructions.hpp"
#include "continuum/sweep.hpp"

namespace shaken::continuum {

namespace {

template <class PairCorrelation>
void pressures(const double* __restrict density, const double* __restrict temperature, double* __restrict pressure,
               double* __restrict sound_speed, std::int64_t count, const Constants& constants) {
    const double virial = constants.virial;
#pragma omp simd
    for (std::int64_t i = 0; i < count; ++i) {
        const PressurePoint point = pressure_point<PairCorrelation>(density[i], temperature[i], virial);
        pressure[i] = point.pressure;
        sound_speed[i] = std::sqrt(point.sound_speed_squared);
    }
}

template <class Closure, class PairCorrelation>
void transports(const double* __restrict density, const double* __restrict temperature, const TransportArrays& out,
                std::int64_t count, const Constants& constants) {
    double* __restrict bulk = out.bulk, * __restrict shear = out.shear, * __restrict conductivity = out.conductivity, * __restrict density_conductivity = out.density_conductivity, * __restrict cooling = out.cooling;
    const double e = constants.restitution;
#pragma omp simd
    for (std::int64_t i = 0; i < count; ++i) {
        const Transport t = Closure::template transport<PairCorrelation>(density[i], temperature[i], e);
        bulk[i] = t.bulk_viscosity;
        shear[i] = t.shear_viscosity;
        conductivity[i] = t.conductivity;
        density_conductivity[i] = t.density_conductivity;
        cooling[i] = Closure::template cooling_rate<PairCorrelation>(density[i], e);
    }
}

template <class PairCorrelation>
void choose_sweep(Kernels& kernels, const scene::Continuum& choices) {
    const auto flux = [&](auto reconstruct) {
        using Reconstruct = decltype(reconstruct);
        kernels.wall = wall_stress<PairCorrelation, Reconstruct>;
        return choose(Fluxes{}, "continuum.flux", choices.flux, [&](auto f) {
            using Flux = decltype(f);
            kernels.sweep = sweep<PairCorrelation, Flux, Reconstruct>;
            // Across columns always the high order: cells are ten times wider than high there, and a pattern's wave has
            // ten of them, of which MUSCL damps as much as the gas does (tests/continuum/horizontal_waves_tests.cpp).
            kernels.sweep_horizontal = sweep<PairCorrelation, typename Flux::InSlowFlow, Weno5<false>>;
            kernels.sweep_thin = sweep<PairCorrelation, typename Flux::InSlowFlow, typename Reconstruct::AcrossColumns>;
            return true;
        });
    };
    kernels.sweep_first_order = sweep<PairCorrelation, FluxHll, Muscl<LimiterFirstOrder>>;
    choose(Schemes{}, "continuum.scheme", choices.scheme, [&](auto scheme) {
        kernels.stages = decltype(scheme)::stages;
        return decltype(scheme)::with_limiter(choices.limiter, flux);
    });
}

}  // namespace

Kernels choose_kernels(const scene::Continuum& choices) {
    Kernels kernels;
    choose(PairCorrelations{}, "continuum.pair_correlation", choices.pair_correlation, [&](auto pair) {
        using Pair = decltype(pair);
        kernels.packing = Pair::packing;
        kernels.pressure = pressures<Pair>;
        kernels.transport = choose(Closures{}, "continuum.closure", choices.closure,
                                   [](auto closure) -> TransportKernel { return transports<decltype(closure), Pair>; });
        choose_sweep<Pair>(kernels, choices);
        return true;
    });
    kernels.density_drives_heat = traits_of(choices.closure).density_drives_heat;
    if (choices.transport.name != "navier_stokes" && choices.transport.name != "inviscid")
        throw scene::unknown_choice("continuum.transport", choices.transport, {"navier_stokes", "inviscid"});
    kernels.viscous = choices.transport.name == "navier_stokes";
    return kernels;
}

}  // namespace shaken::continuum
