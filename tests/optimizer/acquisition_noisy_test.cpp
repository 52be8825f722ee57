/// The front averaged over draws.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "front_checks.hpp"
#include "parapet/acquisition/improvement.hpp"

namespace parapet::acquisition {
namespace {

/// A number of draws of a front with scatter, some designs infeasible in some of them.
struct Sampled {
  std::vector<Eigen::MatrixXd> objectives;
  std::vector<Eigen::VectorXi> feasible;
  Objectives reference, ideal;
  Eigen::MatrixXd means;
  Eigen::VectorXd log_feasible;
};

Sampled sampled(std::uint64_t seed, int n_samples, Eigen::Index n_designs, Eigen::Index m) {
  SeededDraws draws(seed);
  Sampled s{{},
            {},
            Objectives::Constant(m, 1.1),
            Objectives::Constant(m, -0.3),
            Eigen::MatrixXd(n_samples, m),
            Eigen::VectorXd(n_samples)};
  const auto front = random_front(draws, static_cast<std::size_t>(n_designs), m);
  for (int k = 0; k < n_samples; ++k) {
    Eigen::MatrixXd y(n_designs, m);
    Eigen::VectorXi feasible(n_designs);
    for (Eigen::Index i = 0; i < n_designs; ++i) {
      for (Eigen::Index j = 0; j < m; ++j) {
        y(i, j) = front[static_cast<std::size_t>(i)][j] + 0.05 * draws.normal();
      }
      feasible[i] = draws.uniform() < 0.7 ? 1 : 0;
    }
    s.objectives.push_back(y);
    s.feasible.push_back(feasible);
    for (Eigen::Index j = 0; j < m; ++j) s.means(k, j) = 0.4 + 0.2 * draws.normal();
    s.log_feasible[k] = std::log(draws.uniform());
  }
  return s;
}

NoisyFront front_of(const Sampled& s) {
  return {s.objectives, s.feasible, s.reference, s.ideal};
}

/// The definition: per draw the front of the feasible designs, its boxes, their closed form.
double by_hand(const Sampled& s, const Eigen::MatrixXd& means, const Objectives& sd) {
  Eigen::VectorXd terms(means.rows());
  for (Eigen::Index k = 0; k < means.rows(); ++k) {
    const auto draw = static_cast<std::size_t>(k);
    std::vector<Objectives> points;
    for (Eigen::Index i = 0; i < s.feasible[draw].size(); ++i) {
      if (s.feasible[draw][i] == 1) points.emplace_back(s.objectives[draw].row(i).transpose());
    }
    const auto boxes = undominated_boxes(points, s.reference, s.ideal);
    terms[k] = log_ehvi(boxes, means.row(k).transpose(), sd) + s.log_feasible[k];
  }
  return log_mean(terms);
}

/// Rounding: of logarithms as great as the result, and of factors 1e-3 as wide as they are high.
double tolerance(double expected) {
  return 1e-12 + 1e-15 * std::abs(expected);
}

TEST(NoisyFront, IdenticalDrawsAreOneFront) {
  const std::vector<Objectives> points = {vec({0.1, 0.8}), vec({0.4, 0.5}), vec({0.7, 0.15})};
  Eigen::MatrixXd y(3, 2);
  for (int i = 0; i < 3; ++i) y.row(i) = points[static_cast<std::size_t>(i)];
  const Objectives reference = vec({1, 1}), ideal = vec({-infinity, 0});
  const NoisyFront front(std::vector<Eigen::MatrixXd>(8, y),
                         std::vector<Eigen::VectorXi>(8, Eigen::VectorXi::Ones(3)), reference,
                         ideal);
  EXPECT_EQ(front.n_samples(), 8);
  EXPECT_TRUE(front.any_feasible());
  const auto boxes = undominated_boxes(points, reference, ideal);
  for (const Objectives& mean : {vec({0.3, 0.4}), vec({0.9, 0.9}), vec({3, 5}), vec({1e4, 2})}) {
    for (const Objectives& sd : {vec({0.1, 0.2}), vec({0, 0.3}), vec({2, 1e-3})}) {
      const double expected = log_ehvi(boxes, mean, sd) - 1.5;
      const double value = front.log_improvement(mean.transpose().replicate(8, 1), sd,
                                                 Eigen::VectorXd::Constant(8, -1.5));
      if (expected == -infinity) {
        EXPECT_EQ(value, -infinity);
      } else {
        EXPECT_NEAR(value, expected, tolerance(expected)) << mean << " " << sd;
      }
    }
  }
}

TEST(NoisyFront, AveragesOverTheDraws) {
  for (Eigen::Index m = 1; m <= 4; ++m) {
    const Sampled s = sampled(11, 16, 9, m);
    const NoisyFront front = front_of(s);
    // Shifts of 0 to 1e5 standard deviations: plain arithmetic, log space, and some of both.
    for (const double shift : {0.0, 0.5, 2.0, 3.0, 3.5, 4.0, 6.0, 1e4}) {
      for (const double sd : {0.1, 0.12, 1.0}) {
        const Eigen::MatrixXd means = s.means.array() + shift;
        const Objectives sds = Objectives::Constant(m, sd);
        const double expected = by_hand(s, means, sds);
        EXPECT_NEAR(front.log_improvement(means, sds, s.log_feasible), expected,
                    tolerance(expected))
            << m << " objectives, " << shift << " " << sd;
      }
    }
  }
}

TEST(NoisyFront, OneGoodDrawAmongHopelessOnes) {
  const Sampled s = sampled(12, 6, 5, 2);
  Eigen::MatrixXd means = s.means.array() + 100.0;
  means.row(4) = s.means.row(4);
  const Objectives sd = vec({0.1, 0.1});
  const double expected = by_hand(s, means, sd);
  EXPECT_GT(expected, -20.0);
  EXPECT_NEAR(front_of(s).log_improvement(means, sd, s.log_feasible), expected, 1e-12);
}

TEST(NoisyFront, ExactObjectivesAndImpossibleDraws) {
  Sampled s = sampled(13, 8, 6, 3);
  s.log_feasible[2] = s.log_feasible[5] = -infinity;
  const NoisyFront front = front_of(s);
  for (const Objectives& sd : {vec({0, 0.1, 0.2}), vec({0.1, 0, 0}), vec({0, 0, 0})}) {
    const double expected = by_hand(s, s.means, sd);
    ASSERT_GT(expected, -infinity);
    EXPECT_NEAR(front.log_improvement(s.means, sd, s.log_feasible), expected, 1e-12);
  }
  EXPECT_EQ(front.log_improvement(s.means, vec({1, 1, 1}), Eigen::VectorXd::Constant(8, -infinity)),
            -infinity);
}

TEST(NoisyFront, InfeasibleDesignsDoNotCount) {
  // One design that would leave nothing to gain, infeasible in both draws.
  const Eigen::MatrixXd best = Eigen::MatrixXd::Zero(1, 2);
  const std::vector<Eigen::MatrixXd> objectives(2, best);
  const std::vector<Eigen::VectorXi> none(2, Eigen::VectorXi::Zero(1));
  const Objectives reference = vec({1, 2}), ideal = vec({0, 0}), sd = vec({0, 0});
  const NoisyFront front(objectives, none, reference, ideal);
  EXPECT_FALSE(front.any_feasible());
  const Eigen::MatrixXd means = vec({0.5, 1}).transpose().replicate(2, 1);
  EXPECT_NEAR(front.log_improvement(means, sd, Eigen::VectorXd::Zero(2)), std::log(0.5), 1e-15);

  // Feasible in one of them: half is left.
  const NoisyFront half(objectives, {Eigen::VectorXi::Ones(1), Eigen::VectorXi::Zero(1)}, reference,
                        ideal);
  EXPECT_TRUE(half.any_feasible());
  EXPECT_NEAR(half.log_improvement(means, sd, Eigen::VectorXd::Zero(2)), std::log(0.25), 1e-15);

  // No design at all.
  const NoisyFront empty(std::vector<Eigen::MatrixXd>(1, Eigen::MatrixXd(0, 2)),
                         std::vector<Eigen::VectorXi>(1), reference, ideal);
  EXPECT_FALSE(empty.any_feasible());
  EXPECT_NEAR(empty.log_improvement(means.topRows(1), sd, Eigen::VectorXd::Zero(1)), std::log(0.5),
              1e-15);
}

TEST(NoisyFront, SameBitsAgainAndFromSeveralThreads) {
  const Sampled s = sampled(14, 64, 30, 2);
  const NoisyFront front = front_of(s), again = front_of(s);
  const Objectives sd = vec({0.2, 0.1});
  const auto value = [&](const NoisyFront& f, int k) {
    return f.log_improvement(s.means.array() + 0.02 * k, sd, s.log_feasible);
  };
  std::array<std::array<double, 200>, 4> values{};
  std::vector<std::thread> threads;
  for (auto& row : values) {
    threads.emplace_back([&] {
      for (int k = 0; k < 200; ++k) row[static_cast<std::size_t>(k)] = value(front, k);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int k = 0; k < 200; ++k) {
    const double expected = value(again, k);
    for (const auto& row : values) EXPECT_EQ(row[static_cast<std::size_t>(k)], expected) << k;
  }
}

TEST(NoisyFront, RefusesWhatDoesNotFit) {
  const Sampled s = sampled(15, 3, 4, 2);
  const NoisyFront front = front_of(s);
  const Objectives sd = vec({1, 1});
  EXPECT_THROW(NoisyFront({}, {}, s.reference, s.ideal), std::invalid_argument);
  EXPECT_THROW(NoisyFront(s.objectives, {s.feasible[0]}, s.reference, s.ideal),
               std::invalid_argument);
  EXPECT_THROW(NoisyFront(s.objectives, s.feasible, vec({1, 1, 1}), vec({0, 0, 0})),
               std::invalid_argument);
  EXPECT_THROW(front.log_improvement(s.means.topRows(2), sd, s.log_feasible),
               std::invalid_argument);
  EXPECT_THROW(front.log_improvement(s.means, vec({1}), s.log_feasible), std::invalid_argument);
  EXPECT_THROW(front.log_improvement(s.means, vec({1, -1}), s.log_feasible), std::invalid_argument);
  EXPECT_THROW(front.log_improvement(s.means * std::nan(""), sd, s.log_feasible),
               std::invalid_argument);
}

}  // namespace
}  // namespace parapet::acquisition
