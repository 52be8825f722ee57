#include "distributions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "parapet/math/normal.hpp"

namespace parapet::designs {
namespace {

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
  return math::normal_cdf((value - normal.mean) / normal.sd);
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
  const double value =
      normal.mean + normal.sd * math::normal_quantile(std::clamp(share, least, most));
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
