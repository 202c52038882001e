// SPDX-License-Identifier: MIT
// The books of a flow: what entered and left it, as sums that a step adds to, column by column or of all.
#pragma once

#include <array>

namespace shaken::continuum {

/// Totals per horizontal area, since the start. Energies are in the frame of the plate:
/// energy = initial_energy + body_force_work - collisional_loss + floor_gain + dual_energy_gain + boundary_gain, to
/// round-off; and potential_gain = -gravity_work to round-off (finite volumes between ends that nothing passes).
struct Ledger {
    double energy = 0.0;  // 3/2 n T + n u^2 / 2, now
    double initial_energy = 0.0;
    double body_force_work = 0.0;   // of gravity and of the frame's acceleration
    double gravity_work = 0.0;      // of gravity alone, which is a part of it
    double potential_gain = 0.0;    // g times what n z has gained since the start, from the state
    double collisional_loss = 0.0;  // the sink gamma
    double floor_gain = 0.0;        // heat added where the temperature met its floor
    double dual_energy_gain = 0.0;  // difference where the internal energy equation is trusted over the total energy
    double boundary_gain = 0.0;     // through heated walls and open ends
    double plate_impulse = 0.0;     // integral over time of the normal stress on the plate
    double lid_impulse = 0.0;       // the same on the upper end

    Ledger& operator+=(const Ledger& other);
    Ledger& operator-=(const Ledger& other);
    Ledger& operator*=(double factor);
};

inline constexpr std::array entries_of_ledger{
    &Ledger::energy,         &Ledger::initial_energy,   &Ledger::body_force_work, &Ledger::gravity_work,
    &Ledger::potential_gain, &Ledger::collisional_loss, &Ledger::floor_gain,      &Ledger::dual_energy_gain,
    &Ledger::boundary_gain,  &Ledger::plate_impulse,    &Ledger::lid_impulse};
static_assert(sizeof(Ledger) == entries_of_ledger.size() * sizeof(double), "every entry is in the list");

inline Ledger& Ledger::operator+=(const Ledger& other) {
    for (const auto entry : entries_of_ledger) this->*entry += other.*entry;
    return *this;
}
inline Ledger& Ledger::operator-=(const Ledger& other) {
    for (const auto entry : entries_of_ledger) this->*entry -= other.*entry;
    return *this;
}
inline Ledger& Ledger::operator*=(double factor) {
    for (const auto entry : entries_of_ledger) this->*entry *= factor;
    return *this;
}
inline Ledger operator+(Ledger one, const Ledger& other) { return one += other; }
inline Ledger operator-(Ledger one, const Ledger& other) { return one -= other; }
inline Ledger operator*(double factor, Ledger books) { return books *= factor; }

}  // namespace shaken::continuum
