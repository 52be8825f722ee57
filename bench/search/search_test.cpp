// The score and the budget: what makes the comparison fair.
#include <gtest/gtest.h>

#include <limits>

#include "score.hpp"

namespace parapet::bench::search {
namespace {

using SearchRun = Run;  // inside a test, Run is GoogleTest's

constexpr double never = std::numeric_limits<double>::infinity();

// f = (x, 1 - x + y), both minimised: the front is y = 0, a straight line from (0, 1) to (1, 0).
// What is seen is better than the truth by 0.3. Designs with x + y > 1.5 are refused.
BenchProblem line_problem() {
  BenchProblem problem;
  problem.name = "line";
  problem.variables = {"x", "y"};
  problem.lower = {0.0, 0.0};
  problem.upper = {1.0, 1.0};
  problem.metrics = {{"f1", nullptr}, {"f2", nullptr}};
  problem.objectives = {{0, false, std::nullopt}, {1, false, std::nullopt}};
  problem.cheap_constraints = [](const Design& x) {
    return std::vector<double>{x[0] + x[1] - 1.5};
  };
  problem.truth = [](const Design& x) { return Answer{true, {x[0], 1.0 - x[0] + x[1]}}; };
  problem.evaluate = [](const Design& x, int) {
    return Answer{true, {x[0] - 0.3, 0.7 - x[0] + x[1]}};
  };
  problem.level_seconds = {2.0, 0.5};
  return problem;
}

Yardstick unit_yardstick(double volume) {
  Yardstick yardstick;
  yardstick.reference = Eigen::Vector2d(1.0, 1.0);
  yardstick.volume = volume;
  return yardstick;
}

TEST(Judge, LimitsAbsentValuesAndFailures) {
  BenchProblem problem = line_problem();
  problem.limits = {{1, 0.2, 0.5, 0.1}};
  EXPECT_TRUE(judge(problem, {true, {0.1, 0.3}}).feasible);
  const Verdict high = judge(problem, {true, {0.1, 0.7}});
  EXPECT_FALSE(high.feasible);
  EXPECT_NEAR(high.total_violation(), 2.0, 1e-12);
  EXPECT_FALSE(judge(problem, {false, {}}).ok);
  // an objective without a value fails, unless something stands in for it
  EXPECT_FALSE(judge(problem, {true, {std::nullopt, 0.3}}).ok);
  problem.objectives[0] = {0, true, 0.25};
  EXPECT_EQ(judge(problem, {true, {std::nullopt, 0.3}}).objectives[0], -0.25);
}

// Two designs on the front: (1/2, 1/2) dominates 1/4, (1/4, 3/4) adds 1/4 * 1/4. The true values
// count, a design known from a coarse simulation only does not, nor does one beyond the reference.
TEST(Score, HypervolumeOfTrueValuesAtTheFinestLevel) {
  const SearchRun run{
      1,
      {{{0.25, 0.0}, 1, 0.5}, {{0.5, 0.0}, 0, 2.0}, {{0.5, 0.9}, 0, 2.0}, {{0.25, 0.0}, 0, 2.0}},
      0.0};
  const Curve curve = score(line_problem(), unit_yardstick(0.5), run);
  EXPECT_EQ(curve.share, (std::vector<double>{0.0, 0.5, 0.5, 0.625}));
  EXPECT_EQ(curve.seconds, (std::vector<double>{0.5, 2.5, 4.5, 6.5}));
}

// Of three runs two reach 95 %, after 2 and 1 evaluations: the median is 2. One reaches 99 %, so
// most never do.
TEST(Score, MedianOverRunsCountsThoseThatNeverGetThere) {
  const auto step = [](double x, double y) { return Step{{x, y}, 0, 2.0}; };
  const MethodRuns runs{"m",
                        "M",
                        "m",
                        {{1, {step(0.5, 0.5), step(0.5, 0.02)}, 3.0},
                         {2, {step(0.5, 0.0), step(0.1, 0.9)}, 1.0},
                         {3, {step(0.9, 0.9), step(0.8, 0.9)}, 2.0}}};
  const MethodScore result = score(line_problem(), unit_yardstick(0.25), runs);
  EXPECT_EQ(result.evaluations[0], 2.0);
  EXPECT_EQ(result.seconds[0], 4.0);
  EXPECT_EQ(result.evaluations[1], 2.0);
  EXPECT_EQ(result.evaluations[2], never);
  EXPECT_EQ(result.reached, (std::array{2, 2, 1}));
  EXPECT_EQ(result.own_seconds, 2.0);
  EXPECT_EQ(result.budget, 2);
}

TEST(Score, QuantilesInterpolate) {
  EXPECT_EQ(quantile({4.0, 1.0, 2.0, 3.0, 5.0}, 0.25), 2.0);
  EXPECT_EQ(quantile({1.0, 2.0}, 0.5), 1.5);
  EXPECT_EQ(quantile({1.0, never}, 0.0), 1.0);
}

// The front of the line reaches to 1 in both objectives, so the reference is 1.1; the median of
// what is allowed is nearer in f_1 and f_2 alike. A front of one point leaves the medians.
TEST(Score, ReferenceIsTheWorseOfFrontAndMedian) {
  const BenchProblem problem = line_problem();
  const Yardstick whole =
      make_yardstick(problem, {Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(1.0, 0.0)});
  EXPECT_NEAR(whole.reference[0], 1.1, 1e-12);
  EXPECT_NEAR(whole.reference[1], 1.1, 1e-12);
  const Yardstick point = make_yardstick(problem, {Eigen::Vector2d(0.1, 0.2)});
  EXPECT_LT(point.reference[0], 0.5);  // x is below 1/2 more often than not where x + y < 3/2
  EXPECT_GT(point.reference[0], 0.4);
  EXPECT_NEAR(point.reference[1], 1.0, 0.02);  // 1 - x + y is symmetric about 1
}

// What runs find beyond the front counts, so that no share exceeds 1.
TEST(Score, YardstickTakesInWhatRunsFound) {
  const BenchProblem problem = line_problem();
  Yardstick yardstick = unit_yardstick(0.0);
  yardstick.front = {Eigen::Vector2d(0.5, 0.6)};
  const MethodRuns runs{"m", "M", "m", {{1, {{{0.5, 0.0}, 0, 1.0}}, 0.0}}};
  extend(yardstick, problem, {runs});
  EXPECT_NEAR(yardstick.volume, 0.25, 1e-12);
  EXPECT_NEAR(score(problem, yardstick, runs.runs[0]).share.back(), 1.0, 1e-12);
}

TEST(Meter, KnownDesignsAreFreeAndTheBudgetHolds) {
  const BenchProblem problem = line_problem();
  Meter meter(problem, 2);
  EXPECT_TRUE(meter.evaluate({0.1, 0.1}).has_value());
  EXPECT_TRUE(meter.evaluate({0.1, 0.1}).has_value());
  EXPECT_EQ(meter.left(), 1);
  EXPECT_TRUE(meter.evaluate({0.2, 0.1}).has_value());
  EXPECT_FALSE(meter.evaluate({0.3, 0.1}).has_value());
  EXPECT_TRUE(meter.evaluate({0.2, 0.1}).has_value());
  EXPECT_EQ(meter.steps().size(), 2u);
}

// Every method, with its budget: no more evaluations, none that the cheap constraints refuse, none
// outside the box, the same ones again for the same seed and others for another.
class Methods : public testing::TestWithParam<const char*> {
 protected:
  static SearchRun run(std::uint64_t seed) {
    static const BenchProblem problem = line_problem();
    const std::string method = GetParam();
    if (method == "random") return random_search(problem, seed, 30);
    if (method == "nsga2") return nsga2_search(problem, 20, seed, 30);
    if (method == "bayesian") return bayesian_search(problem, false, seed, 12);
    return scalarised_search(problem, method, seed, 30);
  }
};

TEST_P(Methods, KeepToTheRules) {
  const SearchRun first = run(1), again = run(1), other = run(2);
  const BenchProblem problem = line_problem();
  EXPECT_LE(first.steps.size(), 30u);
  EXPECT_GE(first.steps.size(), 12u);
  ASSERT_EQ(first.steps.size(), again.steps.size());
  bool same = first.steps.size() == other.steps.size();
  for (std::size_t k = 0; k < first.steps.size(); ++k) {
    const Design& x = first.steps[k].x;
    EXPECT_TRUE(problem.allows(x));
    for (const double u : x) {
      EXPECT_GE(u, 0.0);
      EXPECT_LE(u, 1.0);
    }
    EXPECT_EQ(x, again.steps[k].x) << "evaluation " << k;
    same = same && x == other.steps[k].x;
  }
  EXPECT_FALSE(same);
}

INSTANTIATE_TEST_SUITE_P(All, Methods,
                         testing::Values("random", "nsga2", "bayesian", "COBYLA", "SBPLX",
                                         "GN_CRS2_LM", "GN_DIRECT_L"),
                         [](const auto& instance) { return std::string(instance.param); });

// Brute force finds the line: the triangle under the reference (1, 1) is 1/2; 200 points short of
// it by about 1 / (2 * 200), and NSGA-II's are not exactly on it.
TEST(BruteForce, FindsTheFront) {
  Yardstick yardstick = make_yardstick(line_problem(), brute_force_front(line_problem(), 8000));
  yardstick.reference = Eigen::Vector2d(1.0, 1.0);
  extend(yardstick, line_problem(), {});
  EXPECT_LT(yardstick.volume, 0.5);
  EXPECT_GT(yardstick.volume, 0.49);
}

}  // namespace
}  // namespace parapet::bench::search
