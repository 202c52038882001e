// SPDX-License-Identifier: MIT
// What a scene may ask of the particles besides normal restitution: friction, and a remedy against inelastic collapse.
#pragma once

namespace shaken::scene {

/// Walton 1993: tangential restitution beta0 of sticking contacts, Coulomb friction mu of sliding ones. Without spins
/// the particles do not rotate.
enum class FrictionLaw { none, walton, walton_without_spin };

struct Friction {
    FrictionLaw law = FrictionLaw::none;
    double beta0 = 0.35;
    double mu = 0.5;
};

/// How the MD keeps constant restitution from collapsing. elastic_below: contacts slower than a speed are elastic.
/// contact_time: those that follow another of either partner sooner than a time are (Luding and McNamara 1998).
enum class CollapseRemedy { none, elastic_below, contact_time };

}  // namespace shaken::scene
