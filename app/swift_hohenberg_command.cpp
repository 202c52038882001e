// SPDX-License-Identifier: MIT
#include "app/swift_hohenberg_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/exit_codes.hpp"
#include "app/options.hpp"
#include "compare/jackknife.hpp"
#include "compare/patterns/power_spectrum.hpp"
#include "swift_hohenberg/linear_theory.hpp"
#include "swift_hohenberg/simulation.hpp"

namespace shaken::app {

namespace {

constexpr std::size_t blocks = 10;

/// The mean spectrum of the averaging time, and those without each of ten equal parts of it.
class Blocks {
  public:
    explicit Blocks(const fields::HorizontalGrid& grid)
        : transform_(grid), all_(transform_), without_(blocks, compare::PowerSpectrum(transform_)) {}

    void add(std::size_t block, const std::vector<double>& field) {
        const auto amplitudes = transform_.amplitudes(field);
        all_.add(amplitudes);
        for (std::size_t b = 0; b < blocks; ++b)
            if (b != block) without_[b].add(amplitudes);
    }

    template <class Quantity>
    std::pair<double, double> measure(Quantity quantity) const {
        std::vector<double> estimates;
        for (const auto& spectrum : without_) estimates.push_back(quantity(spectrum));
        return {quantity(all_), compare::jackknife_error(estimates)};
    }

  private:
    compare::MapTransform transform_;
    compare::PowerSpectrum all_;
    std::vector<compare::PowerSpectrum> without_;  // all but one block each
};

nlohmann::ordered_json steady_state(const swift_hohenberg::Parameters& p, const SwiftHohenbergOptions& options) {
    swift_hohenberg::Simulation simulation(p);
    simulation.advance(options.settle);
    Blocks spectra({p.points, p.points, p.side, p.side});
    for (std::int64_t i = 0; i < options.average; ++i) {
        simulation.step();
        spectra.add(static_cast<std::size_t>(i) * blocks / static_cast<std::size_t>(options.average),
                    simulation.field());
    }
    const auto square = spectra.measure([](const compare::PowerSpectrum& s) { return s.mean_square(); });
    const auto order = spectra.measure([](const compare::PowerSpectrum& s) { return s.order(); });
    nlohmann::ordered_json line{{"control", p.control},
                                {"noise", p.noise},
                                {"seed", p.seed},
                                {"mean_square", square.first},
                                {"mean_square_error", square.second},
                                {"order", order.first},
                                {"order_error", order.second}};
    if (p.control < 0.0) line["linear_mean_square"] = swift_hohenberg::mean_square(p);
    return line;
}

}  // namespace

int run_swift_hohenberg(const SwiftHohenbergOptions& options) {
    if (options.average < static_cast<std::int64_t>(blocks))
        throw UsageError(fmt::format("--average {}: at least {} steps are needed", options.average, blocks));
    for (const double control : options.controls) {
        swift_hohenberg::Parameters p = options.parameters;
        p.control = control;
        try {
            fmt::print("{}\n", steady_state(p, options).dump());
        } catch (const std::invalid_argument& error) {
            throw UsageError(fmt::format("swift-hohenberg: {}", error.what()));
        }
        std::fflush(stdout);
    }
    return exit_code::done;
}

}  // namespace shaken::app
