/// Minimum of a smooth function within bounds.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace parapet::surrogate {

/// Value at x [n]; fills the gradient [n]. Not finite where the function is not defined.
using SmoothFunction = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct Bounds {
  Eigen::VectorXd lower, upper;  ///< [n]; equal where a coordinate is fixed
};

/// Where a descent stands. `inverse_hessian` [n, n] is empty before the first step.
struct Descent {
  Eigen::VectorXd x, gradient;
  double value = 0.0;
  Eigen::MatrixXd inverse_hessian;
  int evaluations = 0;
  bool finished = false;  ///< converged, or no further descent is possible
};

/// The state at x, clipped to the bounds.
Descent begin_descent(const SmoothFunction& function, const Eigen::VectorXd& x,
                      const Bounds& bounds);

/// Goes on until `max_evaluations` calls in all or until two steps in a row gain less than
/// `tolerance`. BFGS with steps clipped to the bounds; coordinates that press against a bound stay
/// (Nocedal and Wright, Numerical Optimization, 2006, algorithm 6.1 and section 16.7); the step
/// length by backtracking (Armijo).
void continue_descent(const SmoothFunction& function, const Bounds& bounds, int max_evaluations,
                      double tolerance, Descent& descent);

}  // namespace parapet::surrogate
