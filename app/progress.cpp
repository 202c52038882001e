// SPDX-License-Identifier: MIT
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

namespace shaken::app {

namespace {

constexpr std::chrono::milliseconds terminal_interval(100);
constexpr std::chrono::seconds plain_interval(30);

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

ProgressDisplay::ProgressDisplay(bool quiet)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1), last_(Clock::now()) {}

bool ProgressDisplay::is_due() const {
    if (quiet_) return false;
    const auto waited = Clock::now() - last_;
    return terminal_ ? waited >= terminal_interval : waited >= plain_interval;
}

void ProgressDisplay::rewrite(const std::vector<Status>& engines) {
    std::string text;
    if (terminal_ && drawn_lines_ > 0) text += fmt::format("\033[{}A", drawn_lines_);
    for (const Status& engine : engines) text += fmt::format("{}{}\n", terminal_ ? "\r\033[K" : "", engine.line());
    drawn_lines_ = engines.size();
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
    last_ = Clock::now();
}

void ProgressDisplay::draw(const std::vector<Status>& engines) {
    if (is_due()) rewrite(engines);
}

void ProgressDisplay::finish(const std::vector<Status>& engines) {
    if (!quiet_) rewrite(engines);
    drawn_lines_ = 0;
}

}  // namespace shaken::app
