/// The zoo's problems are what they claim to be.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "multi_objective_zoo.hpp"
#include "seeded_draws.hpp"

namespace parapet::zoo {
namespace {

using math::dominates;
using math::non_dominated;

TEST(SingleObjectiveZoo, MinimaArePublishedOnes) {
  const std::vector<std::pair<ZooProblem, double>> published = {
      {branin(), 0.397887}, {hartmann_3(), -3.86278}, {hartmann_6(), -3.32237}};
  for (const auto& [problem, minimum] : published) {
    const auto designs = problem.pareto_set(10);
    EXPECT_EQ(designs.size(), problem.name == "Branin" ? 3U : 1U);
    for (const Vector& x : designs) {
      // Half a unit of the last place published.
      EXPECT_NEAR(problem.objectives(x)[0], minimum, 1e-5) << problem.name;
      // A minimum: no neighbour is better by more than the places given for x allow.
      for (Eigen::Index j = 0; j < x.size(); ++j) {
        for (const double step : {-1e-2, 1e-2}) {
          Vector y = x;
          y[j] += step;
          EXPECT_GT(problem.objectives(y)[0], problem.objectives(x)[0]) << problem.name;
        }
      }
    }
  }
}

TEST(SingleObjectiveZoo, NothingIsBelowTheMinimum) {
  for (const ZooProblem& problem : single_objective_zoo()) {
    SeededDraws draws(1);
    const double minimum = problem.front(1)[0][0];
    for (int k = 0; k < 100000; ++k) {
      const Vector x = draws.point(problem.lower, problem.upper);
      // The minimiser is published to six places: its value is good to 1e-6.
      ASSERT_GE(problem.objectives(x)[0], minimum - 1e-6) << problem.name;
    }
  }
}

TEST(MultiObjectiveZoo, FrontIsFeasibleNonDominatedAndBelowTheReference) {
  for (const ZooProblem& problem : multi_objective_zoo()) {
    SCOPED_TRACE(problem.name);
    const auto designs = problem.pareto_set(300);
    EXPECT_LE(designs.size(), 300U);
    EXPECT_GE(designs.size(), 250U);
    for (const Vector& x : designs) {
      EXPECT_TRUE((x.array() >= problem.lower.array()).all());
      EXPECT_TRUE((x.array() <= problem.upper.array()).all());
      // On a constraint's edge, but for rounding of terms up to 225.
      EXPECT_TRUE(problem.feasible(x, 1e-12)) << x.transpose();
      EXPECT_TRUE((problem.objectives(x).array() < problem.reference.array()).all());
    }
    auto front = problem.front(300);
    // Rounding may put one of two points of a straight front 1e-16 below the other: the least step
    // between neighbours is 1e-6.
    for (auto& f : front) f = (f * 1e9).array().round();
    const auto best = non_dominated(front);
    EXPECT_EQ(best.size(), front.size());
  }
}

/// A random design, most of its variables near to the Pareto set's in a part of the draws, so that
/// the front is looked at closely too.
Vector random_design(const ZooProblem& problem, const std::vector<Vector>& designs,
                     SeededDraws& draws, int k) {
  Vector x = draws.point(problem.lower, problem.upper);
  if (k % 2 == 0) return x;
  const auto pick = static_cast<std::size_t>(draws.uniform() * static_cast<double>(designs.size()));
  const double share = std::pow(10.0, -4.0 * draws.uniform());
  return designs[pick] + share * (x - designs[pick]);
}

TEST(MultiObjectiveZoo, RandomDesignsNeverDominateTheFront) {
  for (const ZooProblem& problem : multi_objective_zoo()) {
    SCOPED_TRACE(problem.name);
    SeededDraws draws(2);
    const auto designs = problem.pareto_set(300);
    const auto front = problem.front(300);
    int feasible = 0;
    for (int k = 0; k < 40000; ++k) {
      const Vector x = random_design(problem, designs, draws, k);
      if (!problem.feasible(x)) continue;
      ++feasible;
      // By more than rounding: 1e-9 of the objectives' size.
      const Objectives f = problem.objectives(x) + 1e-9 * problem.reference;
      for (const Objectives& p : front) ASSERT_FALSE(dominates(f, p)) << x.transpose();
    }
    EXPECT_GT(feasible, 2000);
  }
}

TEST(MultiObjectiveZoo, FrontLacksNoPart) {
  // Every feasible design is dominated by a dense front that is moved down by the gap between its
  // points: otherwise the front would end too early or have a hole.
  for (const ZooProblem& problem : multi_objective_zoo()) {
    SCOPED_TRACE(problem.name);
    SeededDraws draws(3);
    const auto designs = problem.pareto_set(1000);
    auto front = problem.front(1000);
    Objectives least = front[0], greatest = front[0];
    for (const Objectives& f : front) {
      least = least.cwiseMin(f);
      greatest = greatest.cwiseMax(f);
    }
    // 1000 points on a line leave gaps of some thousandths of the range, on a surface of one
    // thirtieth.
    const double gap = front[0].size() == 2 ? 0.006 : 0.05;
    for (Objectives& f : front) f -= gap * (greatest - least);
    for (int k = 0; k < 10000; ++k) {
      const Vector x = random_design(problem, designs, draws, k);
      if (!problem.feasible(x)) continue;
      const Objectives f = problem.objectives(x);
      bool covered = false;
      for (const Objectives& p : front) covered = covered || (p.array() <= f.array()).all();
      ASSERT_TRUE(covered) << x.transpose() << " gives " << f.transpose();
    }
  }
}

TEST(MultiObjectiveZoo, KnownShapesOfFronts) {
  for (const Eigen::Index m : {2, 3}) {
    for (const Objectives& f : c1_dtlz1(m).front(100)) EXPECT_NEAR(f.sum(), 0.5, 1e-14);
    for (const Objectives& f : c2_dtlz2(m).front(100)) EXPECT_NEAR(f.norm(), 1.0, 1e-14);
  }
  for (const Objectives& f : zdt(1).front(50)) EXPECT_NEAR(f[1], 1 - std::sqrt(f[0]), 1e-14);
  for (const Objectives& f : zdt(2).front(50)) EXPECT_NEAR(f[1], 1 - f[0] * f[0], 1e-14);
  // BNH from (0, 50) to (136, 4), published.
  const auto ends = bnh().front(100);
  EXPECT_EQ(ends.front(), vec({0, 50}));
  EXPECT_EQ(ends.back(), vec({136, 4}));
}

TEST(MultiObjectiveZoo, Zdt3HasItsFiveParts) {
  // Ends of the parts in f1, as published with the problem.
  const std::vector<std::pair<double, double>> published = {{0.0, 0.0830015349},
                                                            {0.1822287280, 0.2577623634},
                                                            {0.4093136748, 0.4538821041},
                                                            {0.6183967944, 0.6525117038},
                                                            {0.8233317983, 0.8518328654}};
  std::vector<std::pair<double, double>> parts;
  for (const Objectives& f : zdt(3).front(100000)) {
    if (parts.empty() || f[0] - parts.back().second > 0.01) parts.emplace_back(f[0], f[0]);
    parts.back().second = f[0];
  }
  ASSERT_EQ(parts.size(), published.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_NEAR(parts[k].first, published[k].first, 2e-5);  // steps of 1e-5
    EXPECT_NEAR(parts[k].second, published[k].second, 2e-5);
  }
}

TEST(MultiObjectiveZoo, KnownHypervolumes) {
  // Integrals of the fronts; 2000 steps leave out half a step's triangle each: of the order of
  // (range of f1) (range of f2) / 2 / 2000 = 2.5e-4, doubled for steps that are uneven.
  EXPECT_NEAR(zdt(1).front_hypervolume(), 1.21 - 1.0 / 3.0, 5e-4);
  EXPECT_NEAR(zdt(2).front_hypervolume(), 1.21 - 2.0 / 3.0, 5e-4);
  EXPECT_NEAR(c1_dtlz1(2).front_hypervolume(), 0.36 - 0.125, 1e-4);
  // Three objectives, 0.6^3 less the simplex of side 1/2; 2000 points leave steps of 1/62.
  EXPECT_NEAR(c1_dtlz1(3).front_hypervolume(), 0.216 - 0.125 / 6.0, 2e-3);
}

TEST(MultiObjectiveZoo, HypervolumeOfTheBrokenCircle) {
  // C2-DTLZ2 with two objectives: the quarter circle lacks two arcs, between the angles where the
  // corners' balls and the middle's end (chords of 0.2 and 0.2 sqrt(2)). Below such a gap lies what
  // is between the arc and the lines through its ends.
  const double first = 2.0 * std::asin(0.1);
  const double second = pi / 4 - 2.0 * std::asin(0.1 * std::sqrt(2.0));
  const double below_arc =
      (second - first) / 2 - (std::sin(2.0 * second) - std::sin(2.0 * first)) / 4;
  const double gap = std::sin(second) * (std::cos(first) - std::cos(second)) - below_arc;
  const double exact = 1.21 - pi / 4 - 2.0 * gap;
  EXPECT_NEAR(c2_dtlz2(2).front_hypervolume(), exact, 5e-4);
  // BoTorch states the best that NSGA-II found: a little less than what there is.
  EXPECT_GT(exact, 0.3996406);
  EXPECT_LT(exact, 0.3996406 + 1e-3);
}

TEST(MultiObjectiveZoo, NamesAreDistinct) {
  std::set<std::string> names;
  for (const ZooProblem& problem : multi_objective_zoo()) names.insert(problem.name);
  EXPECT_EQ(names.size(), multi_objective_zoo().size());
}

}  // namespace
}  // namespace parapet::zoo
