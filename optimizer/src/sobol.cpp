#include "parapet/optimizer/sobol.hpp"

#include <array>
#include <bit>
#include <stdexcept>
#include <string>

namespace parapet::optimizer {
namespace {

/// Primitive polynomial of degree s with the inner coefficients a (as bits), and the first s odd
/// direction integers m.
struct Direction {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 7> m;
};

// Joe and Kuo, new-joe-kuo-6.21201, dimensions 2 to 21; dimension 1 is van der Corput's sequence.
constexpr std::array<Direction, SobolSequence::max_dimension - 1> joe_kuo = {{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

}  // namespace

SobolSequence::SobolSequence(int dimension) {
  if (dimension < 1 || dimension > max_dimension) {
    throw std::invalid_argument("Sobol' points exist here for 1 to " +
                                std::to_string(max_dimension) + " dimensions, not " +
                                std::to_string(dimension));
  }
  const auto n = static_cast<std::size_t>(dimension);
  state_.assign(n, 0);
  direction_.assign(n * n_bits, 0);
  for (int bit = 0; bit < n_bits; ++bit) {
    direction_[static_cast<std::size_t>(bit)] = 1U << (n_bits - 1 - bit);
  }
  for (std::size_t d = 1; d < n; ++d) {
    const Direction& row = joe_kuo[d - 1];
    std::uint32_t* v = &direction_[d * n_bits];
    for (int bit = 0; bit < n_bits; ++bit) {
      if (bit < row.degree) {
        v[bit] = row.m[static_cast<std::size_t>(bit)] << (n_bits - 1 - bit);
        continue;
      }
      v[bit] = v[bit - row.degree] ^ (v[bit - row.degree] >> row.degree);
      for (int k = 1; k < row.degree; ++k) {
        if ((row.coefficients >> (row.degree - 1 - k)) & 1U) v[bit] ^= v[bit - k];
      }
    }
  }
}

std::vector<double> SobolSequence::next() {
  const auto bit = static_cast<std::size_t>(std::countr_one(index_));
  ++index_;
  std::vector<double> point(state_.size());
  for (std::size_t d = 0; d < state_.size(); ++d) {
    state_[d] ^= direction_[d * n_bits + bit];
    point[d] = static_cast<double>(state_[d]) * 0x1p-32;
  }
  return point;
}

}  // namespace parapet::optimizer
