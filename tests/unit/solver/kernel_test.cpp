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

// Against sums by hand: the four neighbours at dx and the four at sqrt(2) dx are all within 2h
// = 1.6 dx.
TEST(Kernel, LatticeMomentIsWhatTheSumHasOfALinearField) {
  const double dx = 0.01, h = 0.8 * dx;
  const Kernel k = make_kernel(h, dx);
  const auto f = [&](double r) { return -k.f_scale * std::pow(1.0 - 0.5 * r / h, 3.0); };
  const double slope = (2.0 * f(dx) + 4.0 * f(std::sqrt(2.0) * dx)) * dx * dx;  // F x^2
  EXPECT_NEAR(lattice_moment(k, dx), -slope * dx * dx, 1e-12);
  EXPECT_NEAR(lattice_moment(make_kernel(1.33 * dx, dx), dx), 0.9793, 5e-5);
  // towards the integral, with the fifth power of dx/h
  EXPECT_NEAR(lattice_moment(make_kernel(8.0 * dx, dx), dx), 1.0, 1e-5);
}

}  // namespace
}  // namespace parapet::solver
