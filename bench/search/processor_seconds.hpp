#pragma once

#include <ctime>

namespace parapet::bench::search {

// Processor time of this process, all threads: unlike a wall clock's it holds on a busy machine.
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace parapet::bench::search
