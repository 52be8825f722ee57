/// Random numbers that are the same on every platform.
#pragma once

#include <cstdint>
#include <random>

namespace parapet::bayesian {

/// Uniform numbers from a Mersenne twister; the standard's distributions differ between libraries.
class Random {
 public:
  /// Different streams of one seed are independent of each other.
  Random(std::uint64_t seed, std::uint64_t stream) {
    std::seed_seq sequence{seed & 0xffffffffU, seed >> 32U, stream & 0xffffffffU, stream >> 32U};
    generator_.seed(sequence);
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>(generator_() >> 11U) * 0x1p-53; }

  /// 0 .. n - 1.
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(n));
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace parapet::bayesian
