/// Sums, differences and normal probabilities as logarithms.
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "infinity.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/math/normal_tail.hpp"

namespace parapet::acquisition {
namespace {

/// log(Phi(b) - Phi(a)) for a < b <= 0. The density at b is taken out, so that nothing underflows:
///   Phi(b) - Phi(a) = phi(b) (R(-b) - R(-a) exp((b^2 - a^2) / 2)).
/// `width` is b - a, known better than their difference.
double log_tail_interval(double a, double b, double width) {
  if (width * std::max(1.0, -a) < 1e-3) {
    // Thin: phi at the middle times the width, with the second derivative's share; the next term is
    // (width t)^4 / 1920 and the subtraction below would lose more digits than that.
    const double middle = b - 0.5 * width;
    return math::log_normal_density(middle) + std::log(width) +
           std::log1p((middle * middle - 1.0) * width * width / 24.0);
  }
  if (a == -infinity) return math::log_normal_cdf(b);
  const double decay = std::exp(0.5 * width * (a + b));
  return math::log_normal_density(b) +
         std::log(math::mills_ratio(-b) - math::mills_ratio(-a) * decay);
}

}  // namespace

double log_expected_excess(double x, double sigma) {
  if (sigma == 0.0) return std::log(std::max(0.0, x));
  const double t = x / sigma;
  if (t > 0.0) {
    if (!(t < infinity)) return std::log(x);
    return std::log(x + sigma * std::exp(math::log_normal_density(t)) * math::excess_factor()(t));
  }
  return std::log(sigma) + math::log_normal_density(t) + std::log(math::excess_factor()(-t));
}

double log_difference(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::quiet_NaN();
  if (a <= b) return -infinity;
  if (b == -infinity) return a;
  const double gap = a - b;
  return a + (gap < std::numbers::ln2 ? std::log(-std::expm1(-gap)) : std::log1p(-std::exp(-gap)));
}

double log_sum(double a, double b) {
  if (a < b) std::swap(a, b);
  if (b == -infinity || a == infinity) return a;
  return a + std::log1p(std::exp(b - a));
}

double log_mean(const Eigen::VectorXd& v) {
  if (v.size() == 0) return -infinity;
  const double greatest = v.maxCoeff<Eigen::PropagateNaN>();
  if (!std::isfinite(greatest)) return greatest;
  double sum = 0.0;
  for (const double value : v) sum += std::exp(value - greatest);
  return greatest + std::log(sum / static_cast<double>(v.size()));
}

double log_probability_within(double mean, double sd, double lower, double upper) {
  if (sd == 0.0) return lower <= mean && mean <= upper ? 0.0 : -infinity;
  if (!(lower < upper)) return -infinity;
  const double a = (lower - mean) / sd, b = (upper - mean) / sd, width = (upper - lower) / sd;
  if (b <= 0.0) return log_tail_interval(a, b, width);
  if (a >= 0.0) return log_tail_interval(-b, -a, width);
  const double left_out =
      0.5 * (std::erfc(-a * math::inverse_sqrt_two) + std::erfc(b * math::inverse_sqrt_two));
  if (left_out < 0.5) return std::log1p(-left_out);
  return std::log(0.5 *
                  (std::erf(-a * math::inverse_sqrt_two) + std::erf(b * math::inverse_sqrt_two)));
}

}  // namespace parapet::acquisition
