/// Starting batch, cache, failures, exceptions, cancelling.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "evaluation_ledger.hpp"
#include "parapet/optimizer/optimize.hpp"
#include "problem_zoo.hpp"

namespace parapet::optimizer {
namespace {

using zoo::Known;
using zoo::Vector;

TEST(Evaluations, StartsComeFirstAsOneBatchAndCountOnce) {
  Known known = zoo::branin();
  std::vector<std::vector<Vector>> batches;
  Problem problem = known.problem;
  problem.evaluate_batch = [&](const std::vector<Vector>& xs) {
    batches.push_back(xs);
    std::vector<Evaluation> answers;
    for (const Vector& x : xs) answers.push_back(known.problem.evaluate(x));
    return answers;
  };
  Options options;
  options.starts = {{0.1, 0.7}, {3.3, 3.3}, {0.1, 0.7}};
  options.start_count = 3;
  options.max_evaluations = 30;
  const auto result = optimize(problem, options);
  ASSERT_EQ(batches.size(), 1U);
  EXPECT_EQ(batches[0].size(), 5U) << "two different starts and three Sobol' points";
  // 0.1 is not on the search's grid: starting points are kept to the bit all the same.
  EXPECT_EQ(result.history[0].x, (Vector{0.1, 0.7}));
  EXPECT_EQ(result.history[1].x, (Vector{3.3, 3.3}));
  // The repeated start, and the algorithm's first query at the best start.
  EXPECT_GE(result.cache_hits, 2);
  EXPECT_EQ(result.evaluations, static_cast<int>(result.history.size()));

  // Without a batch function the same points are evaluated one after the other.
  const auto serial = optimize(known.problem, options);
  ASSERT_EQ(serial.history.size(), result.history.size());
  for (std::size_t i = 0; i < serial.history.size(); ++i) {
    EXPECT_EQ(serial.history[i].x, result.history[i].x);
  }
}

TEST(Evaluations, TheSearchBeginsAtTheBestStart) {
  // COBYLA's first own point is one initial step of one variable away from where it begins.
  Known known = zoo::sphere(2);
  Options options;
  options.starts = {{1.9, 1.9}, {0.4, 0.5}, {-0.9, 1.5}};
  options.max_evaluations = 10;
  const auto result = optimize(known.problem, options);
  const Vector& first = result.history[3].x;
  const double step = options.initial_step * 3.0;
  EXPECT_NEAR(std::abs(first[0] - 0.4) + std::abs(first[1] - 0.5), step, 1e-9);
}

TEST(Evaluations, FailuresAreToldAsWorseThanTheWorst) {
  Known known = zoo::linear_on_disc();
  Problem problem = known.problem;
  problem.evaluate = [&](const Vector& x) {
    if (x[0] > 1.0) return Evaluation{.ok = false, .reason = "diverged", .constraints = {}};
    return known.problem.evaluate(x);
  };
  const Options options;
  const UnitBox box(problem.lower, problem.upper);
  EvaluationLedger ledger(problem, options, box);
  ledger.evaluate_starts({{0.0, 0.0}, {-1.0, -1.0}, {0.5, 0.5}});
  const Reply failed = ledger.ask({0.99, 0.5});
  EXPECT_NEAR(failed.objective, 2.0 + 0.1 * 3.0, 1e-12) << "worst 2, spread 3";
  EXPECT_EQ(failed.constraints, Vector{1.0}) << "the largest seen, at (-1, -1)";
  EXPECT_EQ(ledger.failures(), 1);
}

TEST(Evaluations, RefusedPointsBorrowFromTheNearestSuccess) {
  Known known = zoo::cheap_half();
  const Options options;
  const UnitBox box(known.problem.lower, known.problem.upper);
  EvaluationLedger ledger(known.problem, options, box);
  ledger.evaluate_starts({{-1.0, -1.0}, {0.0, 0.0}});
  const Reply refused = ledger.ask(box.to_unit({1.0, 1.0}));
  EXPECT_EQ(refused.objective, known.problem.evaluate({0.0, 0.0}).objective);
  ASSERT_EQ(refused.constraints.size(), 1U);
  EXPECT_NEAR(refused.constraints[0], 1.8, 1e-11) << "its own: 1 + 1 - 0.2";
  EXPECT_EQ(ledger.rejected(), 1);
  EXPECT_EQ(ledger.evaluations(), 2);
}

TEST(Evaluations, ValuesThatAreNotFiniteAreFailures) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    Known known = zoo::linear_on_disc();
    Problem problem = known.problem;
    problem.evaluate = [&](const Vector& x) {
      Evaluation e = known.problem.evaluate(x);
      if (x[0] > 0.3) e.objective = bad;
      if (x[0] < -0.3) e.constraints[0] = bad;
      return e;
    };
    Options options;
    options.start_count = 3;
    const auto result = optimize(problem, options);
    ASSERT_TRUE(result.best);
    EXPECT_LE(std::abs(result.best->x[0]), 0.3);
    bool failed = false;
    for (const Point& point : result.history) {
      if (std::abs(point.x[0]) <= 0.3) continue;
      failed = true;
      EXPECT_FALSE(point.evaluation.ok);
      EXPECT_NE(point.evaluation.reason.find("not a finite number"), std::string::npos);
    }
    EXPECT_TRUE(failed);
  }
}

TEST(Evaluations, AllStartsFailingEndsWithTheReason) {
  Known known = zoo::sphere(2);
  known.problem.evaluate = [](const Vector&) {
    return Evaluation{.ok = false, .reason = "time step collapsed", .constraints = {}};
  };
  Options options;
  options.start_count = 4;
  const auto result = optimize(known.problem, options);
  EXPECT_EQ(result.termination, Termination::failed);
  EXPECT_EQ(result.evaluations, 4);
  EXPECT_FALSE(result.best);
  EXPECT_FALSE(result.best_infeasible);
  EXPECT_NE(result.message.find("all 4 starting points failed"), std::string::npos);
  EXPECT_NE(result.message.find("time step collapsed"), std::string::npos);
}

TEST(Evaluations, ExceptionsPassThroughEveryAlgorithm) {
  // The stack below the evaluator is C code: it must be left properly, at any moment.
  for (const AlgorithmInfo& info : algorithms()) {
    for (const int at : {1, 2, 7, 40}) {
      Known known = zoo::linear_on_disc();
      int calls = 0;
      Problem problem = known.problem;
      problem.evaluate = [&](const Vector& x) {
        if (++calls == at) throw std::domain_error("disk full");
        return known.problem.evaluate(x);
      };
      Options options;
      options.algorithm = info.name;
      if (info.name == "AUGLAG" || info.name.starts_with("MLSL")) options.local_algorithm = "SBPLX";
      options.max_evaluations = 60;
      options.relative_tolerance = 1e-7;
      try {
        optimize(problem, options);
        ADD_FAILURE() << info.name << " swallowed the exception of call " << at;
      } catch (const std::domain_error& error) {
        EXPECT_STREQ(error.what(), "disk full");
      }
      EXPECT_EQ(calls, at) << info.name << " went on after the exception";
    }
  }
}

TEST(Evaluations, WrongNumbersOfValuesAreErrorsOfTheCaller) {
  Problem problem = zoo::linear_on_disc().problem;
  problem.n_constraints = 2;
  EXPECT_THROW(optimize(problem, Options{}), std::logic_error);
  problem = zoo::cheap_half().problem;
  problem.n_cheap_constraints = 3;
  EXPECT_THROW(optimize(problem, Options{}), std::logic_error);
  problem = zoo::sphere(2).problem;
  problem.evaluate_batch = [](const std::vector<Vector>&) { return std::vector<Evaluation>(7); };
  EXPECT_THROW(optimize(problem, Options{}), std::logic_error);
}

TEST(Evaluations, CancellingStopsBeforeTheNextEvaluation) {
  Known known = zoo::rosenbrock();
  for (const AlgorithmInfo& info : algorithms()) {
    int calls = 0;
    Problem problem = known.problem;
    problem.evaluate = [&](const Vector& x) {
      ++calls;
      return known.problem.evaluate(x);
    };
    Options options;
    options.algorithm = info.name;
    if (info.name == "AUGLAG" || info.name.starts_with("MLSL")) options.local_algorithm = "BOBYQA";
    options.cancelled = [&] { return calls >= 12; };
    const auto result = optimize(problem, options);
    EXPECT_EQ(calls, 12) << info.name;
    EXPECT_EQ(result.termination, Termination::cancelled) << info.name;
    EXPECT_TRUE(result.best) << "what was found is kept";
  }
}

TEST(Evaluations, ATimeLimitOfNothingAllowsNoEvaluation) {
  Options options;
  options.max_time_s = 1e-12;
  const auto result = optimize(zoo::sphere(2).problem, options);
  EXPECT_EQ(result.termination, Termination::time_limit);
  EXPECT_EQ(result.evaluations, 0);
}

TEST(Evaluations, TerminationsHaveNames) {
  EXPECT_EQ(to_string(Termination::converged), "converged");
  EXPECT_EQ(to_string(Termination::no_feasible_start), "no_feasible_start");
  EXPECT_EQ(to_string(Termination::time_limit), "time_limit");
}

}  // namespace
}  // namespace parapet::optimizer
