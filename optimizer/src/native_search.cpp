#include <algorithm>
#include <stdexcept>

#include "feasibility.hpp"
#include "search.hpp"

namespace parapet::optimizer {
namespace {

bool all_within(const Reply& reply, double tolerance) {
  return violation(reply.constraints) <= tolerance;
}

}  // namespace

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
    if (all_within(end, tolerance)) break;
    for (std::size_t k = 0; k < margin.size(); ++k) {
      margin[k] += 1.5 * std::max(0.0, end.constraints[k]);
    }
    request.start = outcome.u;
    request.initial_step = std::min(search.initial_step, 10.0 * request.tolerance);
  }
  return outcome;
}

}  // namespace parapet::optimizer
