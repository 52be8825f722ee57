#include <algorithm>
#include <chrono>

#include "methods.hpp"
#include "parapet/optimizer/optimize.hpp"
#include "scrambled_sobol.hpp"

namespace parapet::bench::search {
namespace {

constexpr int n_weights = 5;
constexpr double augmentation = 0.05;  // of Steuer and Choo's range 0.001..0.1, its upper part

// Scales that the first designs give.
struct Ranges {
  Eigen::VectorXd least, span;
};

Ranges ranges_of(const std::vector<std::pair<Design, Verdict>>& first) {
  Ranges ranges;
  Eigen::VectorXd greatest;
  for (const auto& [x, verdict] : first) {
    if (!verdict.ok) continue;
    if (ranges.least.size() == 0) ranges.least = greatest = verdict.objectives;
    ranges.least = ranges.least.cwiseMin(verdict.objectives);
    greatest = greatest.cwiseMax(verdict.objectives);
  }
  ranges.span = (greatest - ranges.least).cwiseMax(1e-12);
  return ranges;
}

double chebyshev(const Eigen::VectorXd& objectives, const Eigen::VectorXd& weights,
                 const Ranges& ranges) {
  const Eigen::VectorXd z =
      weights.cwiseProduct((objectives - ranges.least).cwiseQuotient(ranges.span));
  return z.maxCoeff() + augmentation * z.sum();
}

// Weight vectors on the simplex of two objectives; of more, one towards each and the middle.
std::vector<Eigen::VectorXd> weight_vectors(Eigen::Index n_objectives) {
  std::vector<Eigen::VectorXd> weights;
  if (n_objectives == 1) return {Eigen::VectorXd::Ones(1)};
  if (n_objectives == 2) {
    for (int k = 0; k < n_weights; ++k) {
      const double w = 0.02 + 0.96 * k / (n_weights - 1);  // neither objective is forgotten
      weights.push_back(Eigen::Vector2d(w, 1.0 - w));
    }
    return weights;
  }
  const auto n = static_cast<double>(n_objectives);
  weights.push_back(Eigen::VectorXd::Constant(n_objectives, 1.0 / n));
  for (Eigen::Index j = 0; j < n_objectives; ++j) {
    weights.push_back(Eigen::VectorXd::Constant(n_objectives, 0.3 / n));
    weights.back()[j] += 0.7;
  }
  return weights;
}

std::vector<std::pair<Design, Verdict>> first_designs(Meter& meter, ScrambledSobol& points,
                                                      int count) {
  std::vector<std::pair<Design, Verdict>> first;
  while (static_cast<int>(first.size()) < count && !meter.spent()) {
    const Design x = meter.problem().from_unit(points.next());
    if (meter.problem().allows(x)) first.emplace_back(x, *meter.evaluate(x));
  }
  return first;
}

// The first design that serves a weight best: least total violation, then least value.
Design best_start(const std::vector<std::pair<Design, Verdict>>& first,
                  const Eigen::VectorXd& weights, const Ranges& ranges) {
  const auto key = [&](const Verdict& v) {
    if (!v.ok) return std::make_pair(1e9, 0.0);
    return std::make_pair(v.total_violation(), chebyshev(v.objectives, weights, ranges));
  };
  const auto best = std::min_element(first.begin(), first.end(), [&](const auto& a, const auto& b) {
    return key(a.second) < key(b.second);
  });
  return best->first;
}

optimizer::Problem scalar_problem(Meter& meter, const Eigen::VectorXd& weights,
                                  const Ranges& ranges) {
  const BenchProblem& problem = meter.problem();
  optimizer::Problem scalar;
  scalar.names = problem.variables;
  scalar.lower = problem.lower;
  scalar.upper = problem.upper;
  scalar.n_constraints = static_cast<int>(problem.limits.size());
  if (problem.cheap_constraints) {
    scalar.cheap_constraints = problem.cheap_constraints;
    scalar.n_cheap_constraints = static_cast<int>(problem.cheap_constraints(problem.lower).size());
  }
  scalar.evaluate = [&meter, weights, ranges](const Design& x) {
    const std::optional<Verdict> verdict = meter.evaluate(x);
    if (!verdict || !verdict->ok) return optimizer::Evaluation{false, "no value", 0.0, {}};
    return optimizer::Evaluation{true, "", chebyshev(verdict->objectives, weights, ranges),
                                 verdict->violations};
  };
  return scalar;
}

// Algorithms that start from a population refuse a smaller budget; the meter still ends the run.
void raise_to_least(optimizer::Options& options, const BenchProblem& problem) {
  const auto refused = [&] {
    return !optimizer::option_errors(options, static_cast<int>(problem.dimension()),
                                     static_cast<int>(problem.limits.size()))
                .empty();
  };
  constexpr int enough = 1000;  // any other error is optimize()'s to report
  while (options.max_evaluations < enough && refused()) ++options.max_evaluations;
}

}  // namespace

Run scalarised_search(const BenchProblem& problem, const std::string& algorithm, std::uint64_t seed,
                      int budget) {
  const auto begin = std::chrono::steady_clock::now();
  Meter meter(problem, budget);
  ScrambledSobol points(static_cast<int>(problem.dimension()), seed);
  const int n_first = 2 * static_cast<int>(problem.dimension()) + 2;
  const std::vector<Eigen::VectorXd> weights =
      weight_vectors(static_cast<Eigen::Index>(problem.objectives.size()));
  auto first = first_designs(meter, points, n_first);
  const Ranges ranges = ranges_of(first);
  if (ranges.least.size() == 0) return {seed, meter.steps(), 0.0};
  for (int round = 0; !meter.spent(); ++round) {
    const int before = meter.left();
    for (std::size_t k = 0; k < weights.size() && !meter.spent(); ++k) {
      const std::size_t turn = (k + seed) % weights.size();
      optimizer::Options options;
      options.algorithm = algorithm;
      options.starts = {best_start(first, weights[turn], ranges)};
      // an equal share of what is left; known designs are counted by optimize(), not by the meter,
      // so later rounds are given more
      options.max_evaluations =
          std::max(1, (round + 1) * meter.left() / static_cast<int>(weights.size() - k));
      raise_to_least(options, problem);
      options.seed = seed * 1000 + static_cast<std::uint64_t>(round);
      options.cancelled = [&meter] { return meter.spent(); };
      optimizer::optimize(scalar_problem(meter, weights[turn], ranges), options);
    }
    if (round > 0 && meter.left() == before) break;  // it only repeats itself
    if (!meter.spent()) first = first_designs(meter, points, n_first);
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  return {seed, meter.steps(), time.count()};
}

}  // namespace parapet::bench::search
