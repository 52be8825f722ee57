/// Sobol' points: a low-discrepancy sequence in the unit cube.
#pragma once

#include <cstdint>
#include <vector>

namespace parapet::optimizer {

/// Unscrambled Sobol' sequence with the direction numbers of Joe and Kuo
/// (SIAM J. Sci. Comput. 30 (2008) 2635-2654, file new-joe-kuo-6.21201).
/// The all-zero point 0, a corner of the cube, is left out: the first point is the centre.
/// Point k has the Gray-code order of Antonov and Saleev; the first 2^m - 1 points and the corner
/// together have exactly one point in every interval [i, i + 1) / 2^m of every coordinate.
class SobolSequence {
 public:
  static constexpr int max_dimension = 21;

  /// @param dimension 1..max_dimension.
  /// @throws std::invalid_argument for any other dimension.
  explicit SobolSequence(int dimension);

  /// The next point [dimension], coordinates in (0, 1).
  std::vector<double> next();

 private:
  static constexpr int n_bits = 32;
  std::vector<std::uint32_t> direction_;  // [dimension * n_bits]
  std::vector<std::uint32_t> state_;      // [dimension]
  std::uint32_t index_ = 0;
};

}  // namespace parapet::optimizer
