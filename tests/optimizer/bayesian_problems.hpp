/// Problems for the Bayesian search, and a loop that runs it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "parapet/bayesian/search.hpp"

namespace parapet::bayesian {

using Evaluate = std::function<Observation(const Suggestion& suggestion)>;

/// Asks and tells until the search stops. Returns what was asked, in order.
inline std::vector<Suggestion> run(Search& search, const Evaluate& evaluate) {
  std::vector<Suggestion> asked;
  while (auto suggestion = search.ask()) {
    asked.push_back(*suggestion);
    search.tell(suggestion->id, evaluate(*suggestion));
  }
  return asked;
}

inline SearchOptions budget(int evaluations, std::uint64_t seed = 1) {
  return {.max_evaluations = evaluations, .seed = seed};
}

/// Least value of a metric among the feasible designs.
inline double best_value(const Search& search, std::size_t metric) {
  double best = std::numeric_limits<double>::infinity();
  for (const Assessed& a : search.assessed()) {
    if (a.feasible && a.values[metric]) best = std::min(best, *a.values[metric]);
  }
  return best;
}

inline Variable continuous(const char* name, double lower, double upper) {
  return {.name = name, .lower = lower, .upper = upper};
}

inline double branin(double a, double b) {
  using std::numbers::pi;
  const double c = b - 5.1 / (4.0 * pi * pi) * a * a + 5.0 / pi * a - 6.0;
  return c * c + 10.0 * (1.0 - 1.0 / (8.0 * pi)) * std::cos(a) + 10.0;
}

/// Minimise Branin's function; its least value is 0.397887 at three places.
inline Problem branin_problem() {
  Problem problem;
  problem.space = Space({continuous("a", -5.0, 10.0), continuous("b", 0.0, 15.0)});
  problem.metrics = {{.name = "branin"}};
  problem.objectives = {{.metric = 0}};
  return problem;
}

inline Observation branin_answer(const Suggestion& s) {
  return {.ok = true, .values = {branin(s.x[0], s.x[1])}, .seconds = 1.0};
}

/// Binh and Korn's problem (BNH): two objectives and two constraints.
inline Problem bnh_problem() {
  Problem problem;
  problem.space = Space({continuous("a", 0.0, 5.0), continuous("b", 0.0, 3.0)});
  problem.metrics = {{.name = "f1"}, {.name = "f2"}, {.name = "g1"}, {.name = "g2"}};
  problem.objectives = {{.metric = 0, .reference = 140.0}, {.metric = 1, .reference = 50.0}};
  problem.limits = {{.metric = 2, .upper = 25.0}, {.metric = 3, .lower = 7.7}};
  return problem;
}

inline Observation bnh_answer(const Suggestion& s) {
  const double a = s.x[0], b = s.x[1];
  return {.ok = true,
          .values = {4.0 * a * a + 4.0 * b * b, (a - 5.0) * (a - 5.0) + (b - 5.0) * (b - 5.0),
                     (a - 5.0) * (a - 5.0) + b * b, (a - 8.0) * (a - 8.0) + (b + 3.0) * (b + 3.0)},
          .seconds = 1.0};
}

}  // namespace parapet::bayesian
