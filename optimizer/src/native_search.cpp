#include <algorithm>
#include <stdexcept>

#include "feasibility.hpp"
#include "search.hpp"

namespace parapet::optimizer {
SearchRequest base_request(const Search& search, const std::vector<double>& start) {
  const int budget = search.options.max_evaluations;
  SearchRequest request;
  request.algorithm = search.algorithm.nlopt_name;
  if (search.local) request.local_algorithm = search.local->nlopt_name;
  request.start = start;
  request.initial_step = search.initial_step;
  // CRS2 would end as soon as its best point improves by less than the tolerance, however wide the
  // population still is: global algorithms search until the budget is used.
  const bool by_itself = !search.algorithm.info.global || search.local;
  request.tolerance = by_itself ? search.options.relative_tolerance : 0.0;
  request.constraint_tolerance = search.options.feasibility_tolerance;
  request.population = population_for(search.algorithm, search.n_variables, budget);
  // AGS counts refused points too; the ledger stops it at the real budget.
  if (search.algorithm.info.name == "AGS") request.evaluation_limit = 20 * budget;
  request.seed = search.options.seed;
  return request;
}

SearchOutcome search_natively(const Search& search, const std::vector<double>& start) {
  constexpr int max_rounds = 6;
  const double tolerance = search.options.feasibility_tolerance;
  std::vector<double> margin(static_cast<std::size_t>(search.n_constraints), 0.0);
  SearchRequest request = base_request(search, start);
  request.n_constraints = search.n_constraints;
  const AnswerQuery answer = [&](const std::vector<double>& u) {
    Reply reply = search.ledger.ask(u);
    for (std::size_t k = 0; k < margin.size(); ++k) reply.constraints[k] += margin[k];
    return reply;
  };
  SearchOutcome outcome;
  for (int round = 0; round < max_rounds; ++round) {
    outcome = run_nlopt(request, answer);
    if (!outcome.converged) throw NloptFailure("NLopt answered " + outcome.code);
    if (search.algorithm.info.global || search.n_constraints == 0) break;
    const Reply end = search.ledger.ask(outcome.u);
    if (violation(end.constraints) <= tolerance) break;
    for (std::size_t k = 0; k < margin.size(); ++k) {
      margin[k] += 1.5 * std::max(0.0, end.constraints[k]);
    }
    request.start = outcome.u;
    request.initial_step = std::min(search.initial_step, 10.0 * request.tolerance);
  }
  return outcome;
}

}  // namespace parapet::optimizer
