#include "nlopt_adapter.hpp"

#include <nlopt.h>

#include <exception>
#include <memory>
#include <stdexcept>

namespace parapet::optimizer {
namespace {

struct DestroyOptimizer {
  void operator()(nlopt_opt_s* optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<nlopt_opt_s, DestroyOptimizer>;

/// What the C callbacks share during one run.
struct Run {
  const AnswerQuery& answer;
  nlopt_opt optimizer = nullptr;
  std::vector<double> last_u;
  Reply last_reply;
  bool objective_given = false;
  std::exception_ptr thrown;

  /// One query answers the objective and all constraints of a point. An objective asked again at
  /// the same point is a new query, so that an algorithm going round on one spot is noticed.
  /// Some algorithms ask on after a forced stop: they get the last reply again.
  const Reply& reply(unsigned n, const double* u, bool objective) {
    if (thrown) return last_reply;
    const std::vector<double> asked(u, u + n);
    const bool known = asked == last_u && !(objective && objective_given);
    objective_given = objective || (asked == last_u && objective_given);
    if (known) return last_reply;
    try {
      last_reply = answer(asked);
      last_u = asked;
    } catch (...) {
      thrown = std::current_exception();
      nlopt_force_stop(optimizer);
    }
    return last_reply;
  }
};

struct ConstraintData {
  Run* run;
  std::size_t index;
};

double objective_callback(unsigned n, const double* u, double* /*gradient*/, void* data) {
  return static_cast<Run*>(data)->reply(n, u, true).objective;
}

double constraint_callback(unsigned n, const double* u, double* /*gradient*/, void* data) {
  const auto* constraint = static_cast<const ConstraintData*>(data);
  return constraint->run->reply(n, u, false).constraints[constraint->index];
}

void require(nlopt_result result, nlopt_opt optimizer) {
  if (result >= 0) return;
  const char* message = nlopt_get_errmsg(optimizer);
  throw NloptFailure(std::string("NLopt refuses its set-up: ") +
                     (message ? message : nlopt_result_to_string(result)));
}

Optimizer create(const std::string& algorithm, const SearchRequest& request) {
  const auto n = static_cast<unsigned>(request.start.size());
  Optimizer optimizer(nlopt_create(nlopt_algorithm_from_string(algorithm.c_str()), n));
  if (!optimizer) throw NloptFailure("NLopt does not know the algorithm " + algorithm);
  require(nlopt_set_lower_bounds1(optimizer.get(), 0.0), optimizer.get());
  require(nlopt_set_upper_bounds1(optimizer.get(), 1.0), optimizer.get());
  require(nlopt_set_xtol_abs1(optimizer.get(), request.tolerance), optimizer.get());
  require(nlopt_set_initial_step1(optimizer.get(), request.initial_step), optimizer.get());
  return optimizer;
}

}  // namespace

SearchOutcome run_nlopt(const SearchRequest& request, const AnswerQuery& answer) {
  Optimizer optimizer = create(request.algorithm, request);
  Run run{.answer = answer,
          .optimizer = optimizer.get(),
          .last_u = {},
          .last_reply = {},
          .objective_given = false,
          .thrown = nullptr};
  run.last_reply.constraints.assign(static_cast<std::size_t>(request.n_constraints), 0.0);
  std::vector<ConstraintData> constraints(static_cast<std::size_t>(request.n_constraints));
  require(nlopt_set_min_objective(optimizer.get(), objective_callback, &run), optimizer.get());
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    constraints[k] = {&run, k};
    require(nlopt_add_inequality_constraint(optimizer.get(), constraint_callback, &constraints[k],
                                            request.constraint_tolerance),
            optimizer.get());
  }
  if (!request.local_algorithm.empty()) {
    const Optimizer local = create(request.local_algorithm, request);
    require(nlopt_set_local_optimizer(optimizer.get(), local.get()), optimizer.get());
  }
  if (request.population > 0) {
    require(nlopt_set_population(optimizer.get(), static_cast<unsigned>(request.population)),
            optimizer.get());
  }
  if (request.evaluation_limit > 0) {
    require(nlopt_set_maxeval(optimizer.get(), request.evaluation_limit), optimizer.get());
  }
  nlopt_srand(static_cast<unsigned long>(request.seed));

  SearchOutcome outcome;
  outcome.u = request.start;
  double objective = 0.0;
  const nlopt_result result = nlopt_optimize(optimizer.get(), outcome.u.data(), &objective);
  if (run.thrown) std::rethrow_exception(run.thrown);
  outcome.converged = result > 0 || result == NLOPT_ROUNDOFF_LIMITED;
  outcome.code = nlopt_result_to_string(result);
  if (const char* message = nlopt_get_errmsg(optimizer.get())) {
    outcome.code += std::string(": ") + message;
  }
  return outcome;
}

bool nlopt_has(const std::string& algorithm) {
  const AnswerQuery parabola = [](const std::vector<double>& u) {
    return Reply{.objective = (u[0] - 0.3) * (u[0] - 0.3), .constraints = {}};
  };
  const Optimizer optimizer(nlopt_create(nlopt_algorithm_from_string(algorithm.c_str()), 2));
  if (!optimizer) return false;
  Run run{.answer = parabola,
          .optimizer = optimizer.get(),
          .last_u = {},
          .last_reply = {},
          .objective_given = false,
          .thrown = nullptr};
  std::vector<double> u{0.5, 0.5};
  double objective = 0.0;
  nlopt_set_min_objective(optimizer.get(), objective_callback, &run);
  nlopt_set_lower_bounds1(optimizer.get(), 0.0);
  nlopt_set_upper_bounds1(optimizer.get(), 1.0);
  nlopt_set_maxeval(optimizer.get(), 4);
  return nlopt_optimize(optimizer.get(), u.data(), &objective) != NLOPT_INVALID_ARGS;
}

}  // namespace parapet::optimizer
