#include "interrupt.hpp"

#include <atomic>
#include <csignal>

namespace parapet::cli {
namespace {

// The one global of the program: a signal handler can reach nothing else.
std::atomic<bool> interrupt_flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "only lock-free atomics work in a handler");

extern "C" void on_interrupt(int) {
  interrupt_flag = true;
}

}  // namespace

void install_interrupt_handler() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  // SA_RESETHAND: the second signal finds the default action, which ends the program.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return interrupt_flag;
}

}  // namespace parapet::cli
