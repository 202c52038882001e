// SPDX-License-Identifier: MIT
// The table of event loops: restitution law, remedy against collapse, kind of walls; friction is chosen by the caller.
#pragma once

#include <memory>
#include <variant>

#include "md/event_loop.hpp"

namespace shaken::md {

template <class Law>
std::unique_ptr<Engine> event_loop_of(const Setup& setup, const Law& law) {
    if (setup.box.periodic_z) return std::make_unique<EventLoop<Law, false>>(setup, law);
    return std::make_unique<EventLoop<Law, true>>(setup, law);
}

template <bool Frictional>
std::unique_ptr<Engine> choose_event_loop(const Setup& setup) {
    const bool remedied = setup.elastic.slow > 0.0 || setup.elastic.soon > 0.0;
    const WaltonFriction friction = setup.friction.value_or(WaltonFriction{});
    return std::visit(
        [&]<class Restitution>(const Restitution& e) {
            return remedied
                       ? event_loop_of(setup, ContactLaw<Restitution, Frictional, true>{e, friction, setup.elastic})
                       : event_loop_of(setup, ContactLaw<Restitution, Frictional, false>{e, friction, setup.elastic});
        },
        setup.restitution);
}

}  // namespace shaken::md
