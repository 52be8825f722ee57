/// Random numbers that are the same on every machine: the distributions of <random> are not.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace parapet {

class SeededDraws {
 public:
  explicit SeededDraws(std::uint64_t seed) : engine_(seed) {}

  /// In (0, 1).
  double uniform() { return (static_cast<double>(engine_() >> 11U) + 0.5) * 0x1p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

  /// Standard normal, by the method of Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

  Eigen::VectorXd point(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
    Eigen::VectorXd x(lower.size());
    for (Eigen::Index j = 0; j < x.size(); ++j) x[j] = uniform(lower[j], upper[j]);
    return x;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace parapet
