// SPDX-License-Identifier: MIT
#include "app/progress.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace shaken;

using run::Status;

TEST_CASE("a status goes through its file unchanged") {
    const Status status{"md", "running", 12.5, 75.0, 3.1e5, "collisions/s", 10.0, 50.0};
    const Status again = Status::from_json(status.json());
    CHECK(again.line() == status.line());
    CHECK(again.elapsed == 10.0);
    Status unknown = status;
    unknown.remaining = HUGE_VAL;
    CHECK(std::isinf(Status::from_json(unknown.json()).remaining));
    CHECK_THROWS(Status::from_json(status.json().substr(0, 40)));
}

TEST_CASE("a line says who, how far, how fast and how long") {
    Status status{"md", "running", 12.5, 75.0, 3.1e5, "collisions/s", 10.0, 3725.0};
    CHECK_THAT(status.line(), Contains("md") && Contains("12.50 of 75") && Contains("310.0 k collisions/s") &&
                                  Contains("ETA 1:02:05"));
    status.state = "finished";
    CHECK_THAT(status.line(), Contains("finished after 0:10"));
}
