#include "index/cli/interrupt.h"

#include <pthread.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

namespace ossuary::cli {
namespace {

// Wakes the waiter when the guard goes; a real-time signal, so that nobody else means it.
int wake_signal() { return SIGRTMIN; }

sigset_t waited_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, wake_signal());
    return set;
}

}  // namespace

// The signals are blocked in all threads (they inherit the mask) and taken by one that waits for
// them: no code runs in a signal handler.
InterruptGuard::InterruptGuard() {
    const sigset_t set = waited_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::thread([this, set] {
        bool asked = false;
        for (;;) {
            int signal = 0;
            if (sigwait(&set, &signal) != 0 || signal == wake_signal()) return;
            if (asked) std::_Exit(128 + signal);
            asked = true;
            std::cerr << "\nossuary: stopping after the models in work (again to stop at once)\n";
            source_.request_stop();
        }
    });
}

InterruptGuard::~InterruptGuard() {
    pthread_kill(waiter_.native_handle(), wake_signal());
    waiter_.join();
}

}  // namespace ossuary::cli
