// SPDX-License-Identifier: MIT
#include "app/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "app/signals.hpp"
#include "files/errors.hpp"

namespace shaken::app {

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments, Kind kind) {
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t parent = ::getpid();
    const SignalsHeld held;
    pid_ = ::fork();
    if (pid_ < 0) throw std::runtime_error(fmt::format("{} cannot be started: {}", program, std::strerror(errno)));
    if (pid_ == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // a child does not outlive its parent: it stops with a checkpoint
        if (::getppid() != parent) ::raise(SIGTERM);
        if (kind == Kind::plain) held.let_in_to_end_it();
        if (kind == Kind::silent) {
            const int nowhere = ::open("/dev/null", O_WRONLY);
            ::dup2(nowhere, STDOUT_FILENO);
            ::dup2(nowhere, STDERR_FILENO);
        }
        ::execvp(program.c_str(), argv.data());
        ::_exit(127);
    }
}

int ChildProcess::code_of(int wait_status) {
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

std::optional<int> ChildProcess::poll() {
    int status = 0;
    if (!code_ && ::waitpid(pid_, &status, WNOHANG) == pid_) code_ = code_of(status);
    return code_;
}

int ChildProcess::wait() {
    int status = 0;
    while (!code_) {
        if (::waitpid(pid_, &status, 0) == pid_)
            code_ = code_of(status);
        else if (errno != EINTR)
            throw std::runtime_error(fmt::format("lost a child process: {}", std::strerror(errno)));
    }
    return *code_;
}

int ChildProcess::wait_or_stop() {
    while (!poll()) {
        if (stop_requested()) {
            signal(SIGTERM);
            return wait();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return *code_;
}

void ChildProcess::signal(int number) const {
    if (!code_) ::kill(pid_, number);
}

std::filesystem::path own_path() { return std::filesystem::read_symlink("/proc/self/exe"); }

std::filesystem::path share_folder() {
    const std::filesystem::path installed = own_path().parent_path().parent_path() / "share" / "shaken";
    return std::filesystem::exists(installed) ? installed : std::filesystem::path(SHAKEN_SOURCE_DIR);
}

std::string drawing_python() {
    std::vector<std::string> candidates{"python3", "/usr/bin/python3"};
    if (const char* chosen = std::getenv("SHAKEN_PYTHON")) candidates.insert(candidates.begin(), chosen);
    for (const std::string& python : candidates) {
        if (ChildProcess(python, {"-c", "import matplotlib, h5py, numpy, tomllib"}, ChildProcess::Kind::silent)
                .wait() == 0)
            return python;
    }
    throw files::NoInput(
        "no python3 with matplotlib, h5py and numpy is here; Debian's packages are python3-matplotlib, python3-h5py, "
        "python3-numpy");
}

}  // namespace shaken::app
