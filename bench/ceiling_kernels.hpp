// Loops that reach a limit of the machine; one table per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

namespace parapet::bench {

struct CeilingKernels {
  const char* name;
  // `rounds` rounds of independent x = x a + b; returns the floating-point operations done.
  // multiply_add: two instructions, as in the solver; fused: nullptr where there is none.
  double (*multiply_add)(std::size_t rounds, double* sink);
  double (*fused_multiply_add)(std::size_t rounds, double* sink);
  // Return the number of roots and quotients.
  double (*roots)(std::size_t rounds, double* sink);
  double (*quotients)(std::size_t rounds, double* sink);
  // Sum of n values, `rounds` times: bandwidth of loads. n is a multiple of 64.
  double (*sum)(const double* values, std::size_t n, std::size_t rounds);
  // Sum of n values by index, a register at a time, as the passes gather. n is a multiple of 16.
  double (*gather_sum)(const double* values, const std::int32_t* index, std::size_t n);
};

}  // namespace parapet::bench
