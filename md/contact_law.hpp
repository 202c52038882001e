// SPDX-License-Identifier: MIT
// All that a scene says of contacts, as one template argument of the event loop: what is not asked for is not compiled.
#pragma once

#include <type_traits>

#include "md/friction_law.hpp"
#include "scene/restitution.hpp"

namespace shaken::md {

/// When a contact is made elastic to keep constant restitution from collapsing; 0 switches a rule off.
/// slow: contacts slower than this speed. A layer then keeps a temperature of about speed^2 where it would come to
/// rest. soon: contacts that follow another of either partner within this time, the duration of a contact (TC model:
/// Luding and McNamara 1998, Granular Matter 1, 113). Statistics do not depend on it while it is short against the mean
/// time between contacts.
struct ElasticContacts {
    double slow = 0.0;
    double soon = 0.0;
};

template <class Restitution, bool Frictional, bool Remedied>
struct ContactLaw {
    static constexpr bool frictional = Frictional, remedied = Remedied;
    /// Whether slow contacts lose as large a part of their energy as fast ones do.
    static constexpr bool collapses = !Remedied && std::is_same_v<Restitution, scene::RestitutionConstant>;
    Restitution restitution;
    WaltonFriction friction;
    ElasticContacts elastic;

    /// since: time since the last contact of whichever partner had one later. Only a remedied law looks at it.
    double operator()(double normal_speed, [[maybe_unused]] double since) const {
        if constexpr (Remedied)
            if (normal_speed < elastic.slow || since < elastic.soon) return 1.0;
        return restitution(normal_speed);
    }
};

}  // namespace shaken::md
