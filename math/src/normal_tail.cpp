#include "parapet/math/normal_tail.hpp"

#include <cmath>
#include <numbers>

namespace parapet::math {
namespace {

/// q(t) by ways that are slow and sure: for small t by its definition (at t = 2 a factor of four is
/// lost of long double's digits), beyond by the continued fraction of Mills' ratio
///   R(t) = 1 / (t + 1 / (t + 2 / (t + 3 / (t + ...))))  (Abramowitz and Stegun 26.2.14).
long double reference_excess_factor(long double t) {
  if (t < 2.0L) {
    const long double mills = std::sqrt(std::numbers::pi_v<long double> / 2.0L) *
                              std::exp(t * t / 2.0L) * std::erfc(t / std::sqrt(2.0L));
    return 1.0L - t * mills;
  }
  long double tail = 0.0L;  // 1 / (t + 2 / (t + ...)); 400 terms are enough from t = 2 on
  for (int k = 400; k >= 1; --k) tail = static_cast<long double>(k) / (t + tail);
  return tail / (t + tail);
}

}  // namespace

ExcessFactor::ExcessFactor() {
  // Chebyshev interpolation of q / y^2 in each piece, then as powers of s in [-1, 1].
  using Row = std::array<long double, n_terms>;
  constexpr auto pi = std::numbers::pi_v<long double>;
  constexpr auto n = static_cast<long double>(n_terms);
  for (std::size_t piece = 0; piece < n_pieces; ++piece) {
    Row values{};
    for (std::size_t i = 0; i < n_terms; ++i) {
      const long double s = std::cos(pi * (static_cast<long double>(i) + 0.5L) / n);
      const long double position = static_cast<long double>(piece) + (s + 1.0L) / 2.0L;
      const long double y =
          static_cast<long double>(least_y) + position / static_cast<long double>(pieces_per_y);
      values[i] = reference_excess_factor(std::max(4.0L / y - 4.0L, 0.0L)) / (y * y);
    }
    Row powers{}, before{}, current{};  // `current` holds the powers of T_k
    current[0] = 1.0L;
    for (std::size_t k = 0; k < n_terms; ++k) {
      long double weight = 0.0L;
      for (std::size_t i = 0; i < n_terms; ++i) {
        weight += values[i] * std::cos(pi * static_cast<long double>(k) *
                                       (static_cast<long double>(i) + 0.5L) / n);
      }
      weight *= (k == 0 ? 1.0L : 2.0L) / n;
      Row next{};
      for (std::size_t j = 0; j < n_terms; ++j) {
        powers[j] += weight * current[j];
        if (j + 1 < n_terms) next[j + 1] = (k == 0 ? 1.0L : 2.0L) * current[j];
      }
      for (std::size_t j = 0; j < n_terms; ++j) next[j] -= before[j];
      before = current;
      current = next;
    }
    for (std::size_t j = 0; j < n_terms; ++j) {
      pieces_[piece][j] = static_cast<double>(powers[j]);
    }
  }
}

double ExcessFactor::series(double t) {
  // Asymptotic; at t = 40 the first term left out, 15!! / t^14, is below 1e-16.
  const double u = 1.0 / (t * t);
  double sum = 1.0;
  for (int k = 13; k >= 3; k -= 2) sum = 1.0 - k * u * sum;
  return u * sum;
}

const ExcessFactor& excess_factor() {
  static const ExcessFactor table;
  return table;
}

}  // namespace parapet::math
