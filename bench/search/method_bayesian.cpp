#include <cmath>

#include "as_bayesian.hpp"
#include "methods.hpp"
#include "parapet/bayesian/search.hpp"

namespace parapet::bench::search {
Run bayesian_search(const BenchProblem& problem, bool all_levels, std::uint64_t seed, int budget,
                    double max_seconds) {
  bayesian::SearchOptions options;
  options.max_evaluations = budget;
  options.seed = seed;
  if (std::isfinite(max_seconds)) options.max_seconds = max_seconds;
  bayesian::Search search(as_bayesian(problem, all_levels), options);
  Run run;
  run.seed = seed;
  while (const std::optional<bayesian::Suggestion> suggestion = search.ask()) {
    const bayesian::Observation observation = observe(problem, suggestion->x, suggestion->level);
    run.steps.push_back({suggestion->x, suggestion->level, observation.seconds});
    search.tell(suggestion->id, observation);
  }
  run.own_seconds = search.own_seconds();
  return run;
}

}  // namespace parapet::bench::search
