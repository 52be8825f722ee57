#include "parapet/math/student.hpp"

#include <cmath>

#include "parapet/math/normal.hpp"

namespace parapet::math {
namespace {

/// Beyond so many degrees of freedom the normal distribution has the digits of a double here.
constexpr double as_normal = 1e10;

/// The continued fraction of the incomplete beta function, by Lentz's method.
double beta_fraction(double a, double b, double x) {
  constexpr double tiny = 1e-300, enough = 1e-15;
  constexpr int most_terms = 20000;
  const auto off_zero = [](double value) { return std::abs(value) < tiny ? tiny : value; };
  double c = 1.0, d = 1.0 / off_zero(1.0 - (a + b) * x / (a + 1.0)), fraction = d;
  for (int k = 1; k < most_terms; ++k) {
    const double m = k;
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    d = 1.0 / off_zero(1.0 + even * d);
    c = off_zero(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    d = 1.0 / off_zero(1.0 + odd * d);
    c = off_zero(1.0 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < enough) break;
  }
  return fraction;
}

/// I_x(a, b); y is 1 - x with all its digits.
double incomplete_beta(double a, double b, double x, double y) {
  if (x <= 0.0) return 0.0;
  if (y <= 0.0) return 1.0;
  const double log_front =
      std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(y);
  if (x < (a + 1.0) / (a + b + 2.0)) return std::exp(log_front) * beta_fraction(a, b, x) / a;
  return 1.0 - std::exp(log_front) * beta_fraction(b, a, y) / b;
}

}  // namespace

double student_cdf(double t, double freedom) {
  if (freedom > as_normal) return normal_cdf(t);
  const double square = t * t;
  const double tail = 0.5 * incomplete_beta(0.5 * freedom, 0.5, freedom / (freedom + square),
                                            square / (freedom + square));
  return t < 0.0 ? tail : 1.0 - tail;
}

double student_quantile(double p, double freedom) {
  if (p == 0.5) return 0.0;
  if (p > 0.5) return -student_quantile(1.0 - p, freedom);
  if (freedom > as_normal) return normal_quantile(p);
  double low = -1.0;
  while (student_cdf(low, freedom) > p) low *= 2.0;
  double high = 0.0;
  constexpr int halvings = 80;  // down to the last digit
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (student_cdf(middle, freedom) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace parapet::math
