/// Probability that an evaluation succeeds at all.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::surrogate {

/// Gaussian process classifier: probit likelihood, Matern 5/2, Laplace's approximation (Rasmussen
/// and Williams, Gaussian Processes for Machine Learning, 2006, section 3.4), parameters by its
/// approximate marginal likelihood with priors. Without any failure the probability is 1
/// everywhere: nothing is known against any design.
class SuccessModel {
 public:
  /// inputs [n, n_features]; succeeded [n]. Layout::n_levels is not used.
  static SuccessModel fit(const Layout& layout, const Eigen::MatrixXd& inputs,
                          const std::vector<bool>& succeeded, std::uint64_t seed = 1);

  /// log of the probability of success [m] at inputs [m, n_features]; <= 0, finite.
  Eigen::VectorXd log_probability(const Eigen::MatrixXd& inputs) const;

  bool any_failure() const { return any_failure_; }

 private:
  Layout layout_;
  Eigen::MatrixXd inputs_;
  Eigen::VectorXd length_scales_;
  double amplitude_ = 1.0;
  double mean_ = 0.0;
  Eigen::VectorXd gradient_;      // of the log likelihood at the mode
  Eigen::VectorXd root_weights_;  // square root of W
  Eigen::MatrixXd factor_;        // Cholesky factor of I + W^1/2 K W^1/2
  bool any_failure_ = false;
};

}  // namespace parapet::surrogate
