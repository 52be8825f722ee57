#include "methods.hpp"
#include "scrambled_sobol.hpp"

namespace parapet::bench::search {

std::optional<Verdict> Meter::evaluate(const Design& x) {
  const auto found = known_.find(x);
  if (found != known_.end()) return found->second;
  if (spent()) return std::nullopt;
  const Verdict verdict = judge(problem_, problem_.evaluate(x, 0));
  steps_.push_back({x, 0, problem_.level_seconds.front()});
  known_.emplace(x, verdict);
  return verdict;
}

Run random_search(const BenchProblem& problem, std::uint64_t seed, int budget) {
  Meter meter(problem, budget);
  ScrambledSobol points(static_cast<int>(problem.dimension()), seed);
  while (!meter.spent()) {
    const Design x = problem.from_unit(points.next());
    if (problem.allows(x)) meter.evaluate(x);
  }
  return {seed, meter.steps(), 0.0};
}

}  // namespace parapet::bench::search
