// SPDX-License-Identifier: MIT
#include "continuum/parameters_of_tubes.hpp"

#include "continuum/boundary/named.hpp"

namespace shaken::continuum {

namespace {

using scene::GasState;
using scene::Kind;
using scene::ParameterVisitor;
using scene::Scene;

void describe_ends(scene::Tube& t, ParameterVisitor& v) {
    v.choice({"lower", "", "the lower end"}, t.lower, ends_below_tube());
    v.choice({"upper", "", "the upper end"}, t.upper, ends_above_tube());
    v.optional_number({"lower_temperature", "g sigma", "of a heated lower end"}, t.lower_temperature, scene::positive);
    v.optional_number({"upper_temperature", "g sigma", "of a heated upper end"}, t.upper_temperature, scene::positive);
}

void describe_gas(GasState& gas, ParameterVisitor& v) {
    v.number({"volume_fraction", "", "of the gas"}, gas.volume_fraction, {0.0, 0.649, true});
    v.number({"velocity", "sqrt(g sigma)", "of the gas, upwards"}, gas.velocity, scene::any_number);
    v.number({"temperature", "g sigma", "granular temperature"}, gas.temperature, scene::positive);
}

}  // namespace

void describe_tube(Scene& s, ParameterVisitor& v) {
    v.section("tube", "a column of gas whose exact solution is known");
    v.number({"length", "sigma", "of the tube"}, s.tube.length, scene::positive);
    v.number({"time", "sqrt(sigma/g)", "how long it is followed"}, s.tube.time, scene::positive);
    v.number({"restitution", "", "constant e"}, s.tube.restitution, scene::fractions);
    switch (s.kind) {
        case Kind::riemann:
            describe_ends(s.tube, v);
            v.number({"speed", "sqrt(g sigma)", "of a piston as the lower end, with which the frame moves"},
                     s.tube.speed, scene::positive);
            v.section("initial.left", "the gas below the middle");
            describe_gas(s.tube.left, v);
            v.section("initial.right", "the gas above the middle");
            describe_gas(s.tube.right, v);
            break;
        case Kind::piston:
            v.number({"speed", "sqrt(g sigma)", "of the piston, the lower end, into gas at rest"}, s.tube.speed,
                     scene::positive);
            v.section("initial", "the gas at rest before the piston");
            v.number({"volume_fraction", "", "of the gas"}, s.tube.gas.volume_fraction, {0.0, 0.649, true});
            v.number({"temperature", "g sigma", "granular temperature"}, s.tube.gas.temperature, scene::positive);
            break;
        case Kind::column:
            v.optional_number({"wall_temperature", "g sigma", "of a heated bottom; without: none, and e must be 1"},
                              s.tube.wall_temperature, scene::positive);
            v.section("initial", "gas at rest under gravity");
            v.number({"volume_fraction", "", "at the bottom (without a heated bottom)"}, s.tube.gas.volume_fraction,
                     {0.0, 0.649, true});
            v.number({"temperature", "g sigma", "granular temperature"}, s.tube.gas.temperature, scene::positive);
            v.number({"number_per_area", "1/sigma^2", "particles on a heated bottom"}, s.tube.number_per_area,
                     scene::positive);
            break;
        case Kind::wave:
            v.section("initial", "gas with a wave of sound of one wavelength");
            v.number({"volume_fraction", "", "of the gas"}, s.tube.gas.volume_fraction, {0.0, 0.649, true});
            v.number({"temperature", "g sigma", "granular temperature"}, s.tube.gas.temperature, scene::positive);
            v.number({"amplitude", "", "of the density, relative"}, s.tube.amplitude, {0.0, 0.1, true});
            break;
        case Kind::cooling_flow:
            // Dilute by default: what the other kinds start from is out of its range.
            if (s.tube.gas.volume_fraction == GasState{}.volume_fraction) s.tube.gas.volume_fraction = 0.01;
            v.section("initial", "dilute gas of one density on a wall, warmest there, with a free surface at T = 0");
            v.number({"volume_fraction", "", "of the gas"}, s.tube.gas.volume_fraction, {0.0, 0.1, true});
            v.number({"temperature", "g sigma", "granular temperature at the wall"}, s.tube.gas.temperature,
                     scene::positive);
            break;
        case Kind::layer:
        case Kind::uniform:
            break;
    }
}

}  // namespace shaken::continuum
