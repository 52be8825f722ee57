#include "response_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace parapet::reports {
namespace {

/// Points spread over [0, 60] x [0.08, 0.18], not on a lattice.
std::vector<std::vector<double>> scattered_points(int n) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<std::vector<double>> x;
  for (int k = 0; k < n; ++k) x.push_back({60.0 * share(generator), 0.08 + 0.1 * share(generator)});
  return x;
}

template <typename Function>
std::vector<double> response(const std::vector<std::vector<double>>& x, const Function& f) {
  std::vector<double> y;
  for (const auto& point : x) y.push_back(f(point[0], point[1]));
  return y;
}

TEST(ResponseFit, RecoversALinearResponse) {
  const auto x = scattered_points(12);
  const auto y = response(x, [](double a, double h) { return 0.2 + 0.004 * a - 3.0 * h; });
  const ResponseFit fit = fit_response(x, y);
  EXPECT_EQ(fit.model, ResponseModel::linear);
  EXPECT_NEAR(fit.r2, 1.0, 1e-12);
  EXPECT_NEAR(fit.r2_left_out, 1.0, 1e-12);
  const VariableEffect& angle = fit.effects[0];
  const VariableEffect& height = fit.effects[1];
  // The response is exact, so only rounding is left.
  EXPECT_NEAR(*angle.change, 0.004 * (angle.tried_to - angle.tried_from), 1e-12);
  EXPECT_NEAR(*height.change, -3.0 * (height.tried_to - height.tried_from), 1e-12);
  EXPECT_TRUE(angle.change_clear);
  EXPECT_GT(angle.standardised, 0.0);
  EXPECT_LT(height.standardised, 0.0);
  EXPECT_GT(*angle.correlation, 0.0);
  EXPECT_LT(*height.correlation, 0.0);
}

/// With one variable the standardised effect is Pearson's correlation.
TEST(ResponseFit, StandardisedEffectOfOneVariableIsItsCorrelation) {
  std::vector<std::vector<double>> x;
  std::vector<double> y;
  for (int k = 0; k < 10; ++k) {
    x.push_back({static_cast<double>(k)});
    y.push_back(2.0 * k + (k % 2 == 0 ? 1.0 : -1.0));
  }
  const ResponseFit fit = fit_response(x, y);
  ASSERT_EQ(fit.model, ResponseModel::linear);
  EXPECT_NEAR(fit.effects[0].standardised, *fit.effects[0].correlation, 1e-12);
}

TEST(ResponseFit, RecoversABend) {
  const auto x = scattered_points(20);
  const auto y = response(x, [](double a, double h) { return h - 1e-4 * (a - 30.0) * (a - 30.0); });
  const ResponseFit fit = fit_response(x, y);
  EXPECT_EQ(fit.model, ResponseModel::curved);
  const double half = 0.5 * (fit.effects[0].tried_to - fit.effects[0].tried_from);
  EXPECT_NEAR(fit.effects[0].bend, -1e-4 * half * half, 1e-9);
  EXPECT_TRUE(fit.effects[0].bend_clear);
  EXPECT_NEAR(fit.effects[1].bend, 0.0, 1e-9);
}

TEST(ResponseFit, DoesNotClaimAnEffectOfAnIdleVariable) {
  const auto x = scattered_points(30);
  std::mt19937 generator(11);
  std::normal_distribution<double> noise(0.0, 0.01);
  const auto y = response(x, [&](double a, double) { return 0.004 * a + noise(generator); });
  const ResponseFit fit = fit_response(x, y);
  EXPECT_TRUE(fit.effects[0].change_clear);
  EXPECT_FALSE(fit.effects[1].change_clear);
  // Standard deviation of the noise from 30 points: known to about 13 %, three times that allowed.
  EXPECT_NEAR(fit.scatter, 0.01, 0.004);
}

TEST(ResponseFit, PureNoiseDoesNotPredict) {
  const auto x = scattered_points(30);
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  const ResponseFit fit =
      fit_response(x, response(x, [&](double, double) { return noise(generator); }));
  EXPECT_LT(fit.r2_left_out, 0.3);
}

TEST(ResponseFit, SaysWhenTheDataCannotTell) {
  const auto few = scattered_points(4);
  const ResponseFit fit = fit_response(few, {1.0, 2.0, 3.0, 4.0});
  EXPECT_EQ(fit.model, ResponseModel::none);
  EXPECT_NE(fit.why_none.find("too few"), std::string::npos);
  EXPECT_FALSE(fit.effects[0].change.has_value());

  // Two variables that always move together cannot be told apart.
  std::vector<std::vector<double>> together;
  std::vector<double> y;
  for (int k = 0; k < 12; ++k) {
    together.push_back({1.0 * k, 0.5 * k});
    y.push_back(k * k);
  }
  EXPECT_EQ(fit_response(together, y).model, ResponseModel::none);
}

TEST(ResponseFit, ConstantsAreNotFitted) {
  const auto x = scattered_points(12);
  const ResponseFit flat = fit_response(x, std::vector<double>(12, 0.97));
  EXPECT_EQ(flat.model, ResponseModel::none);
  EXPECT_NE(flat.why_none.find("never changed"), std::string::npos);

  auto held = x;
  for (auto& point : held) point[1] = 0.1;
  const ResponseFit fit = fit_response(held, response(held, [](double a, double) { return a; }));
  EXPECT_EQ(fit.model, ResponseModel::linear);
  EXPECT_TRUE(fit.effects[0].change.has_value());
  EXPECT_FALSE(fit.effects[1].change.has_value());

  EXPECT_EQ(fit_response({}, {}).model, ResponseModel::none);
  EXPECT_EQ(fit_response({{1.0}}, {2.0}).model, ResponseModel::none);
}

}  // namespace
}  // namespace parapet::reports
