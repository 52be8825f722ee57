/// When the Bayesian search ends, what it is given, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bayesian_problems.hpp"

namespace parapet::bayesian {
namespace {

TEST(BayesianSearch, StopsAtALimitOfSeconds) {
  SearchOptions options = budget(100);
  options.max_seconds = 12.5;
  Search search(branin_problem(), options);
  run(search, branin_answer);
  EXPECT_EQ(search.stop_reason(), StopReason::seconds);
  EXPECT_EQ(search.evaluations(), 13);  // the one that crosses the limit was begun before it
}

TEST(BayesianSearch, StopsWhenNothingImprovesAnyMore) {
  SearchOptions options = budget(200);
  options.stagnation_evaluations = 10;
  Search search(branin_problem(), options);
  run(search, branin_answer);
  EXPECT_EQ(search.stop_reason(), StopReason::stagnation);
  EXPECT_LT(search.evaluations(), 100);
  EXPECT_LT(best_value(search, 0), 0.397887 + 0.3);
}

TEST(BayesianSearch, StopsWhenTheExpectedGainIsSmall) {
  SearchOptions options = budget(200);
  options.least_gain = 1e-4;
  Search search(branin_problem(), options);
  run(search, branin_answer);
  EXPECT_EQ(search.stop_reason(), StopReason::small_gain);
  EXPECT_LT(best_value(search, 0), 0.397887 + 0.05);
}

TEST(BayesianSearch, EndsWhenEveryDesignIsEvaluated) {
  Problem problem;
  problem.space = Space({{.name = "n", .kind = VariableKind::integer, .lower = 1, .upper = 6}});
  problem.metrics = {{.name = "loss"}};
  problem.objectives = {{.metric = 0}};
  Search search(problem, budget(50));
  run(search, [](const Suggestion& s) {
    return Observation{.ok = true, .values = {(s.x[0] - 4.0) * (s.x[0] - 4.0)}, .seconds = 1.0};
  });
  EXPECT_EQ(search.evaluations(), 6);
  EXPECT_EQ(search.stop_reason(), StopReason::exhausted);
}

TEST(BayesianSearch, SaysWhenNoDesignIsAllowed) {
  Problem problem = branin_problem();
  problem.cheap_constraints = [](const Point&) { return std::vector<double>{1.0}; };
  Search search(problem, budget(10));
  EXPECT_FALSE(search.ask().has_value());
  EXPECT_EQ(search.stop_reason(), StopReason::no_allowed_design);
}

TEST(BayesianSearch, AsksTheStartsFirst) {
  SearchOptions options = budget(10);
  options.starts = {{1.0, 2.0}, {3.0, 4.0}};
  Search search(branin_problem(), options);
  const auto asked = run(search, branin_answer);
  EXPECT_EQ(asked[0].x, (Point{1.0, 2.0}));
  EXPECT_EQ(asked[1].x, (Point{3.0, 4.0}));
  EXPECT_EQ(asked[0].stage, "start");
}

TEST(BayesianSearch, TakesEvaluationsMadeElsewhere) {
  Search search(branin_problem(), budget(20));
  for (int k = 0; k < 10; ++k) {
    const Point x{-5.0 + 1.5 * k, 15.0 - 1.5 * k};
    search.tell_external(x, 0, branin_answer({.x = x}));
  }
  const auto asked = run(search, branin_answer);
  EXPECT_EQ(search.evaluations(), 20);
  EXPECT_EQ(asked.size(), 10U);
  EXPECT_EQ(asked.front().stage, "search");
}

TEST(BayesianSearch, MetricsWithoutAValueCountAsTheLimitSays) {
  Problem problem = branin_problem();
  problem.metrics.push_back({.name = "launch"});
  problem.limits = {{.metric = 1, .upper = 1.0, .satisfied_when_absent = true}};
  Search search(problem, budget(20));
  run(search, [](const Suggestion& s) {
    Observation o = branin_answer(s);
    o.values.push_back(s.x[0] < 0.0 ? std::optional<double>() : s.x[0]);
    return o;
  });
  for (const Assessed& a : search.assessed()) EXPECT_EQ(a.feasible, a.x[0] <= 1.0);
}

TEST(BayesianSearch, ResumesItsInitialDesigns) {
  // What an interrupted search was told again counts among the initial designs, and the rest
  // follows.
  Search whole(branin_problem(), budget(30));
  const auto asked = run(whole, branin_answer);
  Search resumed(branin_problem(), budget(30));
  for (std::size_t k = 0; k < 3; ++k) {
    resumed.tell_external(asked[k].x, 0, branin_answer(asked[k]));
  }
  for (std::size_t k = 3; k < 6; ++k) {
    const auto s = resumed.ask();
    EXPECT_EQ(s->stage, "initial");
    EXPECT_TRUE(same_design(s->x, asked[k].x)) << k;
    resumed.tell(s->id, branin_answer(*s));
  }
  EXPECT_EQ(resumed.ask()->stage, "search");
}

TEST(BayesianSearch, StartsThatAreRefusedAreNotCounted) {
  Problem problem = branin_problem();
  problem.cheap_constraints = [](const Point&) { return std::vector<double>{1.0}; };
  SearchOptions options = budget(10);
  options.starts = {{1.0, 2.0}};
  Search search(problem, options);
  EXPECT_FALSE(search.ask().has_value());
  EXPECT_EQ(search.stop_reason(), StopReason::no_allowed_design);
}

TEST(BayesianSearch, NeighbouringIntegersAreDifferentDesigns) {
  Problem problem;
  problem.space = Space({{.name = "n", .kind = VariableKind::integer, .lower = 0, .upper = 5000}});
  problem.metrics = {{.name = "loss"}};
  problem.objectives = {{.metric = 0}};
  Search search(problem, budget(40));
  run(search, [](const Suggestion& s) {
    return Observation{.ok = true, .values = {std::abs(s.x[0] - 3217.0)}, .seconds = 1.0};
  });
  EXPECT_EQ(best_value(search, 0), 0.0);
}

TEST(BayesianSearch, ReferenceOfALogarithmicObjectiveIsInReach) {
  // Maximise a positive metric over two decades against a cost, with the natural reference of 0.
  Problem problem;
  problem.space = Space({continuous("a", 0.0, 1.0), continuous("b", 0.0, 1.0)});
  problem.metrics = {{.name = "force", .transform = surrogate::TransformKind::log},
                     {.name = "cost"}};
  problem.objectives = {{.metric = 0, .maximize = true, .reference = 0.0},
                        {.metric = 1, .reference = 1.5}};
  Search search(problem, budget(40));
  const auto asked = run(search, [](const Suggestion& s) {
    const double b = (s.x[1] - 0.5) * (s.x[1] - 0.5);
    return Observation{
        .ok = true, .values = {std::exp(5.0 * s.x[0]) * (1.0 - b), s.x[0] + b}, .seconds = 1.0};
  });
  // The front is b = 0.5 from end to end. With a reference 390 standard deviations away the gains
  // look small beside the hypervolume, and half of the evaluations are spent on doubts.
  const auto doubts = std::count_if(asked.begin(), asked.end(),
                                    [](const Suggestion& s) { return s.stage == "explore"; });
  EXPECT_LE(doubts, 4);
  EXPECT_GE(search.pareto().size(), 20U);
}

TEST(BayesianSearch, RefusesNonsense) {
  Problem problem = branin_problem();
  problem.objectives.clear();
  EXPECT_THROW(Search(problem, budget(10)), std::invalid_argument);
  problem = branin_problem();
  problem.limits = {{.metric = 0, .lower = 2.0, .upper = 1.0}};
  EXPECT_THROW(Search(problem, budget(10)), std::invalid_argument);
  EXPECT_THROW(Search(branin_problem(), budget(0)), std::invalid_argument);
  Search search(branin_problem(), budget(10));
  EXPECT_THROW(search.tell(3, branin_answer({.x = {0.0, 0.0}})), std::invalid_argument);
  const auto s = search.ask();
  EXPECT_THROW(search.tell(s->id, {.ok = true, .values = {}}), std::invalid_argument);
  search.tell(s->id, branin_answer(*s));
  EXPECT_THROW(search.tell(s->id, branin_answer(*s)), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::bayesian
