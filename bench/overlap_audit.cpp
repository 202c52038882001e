// SPDX-License-Identifier: MIT
// Do spheres ever overlap? A dense elastic gas, all pairs looked at every ten million collisions, one line each time:
// overlap_audit PARTICLES COLLISIONS. Ends with 1 as soon as an overlap of 1e-12 sigma shows, between two audits or at
// a contact.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "md/simulation.hpp"

using namespace shaken;

int main(int count, char** words) {
    if (count != 3) {
        fmt::print(stderr, "usage: overlap_audit PARTICLES COLLISIONS\n");
        return 64;
    }
    constexpr std::int64_t between_audits = 10'000'000;
    constexpr double allowed = 1e-12;
    md::UniformSystem system;
    system.particles = std::atoll(words[1]);
    system.volume_fraction = 0.49;
    const std::int64_t all = std::atoll(words[2]);
    md::Simulation simulation(system);
    const double energy = simulation.ledger().kinetic;
    double largest = 0.0;
    for (std::int64_t done = 0; done < all; done += between_audits) {
        simulation.advance_collisions(between_audits);
        const md::Ledger now = simulation.ledger();
        const double apart = simulation.audit().largest_overlap, contact = simulation.counters().deepest_contact;
        largest = std::max({largest, apart, contact});
        fmt::print(
            "{{\"collisions\":{},\"time\":{},\"overlap_now\":{:.3g},\"deepest_contact\":{:.3g},"
            "\"energy_change\":{:.3g},\"momentum\":{:.3g}}}\n",
            done + between_audits, simulation.cycle(), apart, contact, now.kinetic / energy - 1.0,
            std::hypot(now.momentum[0], now.momentum[1], now.momentum[2]));
        std::fflush(stdout);
        if (largest >= allowed) return 1;
    }
    return 0;
}
