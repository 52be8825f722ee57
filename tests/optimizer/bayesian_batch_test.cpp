/// Many questions before an answer, many designs, and data that strain the surrogates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bayesian_problems.hpp"

namespace parapet::bayesian {
namespace {

double largest_difference(const Point& a, const Point& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Two objectives and a limit in `n` variables within 0 .. 1.
Problem bowl_problem(std::size_t n) {
  Problem problem;
  std::vector<Variable> variables;
  for (std::size_t i = 0; i < n; ++i) variables.push_back(continuous("x", 0.0, 1.0));
  problem.space = Space(variables);
  problem.metrics = {{.name = "near"}, {.name = "far"}, {.name = "limited"}};
  problem.objectives = {{.metric = 0, .reference = 3.0}, {.metric = 1, .reference = 3.0}};
  problem.limits = {{.metric = 2, .upper = 0.9}};
  return problem;
}

Observation bowl_answer(const Point& x) {
  double near = 0.0, far = 0.0;
  for (const double v : x) {
    near += (v - 0.3) * (v - 0.3);
    far += (v - 0.6) * (v - 0.6);
  }
  return {.ok = true, .values = {near, far, x[0]}, .seconds = 1.0};
}

/// A point of a simple lattice (Korobov), so that no two are near.
Point lattice_point(std::size_t k, std::size_t n) {
  Point x;
  double step = 0.6180339887498949;
  for (std::size_t i = 0; i < n; ++i) {
    x.push_back(std::fmod(static_cast<double>(k + 1) * step, 1.0));
    step = std::fmod(step * 17.0 + 0.137, 1.0);
  }
  return x;
}

TEST(Batches, ManyQuestionsBeforeAnAnswerDiffer) {
  // More than enter the joint draws (64): the others are still not asked for again.
  Search search(bowl_problem(3), budget(400));
  std::vector<Suggestion> asked;
  for (int k = 0; k < 12; ++k) {
    const auto s = search.ask();
    search.tell(s->id, bowl_answer(s->x));
  }
  for (int k = 0; k < 80; ++k) {
    const auto s = search.ask();
    ASSERT_TRUE(s.has_value()) << k;
    for (const Suggestion& other : asked) {
      EXPECT_GT(largest_difference(s->x, other.x), 1e-3) << k << " and " << other.id;
    }
    asked.push_back(*s);
  }
  for (const Suggestion& s : asked) search.tell(s.id, bowl_answer(s.x));
  EXPECT_EQ(search.evaluations(), 92);
}

TEST(Batches, PendingDesignsSpreadOverTheFront) {
  // The optimal designs are the line from (0.3, 0.3) to (0.6, 0.6). A question that ignored what is
  // pending would ask for the same part of it ten times.
  Search search(bowl_problem(2), budget(100));
  for (int k = 0; k < 20; ++k) {
    const auto s = search.ask();
    search.tell(s->id, bowl_answer(s->x));
  }
  double least = 1.0, greatest = 0.0;
  std::vector<Suggestion> asked;
  for (int k = 0; k < 10; ++k) {
    asked.push_back(*search.ask());
    least = std::min(least, asked.back().x[0]);
    greatest = std::max(greatest, asked.back().x[0]);
  }
  EXPECT_LT(least, 0.4);
  EXPECT_GT(greatest, 0.5);
  // A batch is worth its evaluations: compare with as many questions put one by one.
  for (const Suggestion& s : asked) search.tell(s.id, bowl_answer(s.x));
  Search one_by_one(bowl_problem(2), budget(30));
  run(one_by_one, [](const Suggestion& s) { return bowl_answer(s.x); });
  EXPECT_GT(search.history().back().hypervolume, 0.98 * one_by_one.history().back().hypervolume);
}

TEST(Batches, TheSameQuestionsToTheBit) {
  std::vector<Suggestion> first;
  for (int repeat = 0; repeat < 2; ++repeat) {
    Search search(bowl_problem(3), budget(100));
    std::vector<Suggestion> all;
    for (int round = 0; round < 4; ++round) {
      std::vector<Suggestion> batch;
      for (int k = 0; k < 6; ++k) batch.push_back(*search.ask());
      for (const Suggestion& s : batch) {
        search.tell(s.id, bowl_answer(s.x));
        all.push_back(s);
      }
    }
    if (repeat == 0) first = all;
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_TRUE(same_design(all[k].x, first[k].x)) << k;
      EXPECT_EQ(all[k].log_gain, first[k].log_gain) << k;
    }
  }
}

TEST(Batches, DuplicatesAndIllConditionedDataDoNotDisturb) {
  // 500 designs of 10 variables: a quarter are repeated, with the same values or with others, a
  // quarter differ by 1e-10, and one metric is constant.
  constexpr std::size_t n = 10;
  Problem problem = bowl_problem(n);
  problem.metrics.push_back({.name = "constant"});
  problem.limits.push_back({.metric = 3, .upper = 2.0});
  Search search(problem, budget(600));
  for (std::size_t k = 0; k < 500; ++k) {
    Point x = lattice_point(k / 2, n);
    if (k % 4 == 1) x[k % n] = std::min(1.0, x[k % n] + 1e-10);
    Observation o = bowl_answer(x);
    if (k % 8 == 3) *o.values[0] += 0.02;
    o.values.emplace_back(1.0);
    search.tell_external(x, 0, o);
  }
  std::vector<Suggestion> asked;
  for (int k = 0; k < 8; ++k) {
    const auto s = search.ask();
    ASSERT_TRUE(s.has_value());
    EXPECT_TRUE(std::isfinite(s->log_gain));
    for (const Suggestion& other : asked) EXPECT_GT(largest_difference(s->x, other.x), 1e-3);
    asked.push_back(*s);
  }
  // It still knows where to look: on the optimal line every coordinate is within 0.3 .. 0.6, and a
  // random design is 0.3 away from it in the root mean square.
  double distance = 0.0;
  for (const Suggestion& s : asked) {
    for (const double v : s.x) distance += std::pow(v - std::clamp(v, 0.3, 0.6), 2);
  }
  EXPECT_LT(std::sqrt(distance / (8.0 * n)), 0.15);
}

}  // namespace
}  // namespace parapet::bayesian
