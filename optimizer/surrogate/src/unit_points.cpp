#include "unit_points.hpp"

#include <algorithm>
#include <vector>

#include "parapet/optimizer/sobol.hpp"

namespace parapet::surrogate {
namespace {

constexpr double two_to_32 = 4294967296.0;

double shifted(double coordinate, std::uint32_t shift) {
  const auto bits = static_cast<std::uint32_t>(coordinate * two_to_32);
  return (static_cast<double>(bits ^ shift) + 0.5) / two_to_32;
}

}  // namespace

double uniform(std::mt19937_64& generator) {
  return (static_cast<double>(generator() >> 12) + 0.5) / 4503599627370496.0;
}

Eigen::MatrixXd unit_points(int n, int dimension, std::uint64_t seed) {
  Eigen::MatrixXd points(n, dimension);
  if (n == 0 || dimension == 0) return points;
  std::mt19937_64 generator(seed);
  const int n_sobol = std::min(dimension, optimizer::SobolSequence::max_dimension);
  std::vector<std::uint32_t> shift(static_cast<std::size_t>(n_sobol));
  for (std::uint32_t& word : shift) word = static_cast<std::uint32_t>(generator() >> 32);
  optimizer::SobolSequence sobol(n_sobol);
  std::vector<double> point(shift.size(), 0.0);  // the corner, which the sequence leaves out
  for (int k = 0; k < n; ++k) {
    if (k > 0) point = sobol.next();
    for (int d = 0; d < n_sobol; ++d) {
      const auto s = static_cast<std::size_t>(d);
      points(k, d) = shifted(point[s], shift[s]);
    }
    for (int d = n_sobol; d < dimension; ++d) points(k, d) = uniform(generator);
  }
  return points;
}

}  // namespace parapet::surrogate
