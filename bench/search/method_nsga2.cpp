#include <algorithm>
#include <chrono>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "methods.hpp"
#include "parapet/math/pareto.hpp"
#include "scrambled_sobol.hpp"

namespace parapet::bench::search {
namespace {

// Objectives of a design that is not feasible, greater than any feasible one's: see methods.hpp.
constexpr double broken_limit = 1e6, failed = 1e8, refused = 1e9;

pagmo::vector_double as_objectives(const Verdict& verdict, std::size_t n_objectives) {
  if (!verdict.ok) return pagmo::vector_double(n_objectives, failed);
  if (!verdict.feasible) {
    return pagmo::vector_double(n_objectives, broken_limit + verdict.total_violation());
  }
  return {verdict.objectives.begin(), verdict.objectives.end()};
}

pagmo::vector_double refusal(const BenchProblem& problem, const Design& x) {
  double violation = 0.0;
  for (const double c : problem.cheap_constraints(x)) violation += std::max(0.0, c);
  return pagmo::vector_double(problem.objectives.size(), refused * (1.0 + violation));
}

// What pagmo evaluates; it copies this, so the meter is outside.
struct Metered {
  Meter* meter = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    const BenchProblem& problem = meter->problem();
    if (!problem.allows(x)) return refusal(problem, x);
    const std::optional<Verdict> verdict = meter->evaluate(x);
    if (!verdict) return pagmo::vector_double(problem.objectives.size(), failed);
    return as_objectives(*verdict, problem.objectives.size());
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {meter->problem().lower, meter->problem().upper};
  }
  pagmo::vector_double::size_type get_nobj() const { return meter->problem().objectives.size(); }
};

pagmo::population start_population(const BenchProblem& problem, const pagmo::problem& udp,
                                   int population, std::uint64_t seed) {
  pagmo::population start(udp, 0, static_cast<unsigned>(seed));
  ScrambledSobol points(static_cast<int>(problem.dimension()), seed);
  while (static_cast<int>(start.size()) < population) {
    const Design x = problem.from_unit(points.next());
    if (problem.allows(x)) start.push_back(x);
  }
  return start;
}

}  // namespace

Run nsga2_search(const BenchProblem& problem, int population, std::uint64_t seed, int budget) {
  const auto begin = std::chrono::steady_clock::now();
  Meter meter(problem, budget);
  pagmo::population people =
      start_population(problem, pagmo::problem{Metered{&meter}}, population, seed);
  // as pagmo ships it, but mutation with probability 1/d as the paper has it
  pagmo::algorithm algorithm{pagmo::nsga2(1, 0.95, 10.0,
                                          1.0 / static_cast<double>(problem.dimension()), 50.0,
                                          static_cast<unsigned>(seed))};
  for (int idle = 0; !meter.spent() && idle < 100;) {
    const int before = meter.left();
    people = algorithm.evolve(people);
    idle = meter.left() == before ? idle + 1 : 0;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  return {seed, meter.steps(), time.count()};
}

std::vector<Eigen::VectorXd> brute_force_front(const BenchProblem& problem, int evaluations) {
  BenchProblem noise_free = problem;
  noise_free.evaluate = [truth = problem.truth](const Design& x, int) { return truth(x); };
  std::vector<Eigen::VectorXd> found;
  std::size_t enough = 4000;  // then what is dominated is thrown out
  const auto prune = [&] {
    std::vector<Eigen::VectorXd> front;
    for (const std::size_t i : math::non_dominated(found)) front.push_back(found[i]);
    found = std::move(front);
    enough = std::max<std::size_t>(4000, 2 * found.size());
  };
  const auto keep = [&](const Run& run) {
    for (const Step& step : run.steps) {
      const Verdict verdict = judge(problem, problem.truth(step.x));
      if (verdict.feasible) found.push_back(verdict.objectives);
      if (found.size() >= enough) prune();
    }
  };
  keep(nsga2_search(noise_free, 200, 1, evaluations / 2));
  keep(nsga2_search(noise_free, 100, 2, evaluations / 4));
  keep(random_search(noise_free, 3, evaluations / 4));
  prune();
  return found;
}

}  // namespace parapet::bench::search
