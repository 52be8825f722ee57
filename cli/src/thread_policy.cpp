#include "thread_policy.hpp"

#include <unistd.h>

#include <cstdlib>

namespace parapet::cli {

void let_waiting_threads_sleep(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  if (::setenv("OMP_WAIT_POLICY", "passive", 0) != 0) return;
  ::execv("/proc/self/exe", argv);
  // Only reached when that was not possible: the program then runs with the default.
}

}  // namespace parapet::cli
