// Wall time and CPU time of a piece of work. CPU time is what a busy machine disturbs least.
#pragma once

#include <utility>

namespace parapet::bench {

struct Times {
  double wall = 0.0, cpu = 0.0;  // [s]; cpu of the whole process
};

Times now();

template <class Work>
Times measure(Work&& work) {
  const Times start = now();
  std::forward<Work>(work)();
  const Times end = now();
  return {end.wall - start.wall, end.cpu - start.cpu};
}

// Memory of this process [bytes]: now, and the largest since the last reset.
double resident_bytes();
double peak_resident_bytes();
void reset_peak_resident();

}  // namespace parapet::bench
