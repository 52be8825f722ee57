// The Wendland kernel: normalised, smooth at its edge, and F really its derivative over r.
#include "parapet/flow/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace parapet::solver {
namespace {

double w(double r, double h) {
  return make_kernel(h, h).alpha * kernel_shape(r / h);
}

TEST(Kernel, IntegratesToOneOverThePlane) {
  const double h = 0.0133;
  const int n = 4000;
  double integral = 0.0;
  for (int k = 0; k < n; ++k) {
    const double r = (k + 0.5) * 2.0 * h / n;
    integral += w(r, h) * 2.0 * std::numbers::pi * r * (2.0 * h / n);
  }
  EXPECT_NEAR(integral, 1.0, 1e-6);  // midpoint rule: error (1/n)^2
}

TEST(Kernel, VanishesAtTheEdgeOfItsSupport) {
  EXPECT_EQ(kernel_shape(2.0), 0.0);
  EXPECT_EQ(kernel_shape(7.0), 0.0);
  EXPECT_LT(kernel_shape(1.999), 1e-12);
}

TEST(Kernel, FIsTheDerivativeOverR) {
  const double h = 0.01;
  const Kernel k = make_kernel(h, h);
  for (const double r : {0.001, 0.006, 0.013, 0.019}) {
    const double step = 1e-7;
    const double slope = (w(r + step, h) - w(r - step, h)) / (2.0 * step);
    const double t = 1.0 - 0.5 * r / h;
    EXPECT_NEAR(-k.f_scale * t * t * t, slope / r, 1e-6 * std::abs(slope / r) + 1e-3) << "r " << r;
  }
}

}  // namespace
}  // namespace parapet::solver
