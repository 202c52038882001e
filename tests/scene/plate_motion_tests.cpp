// SPDX-License-Identifier: MIT
#include "scene/plate_motion.hpp"

#include "tests/support/catch.hpp"

using namespace shaken;

using scene::PlateMotion;

TEST_CASE("the plate is lowest at ft = 0, highest at 0.5 and rises through A at 0.25") {
    const PlateMotion plate = PlateMotion::from_acceleration(3.0, 0.095);
    const double period = plate.period(), tolerance = 1e-14;  // round-off of one cosine
    CHECK(plate.position(0.0) == 0.0);
    CHECK(plate.position(0.5 * period) == Approx(2.0 * plate.amplitude).epsilon(tolerance));
    CHECK(plate.position(0.25 * period) == Approx(plate.amplitude).epsilon(tolerance));
    CHECK(plate.velocity(0.25 * period) > 0.0);
}

TEST_CASE("the peak acceleration is Gamma and is met at the lowest point") {
    const PlateMotion plate = PlateMotion::from_acceleration(2.2, 0.18);
    CHECK(plate.acceleration(0.0) == Approx(2.2).epsilon(1e-15));
    CHECK(plate.peak_acceleration() == Approx(2.2).epsilon(1e-15));
}

TEST_CASE("velocity and acceleration are the derivatives of position") {
    const PlateMotion plate = PlateMotion::from_acceleration(3.0, 0.095);
    const double h = 1e-4;  // truncation of the central difference is h^2/6 times the third derivative, below 1e-8 here
    for (double t = 0.1; t < plate.period(); t += 0.37) {
        CHECK((plate.position(t + h) - plate.position(t - h)) / (2 * h) == Approx(plate.velocity(t)).margin(1e-8));
        CHECK((plate.velocity(t + h) - plate.velocity(t - h)) / (2 * h) == Approx(plate.acceleration(t)).margin(1e-8));
    }
}
