/// Every algorithm of the table: accuracy, exact budget, determinism, resuming.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include "parapet/optimizer/optimize.hpp"
#include "problem_zoo.hpp"

namespace parapet::optimizer {

// What CTest shows of a case.
void PrintTo(const AlgorithmInfo& info, std::ostream* out) {
  *out << info.name;
}
namespace {

using zoo::Known;
using zoo::Vector;

Options options_for(const AlgorithmInfo& info, int max_evaluations) {
  Options options;
  options.algorithm = info.name;
  if (info.name == "AUGLAG" || info.name.starts_with("MLSL")) options.local_algorithm = "BOBYQA";
  options.max_evaluations = max_evaluations;
  options.start_count = 4;
  return options;
}

std::vector<Vector> sequence(const OptimizeResult& result) {
  std::vector<Vector> xs;
  for (const Point& point : result.history) xs.push_back(point.x);
  return xs;
}

class EveryAlgorithm : public testing::TestWithParam<AlgorithmInfo> {};

TEST_P(EveryAlgorithm, FindsTheMinimumOfASmoothBowl) {
  // Local methods end when steps are below 1e-3 of the range of 3: f is then below about
  // n (3e-3)^2 = 2e-5 plus their own slack (measured <= 3e-6). Global methods are limited by the
  // budget: DIRECT's cells measured 2e-7, the populations 1e-6 (CRS2) to 5e-3 (ESCH, whose
  // mutations never contract); limit 1e-4 for the former, 2e-2 for populations and AGS.
  const Known known = zoo::sphere(2);
  const auto result = optimize(known.problem, options_for(GetParam(), 600));
  const std::string& name = GetParam().name;
  const bool coarse = name == "ISRES" || name == "ESCH" || name == "AGS" || name == "CRS2_LM";
  ASSERT_TRUE(result.best);
  EXPECT_GE(result.best->evaluation.objective, known.optimum);
  EXPECT_LT(result.best->evaluation.objective, coarse ? 2e-2 : 1e-4);
}

TEST_P(EveryAlgorithm, FindsAConstrainedMinimumOnACurvedBoundary) {
  // The multiplier of the disc is 1/sqrt(2), so an inward offset d of the solution costs
  // sqrt(2) d. Local methods resolve 1e-3 of the range of 3: d <= 3e-3, cost 4e-3 (measured up to
  // 5.7e-3, NEWUOA_BOUND). Global ones are limited by the budget (measured up to 4e-2, ESCH).
  const Known known = zoo::linear_on_disc();
  const auto result = optimize(known.problem, options_for(GetParam(), 1000));
  ASSERT_TRUE(result.best) << result.message;
  EXPECT_LE(result.best->evaluation.constraints[0], 1e-9);
  EXPECT_GE(result.best->evaluation.objective, known.optimum - 1e-8);
  EXPECT_LT(result.best->evaluation.objective, known.optimum + (GetParam().global ? 8e-2 : 1e-2));
}

TEST_P(EveryAlgorithm, NeverExceedsTheBudget) {
  // NLopt's COBYLA and population methods are known to overrun maxeval. Rosenbrock's valley keeps
  // every method busy for longer than 25 evaluations (37 with the constraint).
  for (const Known& known : {zoo::rosenbrock(), zoo::g06()}) {
    for (const int budget : {25, 37}) {
      Problem problem = known.problem;
      int calls = 0;
      problem.evaluate = [&](const Vector& x) {
        ++calls;
        return known.problem.evaluate(x);
      };
      const auto result = optimize(problem, options_for(GetParam(), budget));
      EXPECT_EQ(calls, budget) << known.name;
      EXPECT_EQ(result.evaluations, budget);
      EXPECT_EQ(result.history.size(), static_cast<std::size_t>(budget));
      EXPECT_EQ(result.termination, Termination::budget) << result.message;
    }
  }
}

TEST_P(EveryAlgorithm, NeverEvaluatesAPointTwiceNorOutsideTheBounds) {
  Known known = zoo::branin();
  const auto result = optimize(known.problem, options_for(GetParam(), 150));
  auto xs = sequence(result);
  for (const Vector& x : xs) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_GE(x[i], known.problem.lower[i]);
      EXPECT_LE(x[i], known.problem.upper[i]);
    }
  }
  std::sort(xs.begin(), xs.end());
  EXPECT_EQ(std::adjacent_find(xs.begin(), xs.end()), xs.end());
}

TEST_P(EveryAlgorithm, RepeatsItselfToTheBit) {
  for (const Known& known : {zoo::hartmann3(), zoo::linear_on_disc(), zoo::cheap_half()}) {
    const Options options = options_for(GetParam(), 80);
    const auto first = optimize(known.problem, options);
    // Another search in between must not leave a trace (NLopt's random state lives on).
    optimize(zoo::sphere(3).problem, options);
    const auto second = optimize(known.problem, options);
    EXPECT_EQ(sequence(first), sequence(second)) << known.name;
    EXPECT_EQ(first.message, second.message);
    EXPECT_EQ(first.cache_hits, second.cache_hits);
    EXPECT_EQ(first.rejected, second.rejected);
  }
}

TEST_P(EveryAlgorithm, ResumesFromItsOwnLog) {
  const Known known = zoo::mishra_bird();
  const Options options = options_for(GetParam(), 60);
  const auto undisturbed = optimize(known.problem, options);

  // The run is cut after 23 evaluations, as by a crash: only the log survives.
  std::map<Vector, Evaluation> log;
  Problem logged = known.problem;
  struct Crash {};
  logged.evaluate = [&](const Vector& x) {
    if (log.size() == 23) throw Crash{};
    return log[x] = known.problem.evaluate(x);
  };
  EXPECT_THROW(optimize(logged, options), Crash);

  int fresh = 0;
  Problem resumed = known.problem;
  resumed.evaluate = [&](const Vector& x) {
    if (const auto found = log.find(x); found != log.end()) return found->second;
    ++fresh;
    return log[x] = known.problem.evaluate(x);
  };
  const auto second = optimize(resumed, options);
  EXPECT_EQ(fresh, undisturbed.evaluations - 23);
  EXPECT_EQ(sequence(second), sequence(undisturbed));

  const int before = fresh;
  const auto replay = optimize(resumed, options);
  EXPECT_EQ(fresh, before) << "a finished run needs no new evaluation";
  ASSERT_EQ(replay.best.has_value(), undisturbed.best.has_value());
  if (replay.best) {
    EXPECT_EQ(replay.best->x, undisturbed.best->x);
  }
}

TEST_P(EveryAlgorithm, SurvivesFailingEvaluations) {
  const Known known = zoo::failing_sphere(3);
  const auto result = optimize(known.problem, options_for(GetParam(), 200));
  ASSERT_TRUE(result.best) << result.message;
  EXPECT_TRUE(result.best->evaluation.ok);
  const auto failed = std::count_if(result.history.begin(), result.history.end(),
                                    [](const Point& p) { return !p.evaluation.ok; });
  EXPECT_GT(failed, 0);
  // The starting points reach 0.6 at best (the first successful ones); every method gets well
  // below although 30 % of its points fail. Measured at most 0.35 (ESCH).
  EXPECT_LT(result.best->evaluation.objective, 0.5);
}

TEST_P(EveryAlgorithm, DoesNotClaimFeasibilityWhereThereIsNone) {
  const auto result = optimize(zoo::infeasible().problem, options_for(GetParam(), 120));
  EXPECT_FALSE(result.best);
  ASSERT_TRUE(result.best_infeasible);
  EXPECT_NE(result.message.find("no feasible point was found"), std::string::npos);
  // The least possible violation is 0.2; the box reaches 2.2. ORIG_DIRECT is only told allowed or
  // not and stays on a coarse grid: measured 0.37.
  const auto& g = result.best_infeasible->evaluation.constraints;
  EXPECT_GE(std::max(g[0], g[1]), 0.2);
  EXPECT_LT(std::max(g[0], g[1]), 0.4);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryAlgorithm, testing::ValuesIn(algorithms()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Algorithms, LocalOnesFollowRosenbrocksValleyWithATighterTolerance) {
  // At 1e-3 of the range model-based methods may stop in the valley; at 1e-6 they must not.
  const Known known = zoo::rosenbrock();
  for (const std::string name : {"BOBYQA", "NEWUOA_BOUND", "NELDERMEAD", "SBPLX", "PRAXIS"}) {
    Options options;
    options.algorithm = name;
    options.max_evaluations = 3000;
    options.relative_tolerance = 1e-6;
    const auto result = optimize(known.problem, options);
    ASSERT_TRUE(result.best);
    // f ~ 0.2 (distance along the valley)^2: 1e-6 allows a distance of 2e-3, 500 tolerances.
    EXPECT_LT(result.best->evaluation.objective, 1e-6) << name;
    EXPECT_EQ(result.termination, Termination::converged);
  }
}

TEST(Algorithms, GlobalOnesFindHartmannsGlobalMinimum) {
  // The next best minimum is -3.0898; being within 0.3 of -3.8628 proves the right basin.
  const Known known = zoo::hartmann3();
  for (const AlgorithmInfo& info : algorithms()) {
    if (!info.global) continue;
    const auto result = optimize(known.problem, options_for(info, 400));
    ASSERT_TRUE(result.best);
    EXPECT_LT(result.best->evaluation.objective, known.optimum + 0.3) << info.name;
    EXPECT_GE(result.best->evaluation.objective, known.optimum - 1e-9) << info.name;
  }
}

TEST(Algorithms, NoiseDoesNotStopTheSearch) {
  // Noise of +-0.005: nothing better than 0.005 above the optimum can be promised; the tolerance
  // adds as much again for the models that fit the noise.
  const Known known = zoo::noisy_sphere(3);
  for (const std::string name : {"COBYLA", "BOBYQA", "NELDERMEAD", "SBPLX", "DIRECT_L"}) {
    Options options;
    options.algorithm = name;
    options.max_evaluations = 200;
    const auto result = optimize(known.problem, options);
    ASSERT_TRUE(result.best);
    EXPECT_LT(std::abs(result.best->evaluation.objective), 0.01) << name;
  }
}

TEST(Algorithms, SearchesInOtherThreadsChangeNothing) {
  // NLopt's random numbers are documented as global; this holds it to one generator per thread.
  const Known known = zoo::hartmann3();
  for (const std::string name : {"ISRES", "CRS2_LM", "DIRECT_L_RAND", "ESCH"}) {
    Options options;
    options.algorithm = name;
    options.max_evaluations = 300;
    const auto alone = sequence(optimize(known.problem, options));
    std::vector<std::vector<Vector>> beside(4);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < beside.size(); ++t) {
      threads.emplace_back([&, t] {
        Options own = options;
        own.seed = t < 2 ? options.seed : options.seed + t;
        beside[t] = sequence(optimize(known.problem, own));
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(beside[0], alone) << name;
    EXPECT_EQ(beside[1], alone) << name;
  }
}

TEST(Algorithms, SeedsChangeRandomizedSearchesOnly) {
  const Known known = zoo::branin();
  for (const AlgorithmInfo& info : algorithms()) {
    Options options = options_for(info, 120);
    const auto first = optimize(known.problem, options);
    options.seed = 2;
    const auto second = optimize(known.problem, options);
    EXPECT_EQ(sequence(first) != sequence(second), info.randomized) << info.name;
  }
}

}  // namespace
}  // namespace parapet::optimizer
