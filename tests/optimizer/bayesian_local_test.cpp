/// Local steps: the last digits of one objective.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bayesian_problems.hpp"

namespace parapet::bayesian {
namespace {

/// Gardner et al. (ICML 2014): sin a + b where sin a sin b <= -0.95; least arcsin 0.95 - 1.
Problem gardner_problem() {
  Problem problem;
  problem.space = Space({continuous("a", 0.0, 6.0), continuous("b", 0.0, 6.0)});
  problem.metrics = {{.name = "cost"}, {.name = "limited"}};
  problem.objectives = {{.metric = 0}};
  problem.limits = {{.metric = 1, .upper = -0.95}};
  return problem;
}
Observation gardner_answer(const Suggestion& s) {
  return {.ok = true,
          .values = {std::sin(s.x[0]) + s.x[1], std::sin(s.x[0]) * std::sin(s.x[1])},
          .seconds = 1.0};
}

double gap(bool local_steps, std::uint64_t seed) {
  SearchOptions options = budget(60, seed);
  options.local_steps = local_steps;
  Search search(gardner_problem(), options);
  run(search, gardner_answer);
  return best_value(search, 0) - (std::asin(0.95) - 1.0);
}

TEST(LocalSteps, FindTheLastDigitsAtALimit) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_LT(gap(true, seed), 1e-4) << "seed " << seed;
  }
}

TEST(LocalSteps, AreTheReason) {
  // Without them the same search ends some 1e-3 away.
  EXPECT_LT(gap(true, 1), 0.1 * gap(false, 1));
}

TEST(LocalSteps, LeaveNoiseAlone) {
  // Noise of 5 on a function whose range is 300: no digits are to be had, and few steps are spent.
  Search search(branin_problem(), budget(40));
  std::uint64_t state = 7;
  const auto noise = [&state] {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      sum += static_cast<double>(state >> 11U) * 0x1p-53;
    }
    return sum;
  };
  const auto asked = run(search, [&](const Suggestion& s) {
    return Observation{
        .ok = true, .values = {branin(s.x[0], s.x[1]) + 5.0 * noise()}, .seconds = 1.0};
  });
  const auto local = std::count_if(asked.begin(), asked.end(),
                                   [](const Suggestion& s) { return s.stage == "local"; });
  EXPECT_LE(local, 20);  // every other one at most
}

TEST(LocalSteps, KeepToChoicesAndWholeNumbers) {
  Problem problem;
  problem.space = Space({{.name = "kind", .kind = VariableKind::choice, .upper = 1},
                         {.name = "n", .kind = VariableKind::integer, .lower = 0, .upper = 9},
                         continuous("a", 0.0, 1.0)});
  problem.metrics = {{.name = "loss"}};
  problem.objectives = {{.metric = 0}};
  Search search(problem, budget(50));
  const auto asked = run(search, [](const Suggestion& s) {
    const double a = s.x[2] - 0.3141;
    return Observation{.ok = true,
                       .values = {(s.x[0] == 0.0 ? 0.5 : 0.0) + std::abs(s.x[1] - 4.0) + a * a},
                       .seconds = 1.0};
  });
  for (const Suggestion& s : asked) EXPECT_EQ(s.x[1], std::round(s.x[1]));
  EXPECT_LT(best_value(search, 0), 1e-6);
}

}  // namespace
}  // namespace parapet::bayesian
