/// The parts that the surrogates stand on: points, minimiser, transforms.
#include <gtest/gtest.h>

#include <cmath>

#include "marginal_likelihood.hpp"
#include "parapet/surrogate/output_transform.hpp"
#include "quasi_newton.hpp"
#include "surrogate_cases.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {
namespace {

TEST(UnitPoints, ShiftedSobolPointsStayStratifiedAndRepeat) {
  const Eigen::MatrixXd points = unit_points(64, 23, 7);
  EXPECT_EQ(points, unit_points(64, 23, 7));
  EXPECT_NE(points, unit_points(64, 23, 8));
  for (Eigen::Index d = 0; d < 21; ++d) {
    Eigen::VectorXi count = Eigen::VectorXi::Zero(64);
    for (Eigen::Index k = 0; k < 64; ++k) ++count(static_cast<Eigen::Index>(points(k, d) * 64.0));
    EXPECT_EQ(count, Eigen::VectorXi::Ones(64)) << "coordinate " << d;
  }
  EXPECT_GT(points.minCoeff(), 0.0);
  EXPECT_LT(points.maxCoeff(), 1.0);
}

TEST(QuasiNewton, FindsTheMinimumOfRosenbrock) {
  const SmoothFunction rosenbrock = [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double a = 1.0 - x(0), b = x(1) - x(0) * x(0);
    gradient.resize(2);
    gradient << -2.0 * a - 400.0 * x(0) * b, 200.0 * b;
    return a * a + 100.0 * b * b;
  };
  const Bounds bounds{Eigen::Vector2d(-3.0, -3.0), Eigen::Vector2d(3.0, 3.0)};
  Descent at = begin_descent(rosenbrock, Eigen::Vector2d(-1.2, 1.0), bounds);
  continue_descent(rosenbrock, bounds, 500, 1e-14, at);
  // Values within 1e-12 of the minimum lie within about 1e-5 along its flat valley.
  EXPECT_NEAR(at.x(0), 1.0, 1e-5);
  EXPECT_NEAR(at.x(1), 1.0, 2e-5);
  EXPECT_TRUE(at.finished);
}

TEST(QuasiNewton, StopsAtABoundAndAvoidsUndefinedPoints) {
  // (x + 1)^2 + (y - 0.5)^2, not defined for y > 0.9; x is held at its bound 0.
  const SmoothFunction function = [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    gradient.resize(2);
    gradient << 2.0 * (x(0) + 1.0), 2.0 * (x(1) - 0.5);
    if (x(1) > 0.9) return std::nan("");
    return (x(0) + 1.0) * (x(0) + 1.0) + (x(1) - 0.5) * (x(1) - 0.5);
  };
  const Bounds bounds{Eigen::Vector2d(0.0, -5.0), Eigen::Vector2d(2.0, 5.0)};
  Descent at = begin_descent(function, Eigen::Vector2d(1.5, -4.0), bounds);
  continue_descent(function, bounds, 100, 1e-14, at);
  EXPECT_EQ(at.x(0), 0.0);
  EXPECT_NEAR(at.x(1), 0.5, 1e-6);  // a quadratic's gain of 1e-14 is a distance of 1e-7
}

TEST(InverseFromFactor, IsTheInverse) {
  // 130 rows: two full blocks of columns and a part of one.
  const Eigen::MatrixXd x = unit_points(130, 2, 3);
  Eigen::MatrixXd k = matern({0, 1}, Eigen::Vector2d(0.3, 0.5), x, x);
  k.diagonal().array() += 0.01;
  const Eigen::MatrixXd inverse = inverse_from_factor(k.llt().matrixL());
  // Condition about 130 / 0.01, so that 1e-9 is 1e3 times its rounding.
  EXPECT_LT((inverse * k - Eigen::MatrixXd::Identity(130, 130)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(inverse, inverse.transpose());
}

TEST(OutputTransform, ReturnsWhatItWasGivenAndKnowsItsSlope) {
  Eigen::VectorXd values(6);
  values << 0.02, 0.5, 1.0, 7.0, 40.0, 900.0;
  for (const TransformKind kind :
       {TransformKind::identity, TransformKind::log, TransformKind::bilog}) {
    const OutputTransform transform = OutputTransform::standardizing(kind, values);
    EXPECT_EQ(transform.kind, kind);
    double sum = 0.0, squares = 0.0, last = -1e9;
    for (const double y : values) {
      const double z = transform.to_model(y);
      EXPECT_NEAR(transform.from_model(z), y, 1e-12 * 900.0);
      EXPECT_GT(z, last);
      last = z;
      sum += z;
      squares += z * z;
      const double h = 1e-5 * y;
      const double slope = (transform.to_model(y + h) - transform.to_model(y - h)) / (2.0 * h);
      // Error of the central difference: third derivatives times h^2, and rounding over h.
      EXPECT_NEAR(transform.log_slope(y), std::log(slope), 1e-7);
    }
    EXPECT_NEAR(sum / 6.0, 0.0, 1e-13);
    EXPECT_NEAR(squares / 6.0, 1.0, 1e-13);
  }
}

TEST(OutputTransform, BilogIsOddAndLogFallsBack) {
  Eigen::VectorXd values(4);
  values << -3.0, -1.0, 1.0, 3.0;
  const OutputTransform bilog = OutputTransform::standardizing(TransformKind::bilog, values);
  EXPECT_EQ(bilog.to_model(2.0), -bilog.to_model(-2.0));  // shift is 0 by symmetry
  EXPECT_NEAR(bilog.from_model(bilog.to_model(-2.0)), -2.0, 1e-14);
  EXPECT_EQ(OutputTransform::standardizing(TransformKind::log, values).kind,
            TransformKind::identity);
}

TEST(OutputTransform, EqualValuesKeepScaleOne) {
  for (const double value : {0.0, 3.0, 1e300, 0.1}) {
    const OutputTransform transform = OutputTransform::standardizing(
        TransformKind::identity, Eigen::VectorXd::Constant(7, value));
    EXPECT_EQ(transform.scale, 1.0) << value;
    EXPECT_NEAR(transform.to_model(value), 0.0, 1e-15 * value) << value;
  }
}

}  // namespace
}  // namespace parapet::surrogate
