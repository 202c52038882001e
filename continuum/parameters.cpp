// SPDX-License-Identifier: MIT
#include "continuum/parameters.hpp"

#include "continuum/boundary/named.hpp"
#include "continuum/closures/closures.hpp"
#include "continuum/flux/fluxes.hpp"
#include "continuum/parameters_of_tubes.hpp"
#include "continuum/reconstruct/limiters.hpp"
#include "continuum/reconstruct/reconstructions.hpp"
#include "continuum/sizes.hpp"
#include "scene/parameters.hpp"
#include "scene/read_scene.hpp"

namespace shaken::continuum {

namespace {

using scene::Kind;
using scene::Name;
using scene::ParameterVisitor;
using scene::Part;
using scene::Scene;

/// The names that every kind of run has.
void describe_choices(scene::Continuum& c, ParameterVisitor& v) {
    v.section("continuum", "granular hydrodynamics");
    v.choice({"scheme", "", "discretisation"}, c.scheme, Schemes::described());
    v.choice({"flux", "", "numerical flux (muscl, weno5)"}, c.flux, Fluxes::described());
    v.choice({"limiter", "", "slope limiter (muscl)"}, c.limiter, Limiters::described());
    v.choice({"closure", "", "transport coefficients"}, c.closure, Closures::described());
    v.choice({"pair_correlation", "", "pair correlation at contact"}, c.pair_correlation,
             PairCorrelations::described());
    v.choice(
        {"transport", "", "of momentum and heat across velocity and temperature gradients"}, c.transport,
        {{"navier_stokes", "with viscosity and conduction", ""}, {"inviscid", "without; the gas cools still", ""}});
}

void describe_restitution(scene::Continuum& c, ParameterVisitor& v) {
    v.optional_number({"restitution", "", "a constant in place of the scene's law"}, c.restitution, scene::fractions);
}

void describe_cfl(scene::Continuum& c, ParameterVisitor& v) {
    v.number({"cfl", "", "Courant number of the acoustic step (muscl, weno5)"}, c.cfl, {0.0, 1.0, true});
}

/// What the scheme ftcs alone has.
void describe_finite_differences(scene::Continuum& c, ParameterVisitor& v) {
    v.number({"artificial_dissipation", "",
              "C_AD of the scheme ftcs: C_AD dx^2 exp(-200 nu)/dt is added to the diffusion of u and T"},
             c.artificial_dissipation, {0.0, 1.0});
    v.number({"diffusion_factor", "", "s of the scheme ftcs: its step is at most s n dx^2 over mu, lambda and kappa"},
             c.diffusion_factor, {0.0, 10.0, true});
}

void describe_layer(scene::Continuum& c, ParameterVisitor& v) {
    describe_choices(c, v);
    v.choice({"dimension", "", "of the grid"}, c.dimension,
             {{"auto", "1 for a start uniform in x and y, 2 in a strip, else 3", ""},
              {"1", "one column", ""},
              {"2", "columns along the longer side of the box", ""},
              {"3", "columns along both sides", ""}});
    describe_restitution(c, v);
    v.number({"spacing", "sigma", "vertical grid spacing; the nearest that divides the height"}, c.spacing,
             {1e-4, 10.0});
    v.number({"spacing_horizontal", "sigma", "horizontal grid spacing; the nearest that divides a side"},
             c.spacing_horizontal, {1e-3, 1e6});
    v.number({"lid", "sigma", "height of the upper end above the plate, with which it moves"}, c.lid, {2.0, 1e6});
    v.choice({"lower", "", "what the layer lies on"}, c.lower, ends_below_layer());
    v.choice({"upper", "", "the end at lid; where none is written: stress_free, with scheme ftcs lid"}, c.upper,
             ends_above_layer());
    v.optional_number({"lower_temperature", "g sigma", "of a heated lower end"}, c.lower_temperature, scene::positive);
    v.optional_number({"upper_temperature", "g sigma", "of a heated upper end"}, c.upper_temperature, scene::positive);
    describe_cfl(c, v);
    describe_finite_differences(c, v);
    v.number({"floor_density", "",
              "least density at the start, under ftcs at all times (1e-3 by default, and no less), relative to the "
              "mean density N/(x y lid)"},
             c.floor_density, {0.0, 0.1, true});
    v.number({"floor_temperature", "g sigma", "least temperature"}, c.floor_temperature, {0.0, 1.0, true});
}

void describe_start(scene::Initial& i, ParameterVisitor& v) {
    v.number({"noise", "", "relative amplitude of random density noise", Part::start}, i.noise, {0.0, 0.5});
    v.number({"wave", "", "relative amplitude of one cosine wave of density", Part::start}, i.wave, {0.0, 0.5});
    v.whole({"wave_x", "", "its waves along the box's side x", Part::start}, i.wave_x, {0.0, 10000.0});
    v.whole({"wave_y", "", "its waves along the box's side y", Part::start}, i.wave_y, {0.0, 10000.0});
}

void describe_shared(Scene& s, std::string_view section, ParameterVisitor& v) {
    if (s.kind == Kind::layer && section == "initial") describe_start(s.initial, v);
}

void describe_own(Scene& s, ParameterVisitor& v) {
    scene::Continuum& c = s.continuum;
    if (s.kind == Kind::layer) return describe_layer(c, v);
    if (s.kind == Kind::uniform) {
        describe_choices(c, v);
        return describe_restitution(c, v);
    }
    describe_tube(s, v);
    describe_choices(c, v);
    v.number({"spacing", "sigma", "grid spacing; the nearest that divides the length"}, c.spacing, scene::positive);
    describe_cfl(c, v);
    describe_finite_differences(c, v);
    v.number({"floor_density", "", "of the scheme ftcs: least density, at least 1e-3, relative to the mean"},
             c.floor_density, {0.0, 0.1, true});
}

}  // namespace

const scene::KeyOwner keys{"continuum", describe_shared, describe_own, check_sizes};

scene::Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    return scene::read_scene(path, scene::alone(keys), overrides);
}

scene::Scene parse_scene(const std::string& text, const std::string& source,
                         const std::vector<std::string>& overrides) {
    return scene::parse_scene(text, source, scene::alone(keys), overrides);
}

}  // namespace shaken::continuum
