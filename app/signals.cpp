// SPDX-License-Identifier: MIT
#include "app/signals.hpp"

namespace shaken::app {

namespace {

volatile std::sig_atomic_t stop_flag = 0;
volatile std::sig_atomic_t checkpoint_flag = 0;

extern "C" void on_stop(int) { stop_flag = 1; }
extern "C" void on_checkpoint(int) { checkpoint_flag = 1; }

constexpr int stop_signals[] = {SIGTERM, SIGINT, SIGHUP};
constexpr int checkpoint_signal = SIGUSR1;

sigset_t all_of_them() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : stop_signals) sigaddset(&signals, number);
    sigaddset(&signals, checkpoint_signal);
    return signals;
}

void handle(int number, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    ::sigaction(number, &action, nullptr);
}

}  // namespace

void catch_signals() {
    for (const int number : stop_signals) handle(number, on_stop);
    handle(checkpoint_signal, on_checkpoint);
    const sigset_t signals = all_of_them();
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

bool stop_requested() { return stop_flag != 0; }

bool take_checkpoint_request() {
    const bool asked = checkpoint_flag != 0;
    checkpoint_flag = 0;
    return asked;
}

SignalsHeld::SignalsHeld() {
    const sigset_t signals = all_of_them();
    ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

SignalsHeld::~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

void SignalsHeld::let_in_to_end_it() const {
    for (const int number : stop_signals) handle(number, SIG_DFL);
    handle(checkpoint_signal, SIG_DFL);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace shaken::app
