/// Wendland C2 kernel in two dimensions (Eq. 5): W = alpha_D (1 - q/2)^4 (2q + 1) for q = r/h <= 2,
/// alpha_D = 7/(4 pi h^2). Its gradient is F r_ij with F = W'/r = -(5 alpha_D/h^2) (1 - q/2)^3,
/// which needs no division and is finite at r = 0.
#pragma once

#include <cmath>
#include <numbers>

namespace parapet::solver {

/// So many particles the neighbour sums treat at a time, one in each lane of a vector of doubles.
constexpr int lanes = 8;

/// Constants of the kernel for one smoothing length.
struct Kernel {
  double inverse_h;     ///< [1/m]
  double alpha;         ///< alpha_D [1/m2]
  double f_scale;       ///< 5 alpha_D / h^2 [1/m4]
  double w_at_spacing;  ///< W(dx) [1/m2]
};

/// W/alpha_D at q = r/h.
inline double kernel_shape(double q) {
  const double t = 1.0 - 0.5 * q;
  return q < 2.0 ? t * t * t * t * (2.0 * q + 1.0) : 0.0;
}

/// @param smoothing_length h [m]
/// @param spacing dx [m]
inline Kernel make_kernel(double smoothing_length, double spacing) {
  const double h = smoothing_length;
  const double alpha = 7.0 / (4.0 * std::numbers::pi * h * h);
  return {1.0 / h, alpha, 5.0 * alpha / (h * h), alpha * kernel_shape(spacing / h)};
}

/// -(1/2) sum F r^2 dx^2 over the square lattice: what the sums have of the gradient of a linear
/// field there, 0.979 at h = 1.33 dx whatever the spacing.
inline double lattice_moment(const Kernel& kernel, double spacing) {
  const double to_q = spacing * kernel.inverse_h;
  const int rows = static_cast<int>(2.0 / to_q);
  double sum = 0.0;
  for (int i = -rows; i <= rows; ++i) {
    for (int k = -rows; k <= rows; ++k) {
      const double r2 = i * i + k * k;  // [dx2]
      const double t = 1.0 - 0.5 * to_q * std::sqrt(r2);
      if (t > 0.0) sum += 0.5 * kernel.f_scale * t * t * t * r2;
    }
  }
  return sum * spacing * spacing * spacing * spacing;
}

}  // namespace parapet::solver
