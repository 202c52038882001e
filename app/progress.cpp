// SPDX-License-Identifier: MIT
#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace shaken::app {

namespace {

constexpr std::chrono::milliseconds terminal_interval(100);
constexpr std::chrono::seconds plain_interval(30);

}  // namespace

ProgressDisplay::ProgressDisplay(bool quiet)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1), last_(Clock::now()) {}

bool ProgressDisplay::is_due() const {
    if (quiet_) return false;
    const auto waited = Clock::now() - last_;
    return terminal_ ? waited >= terminal_interval : waited >= plain_interval;
}

void ProgressDisplay::rewrite(const std::vector<run::Status>& engines) {
    std::string text;
    if (terminal_ && drawn_lines_ > 0) text += fmt::format("\033[{}A", drawn_lines_);
    for (const run::Status& engine : engines) text += fmt::format("{}{}\n", terminal_ ? "\r\033[K" : "", engine.line());
    drawn_lines_ = engines.size();
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
    last_ = Clock::now();
}

void ProgressDisplay::draw(const std::vector<run::Status>& engines) {
    if (is_due()) rewrite(engines);
}

void ProgressDisplay::finish(const std::vector<run::Status>& engines) {
    if (!quiet_) rewrite(engines);
    drawn_lines_ = 0;
}

}  // namespace shaken::app
