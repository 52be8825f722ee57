// The table: the surface through its simulations, its noise, and what survives the file.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "hash_noise.hpp"
#include "oracle.hpp"
#include "scrambled_sobol.hpp"

namespace parapet::bench::search {
namespace {

Eigen::MatrixXd sobol_designs(int n, int d, std::uint64_t seed) {
  ScrambledSobol points(d, seed);
  Eigen::MatrixXd designs(n, d);
  for (int i = 0; i < n; ++i) {
    const std::vector<double> u = points.next();
    for (int j = 0; j < d; ++j) designs(i, j) = u[static_cast<std::size_t>(j)];
  }
  return designs;
}

Eigen::VectorXd waves(const Eigen::MatrixXd& designs) {
  return (3.0 * designs.col(0).array()).sin() * (2.0 * designs.col(1).array()).cos();
}

// A linear function is its own tail: exact, however it is stretched.
TEST(RadialFit, ReproducesLinearFunctions) {
  const Eigen::MatrixXd designs = sobol_designs(40, 3, 1);
  const Eigen::VectorXd values =
      (2.0 + 3.0 * designs.col(0).array() - designs.col(2).array()).matrix();
  const RadialFit fit = fit_radial(designs, values);
  EXPECT_LT(fit.leave_one_out_rms, 1e-9);  // rounding of a 40 x 40 eigenproblem
  const Eigen::Vector3d u(0.31, 0.77, 0.05);
  EXPECT_NEAR(fit.surface.at(designs, u), 2.0 + 3.0 * u[0] - u[2], 1e-9);
}

// The closed form against what it stands for: fitting again without each design.
TEST(RadialFit, LeaveOneOutIsThatOfRefits) {
  const int n = 25;
  const Eigen::MatrixXd designs = sobol_designs(n, 2, 2);
  const Eigen::VectorXd values = waves(designs);
  const Eigen::Vector2d scale(2.0, 0.5);
  const double ridge = 0.01;
  const RadialFit fit = fit_radial(designs, values, scale, ridge);
  for (int left_out = 0; left_out < n; ++left_out) {
    Eigen::MatrixXd others(n - 1, 2);
    Eigen::VectorXd theirs(n - 1);
    for (int i = 0, k = 0; i < n; ++i) {
      if (i == left_out) continue;
      others.row(k) = designs.row(i);
      theirs[k++] = values[i];
    }
    const RadialFit refit = fit_radial(others, theirs, scale, ridge);
    const double error =
        values[left_out] - refit.surface.at(others, designs.row(left_out).transpose());
    EXPECT_NEAR(fit.leave_one_out[left_out], error, 1e-9) << "design " << left_out;
  }
}

// The noise that is put in is found: 400 values less the some fifty degrees of freedom of the
// surface leave a standard error of 1 / sqrt(2 * 350) = 3.8 %; limit at three of them.
TEST(RadialFit, FindsTheNoise) {
  const int n = 400;
  const double noise = 0.05;
  const Eigen::MatrixXd designs = sobol_designs(n, 2, 3);
  Eigen::VectorXd values = waves(designs);
  for (int i = 0; i < n; ++i) values[i] += noise * hash_normal({designs(i, 0), designs(i, 1)}, "n");
  const RadialFit fit = fit_radial(designs, values);
  EXPECT_NEAR(fit.noise, noise, 0.12 * noise);
  EXPECT_GT(fit.leave_one_out_rms, fit.noise);  // it has the surface's own error as well
}

TEST(RadialFit, RefusesTooFewDesigns) {
  const Eigen::MatrixXd designs = sobol_designs(4, 2, 1);
  EXPECT_THROW(fit_radial(designs, Eigen::VectorXd::Zero(4)), std::invalid_argument);
}

TEST(HashNormal, RepeatsAndIsStandard) {
  EXPECT_EQ(hash_normal({0.1, 0.2}, "a"), hash_normal({0.1, 0.2}, "a"));
  EXPECT_NE(hash_normal({0.1, 0.2}, "a"), hash_normal({0.1, 0.2}, "b"));
  EXPECT_NE(hash_normal({0.1, 0.2}, "a"), hash_normal({0.1, 0.2000000001}, "a"));
  double sum = 0.0, squares = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double z = hash_normal({i / 20000.0}, "stream");
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));            // four standard errors
  EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));  // likewise
}

// A digital shift keeps the stratification: 64 consecutive points that start at a multiple of 64
// would fill every 1/64 once; the sequence leaves its first point out, so one place stays empty.
TEST(ScrambledSobol, FillsEveryIntervalForEverySeed) {
  for (const std::uint64_t seed : {1ULL, 2ULL, 99ULL}) {
    ScrambledSobol points(5, seed);
    std::vector<std::set<int>> places(5);
    for (int k = 0; k < 63; ++k) {
      const std::vector<double> u = points.next();
      for (std::size_t j = 0; j < u.size(); ++j) {
        ASSERT_GT(u[j], 0.0);
        ASSERT_LT(u[j], 1.0);
        places[j].insert(static_cast<int>(64.0 * u[j]));
      }
    }
    for (const std::set<int>& place : places) EXPECT_EQ(place.size(), 63u);
  }
  EXPECT_NE(ScrambledSobol(2, 1).next(), ScrambledSobol(2, 2).next());
}

// A share with a value everywhere, a length that exists for u_0 > 1/2 only, and a corner that
// fails.
std::vector<TableRow> rows(int n) {
  ScrambledSobol points(2, 4);
  std::vector<TableRow> all;
  for (int i = 0; i < n; ++i) {
    TableRow row;
    row.u = points.next();
    row.ok = row.u[0] + row.u[1] < 1.8;
    row.cpu_time = 1.0 + i;
    if (row.ok) row.metrics["retention_efficiency"] = std::min(1.0, 0.6 + 0.8 * row.u[1]);
    if (row.ok && row.u[0] > 0.5) row.metrics["launch_length_m"] = row.u[0] * row.u[0];
    all.push_back(row);
  }
  return all;
}

Oracle fitted() {
  return fit_oracle("test", {"a_m", "b_m"}, {0.0, 10.0}, {2.0, 20.0}, rows(200),
                    {"retention_efficiency", "launch_length_m"});
}

TEST(Oracle, KnowsAbsenceFailureAndBounds) {
  const Oracle oracle = fitted();
  EXPECT_FALSE(oracle.smooth("launch_length_m", {0.4, 15.0}).has_value());
  ASSERT_TRUE(oracle.smooth("launch_length_m", {1.6, 14.0}).has_value());
  // 0.8^2; the surface through a hundred points of a parabola is within a thousandth
  EXPECT_NEAR(*oracle.smooth("launch_length_m", {1.6, 14.0}), 0.64, 1e-3);
  EXPECT_FALSE(oracle.succeeds({1.99, 19.9}));
  EXPECT_TRUE(oracle.succeeds({1.0, 15.0}));
  EXPECT_LE(*oracle.noisy("retention_efficiency", {0.5, 19.9}), 1.0);
}

TEST(Oracle, NoiseIsTheMetricsOwnAndRepeats) {
  Oracle oracle = fitted();
  oracle.metrics.at("retention_efficiency").fit.noise = 0.01;
  const std::vector<double> x = {0.7, 13.0};
  const double smooth = *oracle.smooth("retention_efficiency", x);
  const double noisy = *oracle.noisy("retention_efficiency", x);
  EXPECT_NE(noisy, smooth);
  EXPECT_EQ(noisy, *oracle.noisy("retention_efficiency", x));
  EXPECT_LT(std::abs(noisy - smooth), 0.06);  // six standard deviations
}

// Nine digits of weights whose sum cancels to a part in a thousand leave six of a value; noise
// leaves three.
TEST(Oracle, SurvivesTheFile) {
  const Oracle oracle = fitted();
  const Oracle copy = oracle_from_json(nlohmann::ordered_json::parse(to_json(oracle).dump()));
  EXPECT_EQ(copy.variables, oracle.variables);
  EXPECT_EQ(copy.failed, oracle.failed);
  EXPECT_EQ(copy.median_cpu_time, oracle.median_cpu_time);
  for (const std::vector<double>& x : {std::vector{1.3, 12.0}, std::vector{1.1, 18.0}}) {
    for (const char* metric : {"retention_efficiency", "launch_length_m"}) {
      EXPECT_NEAR(*copy.smooth(metric, x), *oracle.smooth(metric, x), 1e-5) << metric;
    }
  }
  EXPECT_THROW(oracle_from_json({{"format", "other"}}), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::bench::search
