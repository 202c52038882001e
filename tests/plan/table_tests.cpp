// SPDX-License-Identifier: MIT
#include "plan/table.hpp"

#include <fmt/format.h>
#include <cmath>

#include "tests/support/catch.hpp"

using namespace shaken::plan;

namespace {

constexpr const char* header =
    "study,engine,scheme,knob,value,quantity,error_percent,error_of_error,cpu_seconds,cpu_low,cpu_high,work,steps,"
    "default,end,command\n";

std::string rows_of(const char* scheme, double factor, double order, double seconds) {
    std::string rows;
    for (const double dz : {0.8, 0.4, 0.2})
        rows += fmt::format("ch4_shock,continuum,{},dz,{},z_cm,{},0,{},,,,,0,completed,\"shaken, quoted\"\n", scheme,
                            dz, factor * std::pow(dz, order), seconds / (dz * dz));
    return rows;
}

}  // namespace

TEST_CASE("power laws come back from a table made of them") {
    const Table table(parse_table(header + rows_of("a", 0.5, 2.0, 0.01)));
    const Scheme& a = table.cheapest(0.01);
    // Six digits were written.
    CHECK(a.error.order == Approx(2.0).epsilon(1e-5));
    CHECK(a.error.factor == Approx(0.005).epsilon(1e-5));
    CHECK(a.error.residual < 1e-5);
    // Seconds go as 1/spacing^2, the error as its square: half the error, twice the time.
    CHECK(*a.seconds_for(0.001) / *a.seconds_for(0.002) == Approx(2.0).epsilon(1e-5));
    CHECK_FALSE(a.seconds_for(1e-6));
    CHECK(table.floor() == Approx(0.005 * 0.04));
}

TEST_CASE("the scheme is the cheapest for the error, the most exact where none reaches it") {
    const Table table(parse_table(header + rows_of("quick", 0.5, 1.0, 0.01) + rows_of("exact", 0.5, 4.0, 0.04)));
    CHECK(table.cheapest(0.004).name == "quick");
    CHECK(table.cheapest(0.0005).name == "exact");
    CHECK(table.cheapest(1e-9).name == "exact");
}

TEST_CASE("a table without its columns is refused") {
    CHECK_THROWS_WITH(parse_table("study,engine\nch4_shock,md\n"), Contains("no column"));
}

TEST_CASE("the table built in knows a scheme that converges and a floor below a per mille") {
    CHECK(measured_table().floor() < 1e-3);
    CHECK(measured_table().cheapest(0.01).error.order > 0.5);
}
