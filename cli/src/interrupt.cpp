#include "interrupt.hpp"

#include <atomic>
#include <csignal>
#include <ctime>

namespace parapet::cli {
namespace {

// The globals of the program: a signal handler can reach nothing else.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<bool> interrupt_flag = false;
std::atomic<long long> interrupted_at_ms = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long long>::is_always_lock_free,
              "only lock-free atomics work in a handler");

// The first signal asks for an orderly end; another one ends the program at once, unless it follows
// within a second: tools such as timeout send theirs twice.
extern "C" void on_interrupt(int number) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const long long ms = 1000LL * now.tv_sec + now.tv_nsec / 1000000;
  if (!interrupt_flag.exchange(true)) {
    interrupted_at_ms = ms;
  } else if (ms - interrupted_at_ms > 1000) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

}  // namespace

void install_interrupt_handler() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // The terminal has gone. Under nohup the signal is ignored, and stays so.
  struct sigaction before {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) {
    sigaction(SIGHUP, &action, nullptr);
  }
}

bool interrupted() {
  return interrupt_flag;
}

}  // namespace parapet::cli
