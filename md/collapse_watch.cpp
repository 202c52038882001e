// SPDX-License-Identifier: MIT
#include "md/collapse_watch.hpp"

#include <fmt/format.h>

#include "md/errors.hpp"

namespace shaken::md {

void CollapseWatch::look(const Totals& now, std::int64_t cycle, double time, const std::string& last) {
    const std::int64_t contacts = now.contacts - state_.contacts;
    const auto pairs = static_cast<double>(now.pairs - state_.pairs);
    const double elapsed = time - state_.time;
    // The virial sums (1 + e)/2 times the closing speed; a particle waits N elapsed / (2 pairs) for its next contact.
    const double path = pairs > 0.0 ? (now.virial - state_.virial) / pairs * elapsed * particles_ / (2.0 * pairs) : 0.0;
    const std::string where = fmt::format("in cycle {} at t = {}", cycle, time);
    if (state_.slow_contacts >= most_slow)
        throw Stalled(fmt::format(
            "md: inelastic collapse {}: of the last {} contacts, which took a time of {:.3g}, {} closed slower than "
            "{:.1g}, the last of them between particles {} and {}. Particles lose all relative speed in more and more "
            "contacts over shorter and shorter paths. Raise particles.restitution, make slow contacts elastic as real "
            "ones are, by particles.restitution = {{ law = \"velocity\", e0 = ... }}, or choose particles.collapse = "
            "\"contact_time\" or \"elastic_below\"",
            where, contacts, elapsed, state_.slow_contacts, state_.slow, state_.first, state_.second));
    if (elapsed < stalled_time && path < stalled_path)
        throw Stalled(fmt::format(
            "md: the clock stands still {}: the last {} contacts took a time of {:.3g}, the last one between {}. {}",
            where, contacts, elapsed, last,
            collapses_ ? "Particles lose all relative speed in more and more contacts (inelastic collapse). Raise "
                         "particles.restitution, make slow contacts elastic as real ones are, by particles.restitution "
                         "= { law = \"velocity\", e0 = ... }, or choose particles.collapse = \"contact_time\" or "
                         "\"elastic_below\""
                       : "Particles touch each other without any free path, as in a full row of spheres across a box "
                         "of whole diameters: choose other sides of the box, or fewer particles"));
    state_.contacts = now.contacts;
    state_.pairs = now.pairs;
    state_.virial = now.virial;
    state_.time = time;
    state_.slow_contacts = 0;
}

}  // namespace shaken::md
