/// Levels of fidelity: which one is asked, and what is confirmed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bayesian_problems.hpp"

namespace parapet::bayesian {
namespace {

constexpr double fine_cost = 9.0, coarse_cost = 1.0;

/// Loss against a price that is known exactly: the front is b = 0.5 at every a.
Problem trade_off(double limit) {
  Problem problem;
  problem.space = Space({continuous("a", 0.0, 1.0), continuous("b", 0.0, 1.0)});
  problem.metrics = {{.name = "loss"}, {.name = "price"}, {.name = "load"}};
  problem.metrics[1].exact = [](const Point& x) { return x[0]; };
  problem.objectives = {{.metric = 0, .reference = 1.2}, {.metric = 1, .reference = 1.2}};
  problem.limits = {{.metric = 2, .upper = limit}};
  problem.levels = {{.seconds = fine_cost}, {.seconds = coarse_cost}};
  return problem;
}

/// A number of -1 .. 1 that follows from the design and has nothing to do with its neighbours'.
double scatter(const Point& x) {
  return 2.0 * std::fmod(std::abs(1e4 * std::sin(12.9898 * x[0] + 78.233 * x[1])), 1.0) - 1.0;
}

/// The coarse level's loss is off by a smooth tenth. Its load is the fine one, or noise.
Observation answer(const Suggestion& s, bool load_correlates) {
  const double b = s.x[1] - 0.5, price = s.x[0];
  const double loss = (1.0 - price) * (1.0 - price) + b * b;
  const double load = s.x[1];
  const bool fine = s.level == 0;
  return {.ok = true,
          .values = {loss + (fine ? 0.0 : 0.1 * (1.0 - price)), std::nullopt,
                     fine || load_correlates ? load : 0.6 + 0.4 * scatter(s.x)},
          .seconds = fine ? fine_cost : coarse_cost};
}

std::vector<Suggestion> ask_all(Search& search, bool load_correlates = true) {
  return run(search, [&](const Suggestion& s) { return answer(s, load_correlates); });
}

SearchOptions cost_budget(double fine_runs) {
  SearchOptions options = budget(1000);
  options.max_seconds = fine_runs * fine_cost;
  return options;
}

int count(const std::vector<Suggestion>& asked, int level, const std::string& stage = "") {
  return static_cast<int>(std::count_if(asked.begin(), asked.end(), [&](const Suggestion& s) {
    return s.level == level && (stage.empty() || s.stage == stage);
  }));
}

TEST(Levels, CoarseRunsDoTheWorkWhereTheyTellTheSame) {
  Search search(trade_off(2.0), cost_budget(8));
  const auto asked = ask_all(search);
  EXPECT_EQ(search.stop_reason(), StopReason::seconds);
  EXPECT_LE(search.seconds(), 9.0 * fine_cost);  // the last one begins within the budget
  EXPECT_GE(count(asked, 1), 3 * count(asked, 0));
  // What is recommended and its neighbours on the front are confirmed.
  EXPECT_GE(count(asked, 0, "confirm"), 2);
  EXPECT_LE(count(asked, 0, "confirm"), 4);
}

TEST(Levels, TheFrontHoldsDesignsKnownCoarselyWithTheirUncertainty) {
  Search search(trade_off(2.0), cost_budget(8));
  ask_all(search);
  // The estimates at the finest level hold the truth, which no coarse run shows.
  int held = 0, coarse = 0;
  for (const Assessed& one : search.assessed()) {
    if (one.level == 0) continue;
    const double b = one.x[1] - 0.5;
    const double truth = (1.0 - one.x[0]) * (1.0 - one.x[0]) + b * b;
    ++coarse;
    held += one.lower[0] <= truth && truth <= one.upper[0] ? 1 : 0;
    EXPECT_LT(one.lower[0], one.upper[0]);
  }
  EXPECT_GE(held, coarse * 3 / 4);
}

TEST(Levels, ALimitThatCoarseRunsDoNotShowIsLearntFromFineOnes) {
  // The limit load <= 0.4 cuts the front off its unconstrained place, b = 0.5.
  Search sees(trade_off(0.4), cost_budget(12)), blind(trade_off(0.4), cost_budget(12));
  const auto asked_sees = ask_all(sees);
  const auto asked_blind = ask_all(blind, false);
  const auto share = [&](const std::vector<Suggestion>& asked) {
    return static_cast<double>(count(asked, 0)) / static_cast<double>(asked.size());
  };
  EXPECT_GT(share(asked_blind), share(asked_sees));
  // The surrogate knows it.
  const auto* process = blind.surrogate(2);
  ASSERT_NE(process, nullptr);
  EXPECT_LT(std::abs(process->level_correlation(1)), 0.9);
  EXPECT_GT(sees.surrogate(2)->level_correlation(1), 0.9);
}

TEST(Levels, WhatTheUserWouldPickIsConfirmed) {
  // The cheapest design of the front instead of the one in its middle.
  SearchOptions options = cost_budget(8);
  options.recommend = [](const std::vector<std::vector<double>>& front) {
    const auto best = std::min_element(front.begin(), front.end(),
                                       [](const auto& a, const auto& b) { return a[1] < b[1]; });
    return static_cast<std::size_t>(best - front.begin());
  };
  Search search(trade_off(2.0), options);
  const auto asked = ask_all(search);
  double cheapest = 1.0;
  for (const Suggestion& s : asked) {
    if (s.stage == "confirm") cheapest = std::min(cheapest, s.x[0]);
  }
  EXPECT_LT(cheapest, 0.15);
}

}  // namespace
}  // namespace parapet::bayesian
