#include "zoo_problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "hash_noise.hpp"
#include "parapet/math/pareto.hpp"

namespace parapet::bench::search {
namespace {

zoo::Vector as_vector(const Design& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

// Reference minus the least value of the front, of each objective.
Eigen::VectorXd spans(const zoo::ZooProblem& source) {
  Eigen::VectorXd least = source.reference;
  for (const Eigen::VectorXd& y : source.front(500)) least = least.cwiseMin(y);
  return source.reference - least;
}

bool fails(const Trouble& trouble, const std::vector<double>& u) {
  if (u.back() > 1.0 - trouble.failing_region) return true;
  // the normal number's distribution function is uniform
  const double chance = 0.5 * std::erfc(-hash_normal(u, "failure") / std::sqrt(2.0));
  return chance < trouble.random_failures;
}

Answer formula(const zoo::ZooProblem& source, const Design& x) {
  Answer answer{true, {}};
  for (const double f : source.objectives(as_vector(x))) answer.values.emplace_back(f);
  for (const double c : source.constraints(as_vector(x))) answer.values.emplace_back(c);
  return answer;
}

}  // namespace

BenchProblem zoo_problem(const zoo::ZooProblem& source, const Trouble& trouble) {
  BenchProblem problem;
  problem.name = problem.title = source.name;
  for (Eigen::Index j = 0; j < source.lower.size(); ++j) {
    problem.variables.push_back(fmt::format("x{}", j + 1));
    problem.lower.push_back(source.lower[j]);
    problem.upper.push_back(source.upper[j]);
  }
  const zoo::Vector centre = 0.5 * (source.lower + source.upper);
  const auto n_objectives = static_cast<std::size_t>(source.objectives(centre).size());
  const auto n_limits = static_cast<std::size_t>(source.constraints(centre).size());
  for (std::size_t j = 0; j < n_objectives; ++j) {
    problem.metrics.push_back({fmt::format("f{}", j + 1), nullptr});
    problem.objectives.push_back({j, false, std::nullopt});
  }
  for (std::size_t k = 0; k < n_limits; ++k) {
    problem.metrics.push_back({fmt::format("g{}", k + 1), nullptr});
    problem.limits.push_back(
        {n_objectives + k, -std::numeric_limits<double>::infinity(), 0.0, 1.0});
  }
  problem.truth = [source](const Design& x) { return formula(source, x); };
  problem.evaluate = [source, trouble, span = spans(source), lower = problem.lower,
                      upper = problem.upper](const Design& x, int) {
    std::vector<double> u(x.size());
    for (std::size_t j = 0; j < x.size(); ++j) u[j] = (x[j] - lower[j]) / (upper[j] - lower[j]);
    if (fails(trouble, u)) return Answer{};
    Answer answer = formula(source, x);
    for (Eigen::Index j = 0; trouble.noise > 0.0 && j < span.size(); ++j) {
      *answer.values[static_cast<std::size_t>(j)] +=
          trouble.noise * span[j] * hash_normal(u, fmt::format("f{}", j + 1));
    }
    return answer;
  };
  // a design that fails gives nothing, however good its formula is
  if (trouble.random_failures > 0.0 || trouble.failing_region > 0.0) {
    problem.truth = [source, evaluate = problem.evaluate](const Design& x) {
      return evaluate(x, 0).ok ? formula(source, x) : Answer{};
    };
  }
  return problem;
}

Yardstick zoo_yardstick(const zoo::ZooProblem& source) {
  Yardstick yardstick;
  yardstick.reference = source.reference;
  yardstick.volume = source.front_hypervolume();
  return yardstick;
}

}  // namespace parapet::bench::search
