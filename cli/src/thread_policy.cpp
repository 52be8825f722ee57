#include "thread_policy.hpp"

#include <unistd.h>

#include <cstdlib>

namespace parapet::cli {

void let_waiting_threads_sleep(char** argv) {
  // One thread runs yet, so the environment may be read and changed.
  // NOLINTBEGIN(concurrency-mt-unsafe)
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  if (::setenv("OMP_WAIT_POLICY", "passive", 0) != 0) return;
  // NOLINTEND(concurrency-mt-unsafe)
  ::execv("/proc/self/exe", argv);
  // Only reached when that was not possible: the program then runs with the default.
}

}  // namespace parapet::cli
