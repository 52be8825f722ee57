#include <cmath>

#include "as_bayesian.hpp"
#include "methods.hpp"
#include "parapet/bayesian/search.hpp"
#include "processor_seconds.hpp"

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
  for (;;) {
    const double begin = processor_seconds();
    const std::optional<bayesian::Suggestion> suggestion = search.ask();
    run.own_seconds += processor_seconds() - begin;
    if (!suggestion) return run;
    const bayesian::Observation observation = observe(problem, suggestion->x, suggestion->level);
    run.steps.push_back({suggestion->x, suggestion->level, observation.seconds});
    const double told = processor_seconds();
    search.tell(suggestion->id, observation);
    run.own_seconds += processor_seconds() - told;
  }
}

}  // namespace parapet::bench::search
