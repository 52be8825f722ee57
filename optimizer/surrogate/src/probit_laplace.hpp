/// Laplace's approximation of a Gaussian process seen through a probit likelihood.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parapet/surrogate/gaussian_process.hpp"
#include "quasi_newton.hpp"

namespace parapet::surrogate {

/// The mode of the latent values and the curvature there.
struct LaplaceMode {
  Eigen::VectorXd latent;        // [n]
  Eigen::VectorXd gradient;      // [n] of the log likelihood: K^-1 (latent - mean)
  Eigen::VectorXd third;         // [n] its third derivatives
  Eigen::VectorXd root_weights;  // [n] square root of W = - second derivatives
  Eigen::MatrixXd factor;        // [n, n] lower Cholesky factor of B = I + W^1/2 K W^1/2
  double log_evidence = 0.0;
};

/// Newton's iteration for the mode (Rasmussen and Williams, 2006, algorithm 3.1), steps halved
/// while the objective falls. covariance [n, n]; signs [n]: +1 success, -1 failure.
LaplaceMode find_mode(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& signs, double mean);

/// Approximate log evidence plus log prior of x = (log length scales [n_groups], log amplitude).
/// The prior mean of the latent process is no parameter of its own but Phi^-1(b), so that far from
/// all data the predicted probability is the base rate b.
class ProbitEvidence {
 public:
  ProbitEvidence(const Layout& layout, const Eigen::MatrixXd& inputs, const Eigen::VectorXd& signs);

  Eigen::Index size() const { return static_cast<Eigen::Index>(squares_.size()) + 1; }
  const Eigen::VectorXd& centre() const { return centre_; }
  const Eigen::VectorXd& deviation() const { return deviation_; }
  const Bounds& bounds() const { return bounds_; }

  /// The gradient [size] after Rasmussen and Williams, 2006, section 5.5.1.
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;

  double mean() const { return base_quantile_; }  ///< of the latent function
  LaplaceMode mode(const Eigen::VectorXd& x) const;

 private:
  /// Covariance at x; `slope` is filled so that dK / d log l_g = slope * squares_g / l_g^2.
  Eigen::MatrixXd covariance(const Eigen::VectorXd& x, Eigen::ArrayXXd* slope) const;

  Eigen::VectorXd signs_;
  std::vector<Eigen::ArrayXXd> squares_;  // [n_groups] squared differences [n, n]
  Eigen::VectorXd centre_, deviation_;
  Bounds bounds_;
  double base_quantile_ = 0.0;
};

}  // namespace parapet::surrogate
