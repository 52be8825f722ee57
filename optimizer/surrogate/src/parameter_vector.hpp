/// The parameters of a Gaussian process as one vector, with their priors.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parapet/surrogate/gaussian_process.hpp"
#include "quasi_newton.hpp"

namespace parapet::surrogate {

/// Where a level's parameters lie in the vector: log length scales [n_groups], log amplitude, log
/// noise, coupling; level after level. Means are not among them: the likelihood solves for them.
class ParameterVector {
 public:
  ParameterVector(int n_groups, int n_levels) : n_groups_(n_groups), n_levels_(n_levels) {}

  int n_groups() const { return n_groups_; }
  int n_levels() const { return n_levels_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(n_levels_) * stride(); }
  Eigen::Index length(int level, int group) const { return level * stride() + group; }
  Eigen::Index amplitude(int level) const { return length(level, n_groups_); }
  Eigen::Index noise(int level) const { return amplitude(level) + 1; }
  Eigen::Index coupling(int level) const { return amplitude(level) + 2; }

  Eigen::VectorXd pack(const std::vector<LevelParameters>& levels) const;
  std::vector<LevelParameters> unpack(const Eigen::VectorXd& x) const;  ///< means 0

 private:
  Eigen::Index stride() const { return n_groups_ + 3; }
  int n_groups_, n_levels_;
};

/// Independent normal priors of the vector's entries within bounds.
struct Priors {
  Eigen::VectorXd centre, deviation;  ///< [size]
  Bounds bounds;
  /// Inverse covariance of the levels' means [n_levels, n_levels].
  Eigen::MatrixXd mean_precision;

  /// log density up to a constant, added to nothing; its gradient is added to `gradient`.
  double log_density(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;
};

/// Weakly informative priors for inputs in the unit cube and standardised outputs.
/// known_noise [n_levels] in model units, or empty.
Priors make_priors(const ParameterVector& vector, const std::vector<double>& known_noise);

}  // namespace parapet::surrogate
