// Loops over particles in fixed blocks. A block writes only its own particles and sums are added in
// block order, so the number of threads cannot change a bit.
#pragma once

#include <algorithm>

#include "parapet/flow/kernel.hpp"

namespace parapet::solver {

constexpr int block_size = 128;  // whole groups
static_assert(block_size % lanes == 0);

// Fewer particles than this for each thread cost more to share out than to compute.
constexpr int least_per_thread = 512;

// Calls body(begin, end) for every block of [0, n).
template <class Body>
void for_blocks(int n, int threads, const Body& body) {
  const int blocks = (n + block_size - 1) / block_size;
  const int useful = std::clamp(n / least_per_thread, 1, threads);
  const auto block = [&](int b) { body(b * block_size, std::min(n, (b + 1) * block_size)); };
  if (useful == 1) {  // a team of one still costs a call
    for (int b = 0; b < blocks; ++b) block(b);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(useful)
  for (int b = 0; b < blocks; ++b) block(b);
}

}  // namespace parapet::solver
