/// The Bayesian search as a whole, on functions whose best values are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bayesian_problems.hpp"
#include "parapet/math/pareto.hpp"

namespace parapet::bayesian {
namespace {

TEST(BayesianSearch, FindsTheMinimumOfBranin) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Search search(branin_problem(), budget(30, seed));
    run(search, branin_answer);
    EXPECT_EQ(search.evaluations(), 30);
    EXPECT_EQ(search.stop_reason(), StopReason::budget);
    // 30 random designs come to about 2; the range of the function is 300. Measured over six seeds:
    // 0.0001 to 0.08 above the minimum.
    EXPECT_LT(best_value(search, 0), 0.397887 + 0.1) << "seed " << seed;
  }
}

TEST(BayesianSearch, MaximizesJustAsWell) {
  Problem problem = branin_problem();
  problem.objectives[0].maximize = true;
  Search search(problem, budget(30));
  run(search, [](const Suggestion& s) {
    return Observation{.ok = true, .values = {-branin(s.x[0], s.x[1])}, .seconds = 1.0};
  });
  double best = -1e300;
  for (const Assessed& a : search.assessed()) best = std::max(best, *a.values[0]);
  EXPECT_GT(best, -0.397887 - 0.1);  // see above
}

TEST(BayesianSearch, IsTheSameToTheBitEachTime) {
  std::vector<std::vector<Suggestion>> runs;
  for (int k = 0; k < 2; ++k) {
    Search search(bnh_problem(), budget(18));
    runs.push_back(run(search, bnh_answer));
  }
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t k = 0; k < runs[0].size(); ++k) {
    EXPECT_TRUE(same_design(runs[0][k].x, runs[1][k].x)) << "evaluation " << k;
    EXPECT_EQ(runs[0][k].log_gain, runs[1][k].log_gain);
  }
}

TEST(BayesianSearch, DependsOnTheSeed) {
  Search a(branin_problem(), budget(8, 1)), b(branin_problem(), budget(8, 2));
  EXPECT_FALSE(same_design(a.ask()->x, b.ask()->x));
}

TEST(BayesianSearch, CoversAConstrainedFront) {
  Search search(bnh_problem(), budget(30));
  run(search, bnh_answer);
  std::vector<math::Objectives> truth;
  // The front is x1 = x2 up to 3, then x2 = 3 (Deb 2001); both constraints are slack on it.
  for (int k = 0; k <= 2000; ++k) {
    const double a = 5.0 * k / 2000.0, b = std::min(a, 3.0);
    truth.emplace_back(
        Eigen::Vector2d(4.0 * a * a + 4.0 * b * b, (a - 5.0) * (a - 5.0) + (b - 5.0) * (b - 5.0)));
  }
  const double whole = math::hypervolume(truth, Eigen::Vector2d(140.0, 50.0));
  // 22 points placed evenly on this front reach 0.97 of it
  EXPECT_GT(search.history().back().hypervolume, 0.95 * whole);
  EXPECT_LE(search.history().back().hypervolume, whole);
}

TEST(BayesianSearch, NeverPutsAnInfeasibleDesignIntoTheFront) {
  Search search(bnh_problem(), budget(25, 3));
  run(search, bnh_answer);
  const auto assessed = search.assessed();
  const auto front = search.pareto();
  EXPECT_FALSE(front.empty());
  for (const std::size_t k : front) {
    const Observation truth = bnh_answer({.x = assessed[k].x});
    EXPECT_LE(*truth.values[2], 25.0);
    EXPECT_GE(*truth.values[3], 7.7);
    EXPECT_TRUE(assessed[k].feasible);
    for (const std::size_t other : front) {
      const Eigen::Vector2d a(*assessed[k].values[0], *assessed[k].values[1]);
      const Eigen::Vector2d b(*assessed[other].values[0], *assessed[other].values[1]);
      EXPECT_FALSE(math::dominates(a, b));
    }
  }
}

TEST(BayesianSearch, TriesOtherDesignsWhileSomeArePending) {
  Search search(branin_problem(), budget(40));
  for (int k = 0; k < 12; ++k) {
    const auto s = search.ask();
    search.tell(s->id, branin_answer(*s));
  }
  std::vector<Suggestion> pending;
  for (int k = 0; k < 4; ++k) pending.push_back(*search.ask());
  for (std::size_t a = 0; a < pending.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double da = std::abs(pending[a].x[0] - pending[b].x[0]) / 15.0;
      const double db = std::abs(pending[a].x[1] - pending[b].x[1]) / 15.0;
      EXPECT_GT(std::max(da, db), 1e-3);
    }
  }
  for (const Suggestion& s : pending) search.tell(s.id, branin_answer(s));
  run(search, branin_answer);
  EXPECT_LT(best_value(search, 0), 0.397887 + 0.05);
}

TEST(BayesianSearch, LearnsWhereEvaluationsFail) {
  // A corner of 30 % of the square fails, next to the minimum at (9.42, 2.47).
  const auto fails = [](const Point& x) { return x[0] > 3.0 && x[1] > 5.0; };
  int failed = 0, searched = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Search search(branin_problem(), budget(40, seed));
    const auto asked = run(search, [&](const Suggestion& s) {
      return fails(s.x) ? Observation{.ok = false, .seconds = 1.0} : branin_answer(s);
    });
    for (const Suggestion& s : asked) {
      if (s.stage != "search") continue;
      ++searched;
      failed += fails(s.x) ? 1 : 0;
    }
    EXPECT_LT(best_value(search, 0), 0.397887 + 0.1) << "seed " << seed;
    for (const Assessed& a : search.assessed()) {
      EXPECT_TRUE(a.ok || !a.feasible);
    }
  }
  // Blind search fails in 31 % of its evaluations, and one that ignores failures ends in the corner
  // (50 %, measured with a model that averaged over the latent function). Measured: 21 % with
  // these seeds, 4 to 11 of 34 with one.
  EXPECT_LT(failed, 0.26 * searched);
}

TEST(BayesianSearch, GoesOnWhenEverythingFailsAtFirst) {
  int count = 0;
  Search search(branin_problem(), budget(20));
  run(search, [&](const Suggestion& s) {
    return ++count <= 8 ? Observation{.ok = false, .seconds = 1.0} : branin_answer(s);
  });
  EXPECT_EQ(search.evaluations(), 20);
  EXPECT_EQ(search.pareto().size(), 1U);
}

TEST(BayesianSearch, PicksTheRightOptionAndItsOwnVariables) {
  // Without a deflector: 1 at best. With it, the angle has its best value, 0, at 40.
  Problem problem;
  problem.space = Space({{.name = "deflector", .kind = VariableKind::choice, .upper = 1},
                         continuous("height", 0.0, 1.0),
                         {.name = "angle",
                          .lower = 0.0,
                          .upper = 75.0,
                          .active_when = Condition{.choice = 0, .options = {1}}}});
  problem.metrics = {{.name = "loss"}};
  problem.objectives = {{.metric = 0}};
  Search search(problem, budget(30));
  run(search, [](const Suggestion& s) {
    const double height = std::pow(s.x[1] - 0.3, 2);
    const double rest = s.x[0] == 0.0 ? 1.0 : std::pow((s.x[2] - 40.0) / 75.0, 2);
    return Observation{.ok = true, .values = {height + rest}, .seconds = 1.0};
  });
  EXPECT_LT(best_value(search, 0), 1e-3);
}

TEST(BayesianSearch, KnowsAnExactObjectiveWithoutEvaluations) {
  // Two objectives: an unknown one, and the height itself.
  Problem problem;
  problem.space = Space({continuous("height", 0.0, 1.0), continuous("angle", 0.0, 1.0)});
  problem.metrics = {{.name = "loss"}, {.name = "height"}};
  problem.metrics[1].exact = [](const Point& x) { return x[0]; };
  problem.objectives = {{.metric = 0, .reference = 1.2}, {.metric = 1, .reference = 1.2}};
  Search search(problem, budget(24));
  run(search, [](const Suggestion& s) {
    const double loss = (1.0 - s.x[0]) * (1.0 - s.x[0]) + std::pow(s.x[1] - 0.5, 2);
    return Observation{.ok = true, .values = {loss, std::nullopt}, .seconds = 1.0};
  });
  EXPECT_EQ(search.surrogate(1), nullptr);
  std::vector<math::Objectives> truth;
  for (int k = 0; k <= 1000; ++k) {
    const double h = k / 1000.0;
    truth.emplace_back(Eigen::Vector2d((1.0 - h) * (1.0 - h), h));
  }
  const double whole = math::hypervolume(truth, Eigen::Vector2d(1.2, 1.2));
  EXPECT_GT(search.history().back().hypervolume, 0.93 * whole);
}

TEST(BayesianSearch, UsesCheapLevelsAndEndsAtTheFinest) {
  Problem problem = branin_problem();
  problem.levels = {{.seconds = 10.0}, {.seconds = 1.0}};
  Search search(problem, budget(40));
  const auto asked = run(search, [](const Suggestion& s) {
    // the coarse level is off by a smooth error a tenth of the function's size
    const double error = s.level == 0 ? 0.0 : 3.0 + 0.8 * s.x[0];
    return Observation{.ok = true,
                       .values = {branin(s.x[0], s.x[1]) + error},
                       .seconds = s.level == 0 ? 10.0 : 1.0};
  });
  const auto coarse =
      std::count_if(asked.begin(), asked.end(), [](auto& s) { return s.level == 1; });
  EXPECT_GT(coarse, 20);
  EXPECT_EQ(asked.back().level, 0);
  double best = 1e300;
  const auto assessed = search.assessed();
  for (const std::size_t k : search.pareto()) {
    EXPECT_EQ(assessed[k].level, 0);
    best = std::min(best, *assessed[k].values[0]);
  }
  EXPECT_LT(best, 0.397887 + 0.1);
}

TEST(BayesianSearch, KeepsToConstraintsThatNeedNoEvaluation) {
  Problem problem = branin_problem();
  problem.cheap_constraints = [](const Point& x) {
    return std::vector<double>{x[0] + x[1] - 3.0};  // a triangle of 6 % of the square
  };
  Search search(problem, budget(25));
  for (const Suggestion& s : run(search, branin_answer)) EXPECT_LE(s.x[0] + s.x[1], 3.0 + 1e-9);
  // least value in the triangle, from a grid of 3000 x 3000 points: 5.9 at its edge
  double least = 1e300;
  for (int i = 0; i <= 1000; ++i) {
    for (int k = 0; k <= 1000; ++k) {
      const double a = -5.0 + 15.0 * i / 1000.0, b = 15.0 * k / 1000.0;
      if (a + b <= 3.0) least = std::min(least, branin(a, b));
    }
  }
  EXPECT_LT(best_value(search, 0), least + 0.5);
}

TEST(BayesianSearch, IntervalsHoldWhatIsTrueUnderNoise) {
  // Noise of 2 on a range of some 100: the 95 % intervals of the noise-free value hold it.
  Search search(branin_problem(), budget(40));
  std::uint64_t state = 12345;
  const auto noise = [&state] {  // sum of 12 uniform numbers: s.d. 1
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      sum += static_cast<double>(state >> 11U) * 0x1p-53;
    }
    return sum;
  };
  run(search, [&](const Suggestion& s) {
    return Observation{
        .ok = true, .values = {branin(s.x[0], s.x[1]) + 2.0 * noise()}, .seconds = 1.0};
  });
  int held = 0;
  const auto assessed = search.assessed();
  for (const Assessed& a : assessed) {
    const double truth = branin(a.x[0], a.x[1]);
    held += a.lower[0] <= truth && truth <= a.upper[0] ? 1 : 0;
  }
  // 40 dependent designs, most of them around the minima: 30 is what a coverage of 75 % gives
  EXPECT_GE(held, 30);
}

}  // namespace
}  // namespace parapet::bayesian
