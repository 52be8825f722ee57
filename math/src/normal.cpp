#include "parapet/math/normal.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "parapet/math/normal_tail.hpp"

namespace parapet::math {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Below this Phi comes from Mills' ratio, above from erfc; both are good to the last digits here.
constexpr double far_tail = -10.0;

template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double r) {
  double sum = 0.0;
  for (std::size_t k = N; k-- > 0;) sum = sum * r + coefficients[k];
  return sum;
}

}  // namespace

double normal_cdf(double t) {
  return 0.5 * std::erfc(-t / std::numbers::sqrt2);
}

double log_normal_density(double t) {
  return -0.5 * t * t - log_sqrt_two_pi;
}

double mills_ratio(double t) {
  if (t < -far_tail) {
    return 0.5 * std::erfc(t * inverse_sqrt_two) * std::exp(0.5 * t * t) / inverse_sqrt_two_pi;
  }
  return (1.0 - excess_factor()(t)) / t;
}

double log_normal_cdf(double t) {
  if (t > 0.0) return std::log1p(-0.5 * std::erfc(t * inverse_sqrt_two));
  if (t > far_tail) return std::log(0.5 * std::erfc(-t * inverse_sqrt_two));
  if (t == -infinity) return -infinity;
  return log_normal_density(t) + std::log(mills_ratio(-t));
}

double normal_hazard(double t) {
  // phi(t) / Phi(t) = 1 / R(-t)
  if (t > 0.0) return std::exp(log_normal_density(t)) / normal_cdf(t);
  return 1.0 / mills_ratio(-t);
}

double normal_quantile(double p) {
  static constexpr std::array a{3.3871328727963666080e0, 1.3314166789178437745e2,
                                1.9715909503065514427e3, 1.3731693765509461125e4,
                                4.5921953931549871457e4, 6.7265770927008700853e4,
                                3.3430575583588128105e4, 2.5090809287301226727e3};
  static constexpr std::array b{1.0,
                                4.2313330701600911252e1,
                                6.8718700749205790830e2,
                                5.3941960214247511077e3,
                                2.1213794301586595867e4,
                                3.9307895800092710610e4,
                                2.8729085735721942674e4,
                                5.2264952788528545610e3};
  static constexpr std::array c{1.42343711074968357734e0,  4.63033784615654529590e0,
                                5.76949722146069140550e0,  3.64784832476320460504e0,
                                1.27045825245236838258e0,  2.41780725177450611770e-1,
                                2.27238449892691845833e-2, 7.74545014278341407640e-4};
  static constexpr std::array d{1.0,
                                2.05319162663775882187e0,
                                1.67638483018380384940e0,
                                6.89767334985100004550e-1,
                                1.48103976427480074590e-1,
                                1.51986665636164571966e-2,
                                5.47593808499534494600e-4,
                                1.05075007164441684324e-9};
  static constexpr std::array e{6.65790464350110377720e0,  5.46378491116411436990e0,
                                1.78482653991729133580e0,  2.96560571828504891230e-1,
                                2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                2.71155556874348757815e-5, 2.01033439929228813265e-7};
  static constexpr std::array f{1.0,
                                5.99832206555887937690e-1,
                                1.36929880922735805310e-1,
                                1.48753612908506148525e-2,
                                7.86869131145613259100e-4,
                                1.84631831751005468180e-5,
                                1.42151175831644588870e-7,
                                2.04426310338993978564e-15};
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(a, r) / polynomial(b, r);
  }
  const double r = std::sqrt(-std::log(q < 0.0 ? p : 1.0 - p));
  const double t = r <= 5.0 ? polynomial(c, r - 1.6) / polynomial(d, r - 1.6)
                            : polynomial(e, r - 5.0) / polynomial(f, r - 5.0);
  return q < 0.0 ? -t : t;
}

}  // namespace parapet::math
