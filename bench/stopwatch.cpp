#include "stopwatch.hpp"

#include <malloc.h>
#include <time.h>

#include <chrono>
#include <fstream>
#include <string>

namespace parapet::bench {
namespace {

double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0.0;
    if (word == key && status >> kilobytes) return 1024.0 * kilobytes;
  }
  return 0.0;
}

}  // namespace

Times now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(wall).count(),
          static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec)};
}

double resident_bytes() {
  malloc_trim(0);
  return status_bytes("VmRSS:");
}

double peak_resident_bytes() {
  return status_bytes("VmHWM:");
}

void reset_peak_resident() {
  std::ofstream("/proc/self/clear_refs") << "5";  // see proc(5)
}

}  // namespace parapet::bench
