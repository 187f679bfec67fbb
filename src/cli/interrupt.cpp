#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace vernier {
namespace {

// A signal handler has nothing but what is global; lock-free, so it may be set there.
std::atomic<bool> g_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

/// The next one, whichever, has its usual effect.
void remember_interrupt(int) {
  g_interrupted.store(true);
  for (const int signal : kSignals) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler == remember_interrupt) std::signal(signal, SIG_DFL);
  }
}

}  // namespace

void catch_interrupt() {
  struct sigaction action {};
  action.sa_handler = remember_interrupt;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : kSignals) {
    struct sigaction before {};
    sigaction(signal, &action, &before);
    if (signal == SIGHUP && before.sa_handler == SIG_IGN) sigaction(signal, &before, nullptr);
  }
}

bool interrupted() {
  return g_interrupted.load();
}

}  // namespace vernier
