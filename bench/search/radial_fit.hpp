// Smooth surface through scattered, slightly noisy values in the unit cube.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace parapet::bench::search {

// s(u) = sum_i weights_i |(u - u_i) scale|^3 + tail_0 + tail_1.. . u: the cubic polyharmonic spline
// (Duchon, RAIRO Anal. Numer. 10 (1976) 5-12) with a linear tail, smoothed by a ridge:
//   (K + ridge I) weights + P tail = values,  P^T weights = 0.
struct RadialSurface {
  Eigen::VectorXd scale;    // [d] stretches each coordinate, > 0
  Eigen::VectorXd weights;  // [n]
  Eigen::VectorXd tail;     // [d + 1]

  // designs [n, d]: those of the fit; u [d].
  double at(const Eigen::MatrixXd& designs, const Eigen::VectorXd& u) const;
};

struct RadialFit {
  RadialSurface surface;
  double ridge = 0.0;
  Eigen::VectorXd leave_one_out;   // [n] each value less what all others predict, closed form
  double leave_one_out_rms = 0.0;  // its root mean square
  double q_squared = 0.0;          // 1 - its mean square over the variance of the values
  // Standard deviation of what does not repeat from one design to its neighbour:
  // sqrt(sum of squared residuals / trace(I - H)), H being the smoother's matrix (Wahba,
  // J. R. Stat. Soc. B 45 (1983) 133-150).
  double noise = 0.0;
};

// The ridge has the least leave-one-out error; so have the scales, chosen one coordinate after the
// other from powers of two on at most 400 of the designs.
// designs [n, d] in the unit cube, values [n]; n > d + 2.
// @throws std::invalid_argument for fewer.
RadialFit fit_radial(const Eigen::MatrixXd& designs, const Eigen::VectorXd& values);

// The same with given scales [d], and with a given ridge where there is one.
RadialFit fit_radial(const Eigen::MatrixXd& designs, const Eigen::VectorXd& values,
                     const Eigen::VectorXd& scale, std::optional<double> ridge = std::nullopt);

}  // namespace parapet::bench::search
