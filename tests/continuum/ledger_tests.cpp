// SPDX-License-Identifier: MIT
// Books add up entry by entry, and the fields of a flow have the names that checkpoints give them.
#include "continuum/step/ledger.hpp"

#include "continuum/flow.hpp"
#include "tests/support/catch.hpp"

using namespace shaken;

using namespace continuum;

namespace {

/// Entry k is first + k, so that none can stand for another.
Ledger counted(double first) {
    Ledger books;
    for (const auto entry : entries_of_ledger) books.*entry = first++;
    return books;
}

}  // namespace

TEST_CASE("books add up, entry by entry") {
    Ledger sum = counted(1.0);
    sum += counted(100.0);
    const Ledger less = counted(100.0) - counted(1.0), half = 0.5 * counted(2.0);
    CHECK(sum.energy == 101.0);
    CHECK(sum.initial_energy == 103.0);
    CHECK(sum.lid_impulse == 121.0);
    double k = 0.0;
    for (const auto entry : entries_of_ledger) {
        CHECK(sum.*entry == 101.0 + 2.0 * k);
        CHECK(less.*entry == 99.0);
        CHECK(half.*entry == 1.0 + 0.5 * k);
        CHECK((counted(0.0) + counted(0.0)).*entry == 2.0 * k);
        ++k;
    }
    CHECK(k == 11.0);
}

TEST_CASE("the fields of a flow stand in the order of their names") {
    Grid grid;
    grid.nz = 4;
    Flow flow(grid);
    for (std::size_t k = 0; k < flow.fields().size(); ++k) flow.fields()[k]->front() = 10.0 + static_cast<double>(k);
    const double of_names[] = {flow.density.front(), flow.velocity_x.front(), flow.velocity_y.front(),
                               flow.velocity_z.front(), flow.temperature.front()};
    for (std::size_t k = 0; k < 5; ++k) CHECK(of_names[k] == 10.0 + static_cast<double>(k));
    CHECK(Flow::names ==
          std::array<std::string_view, 5>{"density", "velocity_x", "velocity_y", "velocity_z", "temperature"});
    const Flow& same = flow;
    for (std::size_t k = 0; k < 5; ++k) CHECK(same.fields()[k] == flow.fields()[k]);
}
