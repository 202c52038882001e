// SPDX-License-Identifier: MIT
// Runs the built command as a user would, and catches what it says.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>

namespace support {

struct Result {
    int code = -1;
    std::string text;  // stdout and stderr together
};

/// A line of shell; its exit code is 128 + signal where one killed it.
inline Result shell(const std::string& line) {
    Result result;
    FILE* pipe = ::popen(("{ " + line + "; } 2>&1").c_str(), "r");
    std::array<char, 4096> buffer;
    while (std::fgets(buffer.data(), buffer.size(), pipe)) result.text += buffer.data();
    const int status = ::pclose(pipe);
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

inline Result shaken(const std::string& arguments) { return shell(std::string(SHAKEN_COMMAND) + " " + arguments); }

inline std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A shaken layer that both engines finish in about a second.
inline constexpr const char* small_scene = SHAKEN_SOURCE_DIR "/tests/support/small_layer.toml";

}  // namespace support
