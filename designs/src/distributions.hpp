/// Distributions of the inputs that differ between events, and samples of them.
#pragma once

#include <cstdint>
#include <vector>

namespace parapet::designs {

enum class DistributionKind { normal, lognormal, uniform, triangular };

/// In the unit of the quantity. normal, lognormal: mean and sd of the quantity itself before it is
/// truncated to [lower, upper], which may be infinite. uniform, triangular: lower, upper (and
/// mode).
struct Distribution {
  DistributionKind kind = DistributionKind::uniform;
  double mean = 0.0, sd = 1.0;
  double lower = 0.0, upper = 1.0;
  double mode = 0.5;
};

/// Share of the untruncated normal or lognormal distribution between lower and upper; 1 for the
/// others.
double kept_share(const Distribution& distribution);

/// The value below which the share p lies, 0 < p < 1, after truncation.
double quantile(const Distribution& distribution, double p);

/// Latin hypercube (McKay, Beckman and Conover 1979, Technometrics 21, 239-245): for each of the
/// dimensions [n_dimensions], n_points shares [n_points] in (0, 1), one drawn evenly from each of
/// n_points strata, in random order.
std::vector<std::vector<double>> latin_hypercube(std::size_t n_points, std::size_t n_dimensions,
                                                 std::uint64_t seed);

}  // namespace parapet::designs
