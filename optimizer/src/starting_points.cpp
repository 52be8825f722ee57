#include "starting_points.hpp"

#include <algorithm>
#include <cmath>

#include "feasibility.hpp"
#include "nlopt_adapter.hpp"
#include "parapet/optimizer/sobol.hpp"

namespace parapet::optimizer {
namespace {

struct EnoughTried {};

/// Nearest allowed point to u, by COBYLA on the cheap constraints alone; empty when it finds none.
std::vector<double> move_to_allowed(const Options& options, const UnitBox& box,
                                    const EvaluationLedger& ledger, const std::vector<double>& u0) {
  std::vector<double> allowed;
  int queries = 0;
  const AnswerQuery answer = [&](const std::vector<double>& u) {
    if (!allowed.empty() || ++queries > 2000) throw EnoughTried{};
    const std::vector<double> x = box.from_unit(u);
    Reply reply{.objective = 0.0, .constraints = ledger.cheap_values(x)};
    if (violation(reply.constraints) <= options.feasibility_tolerance) allowed = x;
    for (double& c : reply.constraints) {
      if (!std::isfinite(c)) c = c < 0.0 ? -1e3 : 1e3;
    }
    for (std::size_t i = 0; i < u.size(); ++i) {
      reply.objective += 1e-3 * (u[i] - u0[i]) * (u[i] - u0[i]);
    }
    return reply;
  };
  SearchRequest request;
  request.algorithm = "LN_COBYLA";
  request.start = u0;
  request.n_constraints = static_cast<int>(ledger.cheap_values(box.from_unit(u0)).size());
  request.initial_step = 0.1;
  request.tolerance = 1e-9;
  try {
    run_nlopt(request, answer);
  } catch (const EnoughTried&) {
  }
  return allowed;
}

}  // namespace

std::vector<std::vector<double>> choose_starts(const Problem& problem, const Options& options,
                                               const UnitBox& box, EvaluationLedger& ledger) {
  const auto allowed = [&](const std::vector<double>& x) {
    return violation(ledger.cheap_values(x)) <= options.feasibility_tolerance;
  };
  std::vector<std::vector<double>> starts;
  for (std::vector<double> x : options.starts) {
    for (double& value : x) value += 0.0;  // -0 and +0 are one design
    if (allowed(x)) {
      starts.push_back(std::move(x));
    } else {
      ledger.refuse(x);
    }
  }
  const std::size_t wanted =
      std::max<std::size_t>(1, starts.size() + static_cast<std::size_t>(options.start_count));
  if (starts.size() == wanted) return starts;

  const int n = static_cast<int>(problem.lower.size());
  SobolSequence sobol(n);
  std::vector<std::vector<double>> missed;
  constexpr int tries = 20000;
  constexpr std::size_t most_moved = 64;
  for (int k = 0; k < tries && starts.size() < wanted; ++k) {
    std::vector<double> u = sobol.next();
    std::vector<double> x = box.from_unit(u);
    if (allowed(x)) {
      if (std::find(starts.begin(), starts.end(), x) == starts.end())
        starts.push_back(std::move(x));
    } else if (missed.size() < most_moved) {
      missed.push_back(std::move(u));
    }
  }
  for (std::size_t k = 0; k < missed.size() && starts.size() < wanted; ++k) {
    std::vector<double> x = move_to_allowed(options, box, ledger, missed[k]);
    if (x.empty() || std::find(starts.begin(), starts.end(), x) != starts.end()) continue;
    starts.push_back(std::move(x));
  }
  return starts;
}

}  // namespace parapet::optimizer
