// SPDX-License-Identifier: MIT
#include "compare/halves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "compare/jackknife.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/normal.hpp"

using namespace shaken;

namespace {

double mean_of(const std::vector<double>& x, const std::vector<bool>& kept) {
    double sum = 0.0, count = 0.0;
    for (std::size_t b = 0; b < x.size(); ++b)
        if (kept[b]) {
            sum += x[b];
            count += 1.0;
        }
    return sum / count;
}

/// Rms over many runs of ten blocks of the two errors of a function of the mean, and its scatter over the runs. The
/// mean of a run scatters by 1.
template <class Function>
std::array<double, 3> errors_of(Function number) {
    constexpr std::size_t blocks = 10;
    constexpr std::uint64_t runs = 2000;
    const auto halves = compare::halves_of_blocks(blocks);
    double by_halves = 0.0, by_jackknife = 0.0, sum = 0.0, squares = 0.0;
    for (std::uint64_t run = 1; run <= runs; ++run) {
        support::Normal normal(run);
        std::vector<double> x(blocks), of_halves, without;
        for (double& value : x) value = std::sqrt(10.0) * normal();
        for (const auto& half : halves) of_halves.push_back(number(mean_of(x, half)));
        for (std::size_t b = 0; b < blocks; ++b) {
            std::vector<bool> others(blocks, true);
            others[b] = false;
            without.push_back(number(mean_of(x, others)));
        }
        const double value = number(mean_of(x, std::vector<bool>(blocks, true)));
        sum += value / runs;
        squares += value * value / runs;
        by_halves += std::pow(compare::error_from_halves(of_halves, halves), 2) / runs;
        by_jackknife += std::pow(compare::jackknife_error(without), 2) / runs;
    }
    return {std::sqrt(by_halves), std::sqrt(by_jackknife), std::sqrt(squares - sum * sum)};
}

}  // namespace

TEST_CASE("each block is in half of the halves, and no split is drawn twice") {
    for (const std::size_t blocks : {2, 3, 5, 10, 60}) {
        const auto halves = compare::halves_of_blocks(blocks);
        CAPTURE(blocks);
        CHECK(halves.size() <= 40);
        for (std::size_t b = 0; b < blocks; ++b)
            CHECK(2 * std::count_if(halves.begin(), halves.end(), [b](const auto& half) { return half[b]; }) ==
                  static_cast<std::ptrdiff_t>(halves.size()));
        CHECK(std::set<std::vector<bool>>(halves.begin(), halves.end()).size() >= halves.size() / 2);
        CHECK(halves == compare::halves_of_blocks(blocks));
    }
    CHECK(compare::halves_of_blocks(2).size() >= 2);
    CHECK(compare::halves_of_blocks(1).empty());
    CHECK(std::isnan(compare::error_from_halves({}, {})));
}

TEST_CASE("halves give a mean its error, of few blocks exactly") {
    const std::vector<double> x{1.0, 4.0};
    const auto halves = compare::halves_of_blocks(2);
    std::vector<double> means;
    for (const auto& half : halves) means.push_back(mean_of(x, half));
    CHECK(compare::error_from_halves(means, halves) == Approx(1.5).epsilon(1e-12));  // |x - y|/2; round-off

    // Statistics: 2000 runs whose errors scatter by 30 %, 1 %.
    const auto [by_halves, by_jackknife, scatter] = errors_of([](double mean) { return mean; });
    CHECK(by_halves == Approx(1.0).margin(0.04));
    CHECK(by_jackknife == Approx(1.0).margin(0.04));
    CHECK(scatter == Approx(1.0).margin(0.05));
}

TEST_CASE("halves give a number that moves in steps its scatter, leaving one block out does not") {
    // Of one step somewhere in the reach of the mean: a half holds it as often as another run.
    const auto [by_halves, by_jackknife, scatter] = errors_of([](double mean) { return mean > 0.3 ? 1.0 : 0.0; });
    CHECK(by_halves / scatter == Approx(0.8).margin(0.15));  // a half is drawn around its run, not around the truth
    CHECK(by_jackknife / scatter > 1.3);
}

TEST_CASE("what one block alone has seen has no error, what two have has one") {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto halves = compare::halves_of_blocks(10);
    std::vector<double> of_one, of_two;
    for (const auto& half : halves) {
        of_one.push_back(half[3] ? 2.0 : unknown);
        of_two.push_back(half[3] ? 2.0 : half[7] ? 1.0 : unknown);
    }
    CHECK(std::isnan(compare::error_from_halves(of_one, halves)));
    CHECK(compare::error_from_halves(of_two, halves) > 0.1);
}
