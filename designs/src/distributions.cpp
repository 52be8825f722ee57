#include "distributions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace parapet::designs {
namespace {

/// Polynomial with rising powers.
double polynomial(const std::array<double, 8>& coefficients, double x) {
  double value = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) value = value * x + coefficients[i];
  return value;
}

// The coefficients of AS 241: near the middle, and in the tails up to and beyond r = 5.
constexpr std::array<double, 8> a{3.3871328727963666080e0,  1.3314166789178437745e+2,
                                  1.9715909503065514427e+3, 1.3731693765509461125e+4,
                                  4.5921953931549871457e+4, 6.7265770927008700853e+4,
                                  3.3430575583588128105e+4, 2.5090809287301226727e+3};
constexpr std::array<double, 8> b{1.0,
                                  4.2313330701600911252e+1,
                                  6.8718700749205790830e+2,
                                  5.3941960214247511077e+3,
                                  2.1213794301586595867e+4,
                                  3.9307895800092710610e+4,
                                  2.8729085735721942674e+4,
                                  5.2264952788528545610e+3};
constexpr std::array<double, 8> c{1.42343711074968357734e0,  4.63033784615654529590e0,
                                  5.76949722146069140550e0,  3.64784832476320460504e0,
                                  1.27045825245236838258e0,  2.41780725177450611770e-1,
                                  2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr std::array<double, 8> d{1.0,
                                  2.05319162663775882187e0,
                                  1.67638483018380384940e0,
                                  6.89767334985100004550e-1,
                                  1.48103976427480074590e-1,
                                  1.51986665636164571966e-2,
                                  5.47593808499534494600e-4,
                                  1.05075007164441684324e-9};
constexpr std::array<double, 8> e{6.65790464350110377720e0,  5.46378491116411436990e0,
                                  1.78482653991729133580e0,  2.96560571828504891230e-1,
                                  2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                  2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr std::array<double, 8> f{1.0,
                                  5.99832206555887937690e-1,
                                  1.36929880922735805310e-1,
                                  1.48753612908506148525e-2,
                                  7.86869131145613259100e-4,
                                  1.84631831751005468180e-5,
                                  1.42151175831644588870e-7,
                                  2.04426310338993978564e-15};

/// Mean and standard deviation of the (logarithm of the) quantity.
struct Normal {
  double mean, sd;
};

Normal underlying(const Distribution& distribution) {
  if (distribution.kind != DistributionKind::lognormal) return {distribution.mean, distribution.sd};
  const double ratio = distribution.sd / distribution.mean;
  const double variance = std::log1p(ratio * ratio);
  return {std::log(distribution.mean) - 0.5 * variance, std::sqrt(variance)};
}

/// Share of the untruncated distribution below a value.
double share_below(const Distribution& distribution, double value) {
  const Normal normal = underlying(distribution);
  if (distribution.kind == DistributionKind::lognormal) {
    if (value <= 0.0) return 0.0;
    value = std::log(value);
  }
  return normal_cdf((value - normal.mean) / normal.sd);
}

double triangular_quantile(const Distribution& t, double p) {
  const double width = t.upper - t.lower;
  const double below_mode = (t.mode - t.lower) / width;
  if (p < below_mode) return t.lower + std::sqrt(p * width * (t.mode - t.lower));
  return t.upper - std::sqrt((1.0 - p) * width * (t.upper - t.mode));
}

/// A number of [0, 1) with 53 random bits.
double draw(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1.0p-53;
}

}  // namespace

double normal_cdf(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

double normal_quantile(double p) {
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(a, r) / polynomial(b, r);
  }
  const double r = std::sqrt(-std::log(q < 0.0 ? p : 1.0 - p));
  const double z = r <= 5.0 ? polynomial(c, r - 1.6) / polynomial(d, r - 1.6)
                            : polynomial(e, r - 5.0) / polynomial(f, r - 5.0);
  return q < 0.0 ? -z : z;
}

double kept_share(const Distribution& distribution) {
  if (distribution.kind == DistributionKind::uniform ||
      distribution.kind == DistributionKind::triangular) {
    return 1.0;
  }
  return share_below(distribution, distribution.upper) -
         share_below(distribution, distribution.lower);
}

double quantile(const Distribution& distribution, double p) {
  if (distribution.kind == DistributionKind::uniform) {
    return distribution.lower + p * (distribution.upper - distribution.lower);
  }
  if (distribution.kind == DistributionKind::triangular) {
    return triangular_quantile(distribution, p);
  }
  const double share = share_below(distribution, distribution.lower) + p * kept_share(distribution);
  constexpr double least = std::numeric_limits<double>::min();
  constexpr double most = 1.0 - std::numeric_limits<double>::epsilon();
  const Normal normal = underlying(distribution);
  const double value = normal.mean + normal.sd * normal_quantile(std::clamp(share, least, most));
  return std::clamp(distribution.kind == DistributionKind::lognormal ? std::exp(value) : value,
                    distribution.lower, distribution.upper);
}

std::vector<std::vector<double>> latin_hypercube(std::size_t n_points, std::size_t n_dimensions,
                                                 std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::vector<double>> shares(n_dimensions, std::vector<double>(n_points));
  for (std::vector<double>& column : shares) {
    for (std::size_t i = 0; i < n_points; ++i) {
      column[i] = (static_cast<double>(i) + draw(generator)) / static_cast<double>(n_points);
      column[i] = std::clamp(column[i], 0x1.0p-53, 1.0 - 0x1.0p-53);
    }
    for (std::size_t i = n_points; i-- > 1;) {  // Fisher and Yates
      const auto j = static_cast<std::size_t>(draw(generator) * static_cast<double>(i + 1));
      std::swap(column[i], column[j]);
    }
  }
  return shares;
}

}  // namespace parapet::designs
