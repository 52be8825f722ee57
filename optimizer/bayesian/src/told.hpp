/// What a search knows: evaluations told and pending.
#pragma once

#include <vector>

#include "parapet/bayesian/search.hpp"

namespace parapet::bayesian {

/// An evaluation that was told.
struct Told {
  int id = 0;
  Point x;
  int level = 0;
  bool ok = false;
  std::vector<std::optional<double>> values;  ///< [n_metrics], exact and composed ones filled in
  double seconds = 0.0;
  bool local = false;  ///< asked for as a local step
};

/// Whether every limit is met by these values; a metric without a value counts as the limit says.
bool meets_limits(const Problem& problem, const std::vector<std::optional<double>>& values,
                  double tolerance);

/// The objectives of values, minimised; empty when one has no value.
std::optional<Eigen::VectorXd> minimized(const Problem& problem,
                                         const std::vector<std::optional<double>>& values);

}  // namespace parapet::bayesian
