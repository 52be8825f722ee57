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

  /// log of the probability of success [m] at inputs [m, n_features]; <= 0, finite. It is taken at
  /// the latent function's mean, Phi(mean), not averaged over its uncertainty as in equation (3.82)
  /// of the book: whether a simulation fails is a matter of place, not of chance, and the average
  /// falls so slowly next to failures that a search asks for the same failing corner again and
  /// again (17 of 34 evaluations of a test problem instead of 6).
  Eigen::VectorXd log_probability(const Eigen::MatrixXd& inputs) const;

  /// Whether an evaluation failed; without one the probability is 1 everywhere.
  bool any_failure() const { return any_failure_; }

 private:
  Layout layout_;
  Eigen::MatrixXd inputs_;
  Eigen::VectorXd length_scales_;
  double amplitude_ = 1.0;
  double mean_ = 0.0;
  Eigen::VectorXd gradient_;  // of the log likelihood at the mode
  bool any_failure_ = false;
};

}  // namespace parapet::surrogate
