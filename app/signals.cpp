// SPDX-License-Identifier: MIT
#include "app/signals.hpp"

#include <csignal>

namespace shaken::app {

namespace {

volatile std::sig_atomic_t stop_flag = 0;
volatile std::sig_atomic_t checkpoint_flag = 0;

extern "C" void on_stop(int) { stop_flag = 1; }
extern "C" void on_checkpoint(int) { checkpoint_flag = 1; }

void handle(int number, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    ::sigaction(number, &action, nullptr);
}

}  // namespace

void catch_signals() {
    handle(SIGTERM, on_stop);
    handle(SIGINT, on_stop);
    handle(SIGHUP, on_stop);
    handle(SIGUSR1, on_checkpoint);
}

bool stop_requested() { return stop_flag != 0; }

bool take_checkpoint_request() {
    const bool asked = checkpoint_flag != 0;
    checkpoint_flag = 0;
    return asked;
}

}  // namespace shaken::app
