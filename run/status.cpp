// SPDX-License-Identifier: MIT
#include "run/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace shaken::run {

namespace {

std::string clock_text(double seconds) {
    if (!std::isfinite(seconds)) return "-:--";
    const long whole = std::lround(std::max(0.0, seconds));
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string rate_text(double rate) {
    if (rate >= 1e6) return fmt::format("{:.2f} M", rate / 1e6);
    if (rate >= 1e3) return fmt::format("{:.1f} k", rate / 1e3);
    return fmt::format("{:.1f} ", rate);
}

}  // namespace

std::string Status::line() const {
    if (cycles == 0.0) return fmt::format("{:<9}  {}", engine, state == "running" ? "starting" : state);
    const std::string done = fmt::format("{:<9}  cycle {:7.2f} of {:.0f}", engine, cycle, cycles);
    const std::string speed = fmt::format("{:>8} {}", rate_text(rate), rate_unit);
    if (state == "running") return fmt::format("{}  {}  ETA {}", done, speed, clock_text(remaining));
    return fmt::format("{}  {}  {} after {}", done, speed, state, clock_text(elapsed));
}

std::string Status::json() const {
    const nlohmann::ordered_json value{
        {"engine", engine},
        {"state", state},
        {"cycle", cycle},
        {"cycles", cycles},
        {"rate", rate},
        {"rate_unit", rate_unit},
        {"elapsed_seconds", elapsed},
        {"remaining_seconds", std::isfinite(remaining) ? nlohmann::ordered_json(remaining) : nullptr}};
    return value.dump(2) + "\n";
}

Status Status::from_json(const std::string& text) {
    const auto value = nlohmann::json::parse(text);
    Status s;
    s.engine = value.at("engine");
    s.state = value.at("state");
    s.cycle = value.at("cycle");
    s.cycles = value.at("cycles");
    s.rate = value.at("rate");
    s.rate_unit = value.at("rate_unit");
    s.elapsed = value.at("elapsed_seconds");
    s.remaining = value.at("remaining_seconds").is_null() ? HUGE_VAL : value.at("remaining_seconds").get<double>();
    return s;
}

void write_status(const std::filesystem::path& path, const Status& status) {
    const std::filesystem::path temporary = path.string() + ".tmp";
    std::ofstream(temporary) << status.json();
    std::error_code ignored;
    std::filesystem::rename(temporary, path, ignored);
}

}  // namespace shaken::run
