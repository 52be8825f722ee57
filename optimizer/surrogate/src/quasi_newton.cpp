#include "quasi_newton.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::surrogate {
namespace {

constexpr double sufficient_decrease = 1e-4;
constexpr double largest_step = 2.0;  // per coordinate; coordinates are logarithms or near 1
constexpr double flat = 1e-6;         // largest component of the gradient at a minimum

Eigen::VectorXd clipped(const Eigen::VectorXd& x, const Bounds& bounds) {
  return x.cwiseMax(bounds.lower).cwiseMin(bounds.upper);
}

/// The gradient, 0 in coordinates that it presses against a bound.
Eigen::VectorXd free_gradient(const Descent& at, const Bounds& bounds) {
  Eigen::VectorXd g = at.gradient;
  for (Eigen::Index i = 0; i < g.size(); ++i) {
    const bool held =
        (at.x(i) <= bounds.lower(i) && g(i) >= 0.0) || (at.x(i) >= bounds.upper(i) && g(i) <= 0.0);
    if (held) g(i) = 0.0;
  }
  return g;
}

Eigen::VectorXd direction(const Descent& at, const Eigen::VectorXd& free) {
  Eigen::VectorXd d = -(at.inverse_hessian * free);
  for (Eigen::Index i = 0; i < d.size(); ++i) {
    if (free(i) == 0.0) d(i) = 0.0;
  }
  if (!(d.dot(free) < 0.0)) d = -free;
  const double largest = d.cwiseAbs().maxCoeff();
  if (largest > largest_step) d *= largest_step / largest;
  return d;
}

void update_inverse_hessian(const Eigen::VectorXd& s, const Eigen::VectorXd& y, bool first,
                            Eigen::MatrixXd& h) {
  const double sy = s.dot(y);
  if (!(sy > 1e-8 * s.norm() * y.norm())) return;
  if (first) h = Eigen::MatrixXd::Identity(s.size(), s.size()) * (sy / y.squaredNorm());
  // (I - s y'/sy) H (I - y s'/sy) + s s'/sy, equation (6.17) of Nocedal and Wright.
  const Eigen::VectorXd hy = h * y;
  h += ((sy + y.dot(hy)) / (sy * sy)) * (s * s.transpose()) -
       (hy * s.transpose() + s * hy.transpose()) / sy;
}

/// A step along d that gains enough; false: there is none.
bool line_search(const SmoothFunction& function, const Bounds& bounds, int max_evaluations,
                 const Eigen::VectorXd& d, const Eigen::VectorXd& free, Descent& at) {
  double length = 1.0;
  Eigen::VectorXd gradient(at.x.size());
  for (int trial = 0; trial < 20 && at.evaluations < max_evaluations; ++trial) {
    const Eigen::VectorXd x = clipped(at.x + length * d, bounds);
    const double slope = free.dot(x - at.x);
    const double value = function(x, gradient);
    ++at.evaluations;
    const bool usable = std::isfinite(value) && gradient.allFinite();
    if (usable && value <= at.value + sufficient_decrease * slope) {
      at.x = x;
      at.value = value;
      at.gradient = gradient;
      return true;
    }
    // Minimum of the parabola through both values and the slope.
    double shrink = 0.1;
    if (usable) shrink = std::clamp(-0.5 * slope / (value - at.value - slope), 0.1, 0.5);
    length *= shrink;
  }
  return false;
}

}  // namespace

Descent begin_descent(const SmoothFunction& function, const Eigen::VectorXd& x,
                      const Bounds& bounds) {
  Descent at;
  at.x = clipped(x, bounds);
  at.gradient.resize(x.size());
  at.value = function(at.x, at.gradient);
  at.evaluations = 1;
  at.finished = !std::isfinite(at.value) || !at.gradient.allFinite();
  return at;
}

void continue_descent(const SmoothFunction& function, const Bounds& bounds, int max_evaluations,
                      double tolerance, Descent& at) {
  bool first = at.inverse_hessian.size() == 0;
  int small_gains = 0;
  while (!at.finished && at.evaluations < max_evaluations) {
    const Eigen::VectorXd free = free_gradient(at, bounds);
    const double steepest = free.size() == 0 ? 0.0 : free.cwiseAbs().maxCoeff();
    if (steepest < flat) {
      at.finished = true;
      return;
    }
    if (first) {
      at.inverse_hessian =
          Eigen::MatrixXd::Identity(free.size(), free.size()) * std::min(1.0, 1.0 / steepest);
    }
    const Descent before = at;
    if (!line_search(function, bounds, max_evaluations, direction(at, free), free, at)) {
      at.finished = at.evaluations < max_evaluations;
      return;
    }
    update_inverse_hessian(at.x - before.x, at.gradient - before.gradient, first,
                           at.inverse_hessian);
    first = false;
    small_gains = before.value - at.value < tolerance ? small_gains + 1 : 0;
    at.finished = small_gains >= 2;
  }
}

}  // namespace parapet::surrogate
