#include <algorithm>
#include <cmath>
#include <sstream>

#include "algorithm_table.hpp"
#include "nlopt_adapter.hpp"
#include "parapet/optimizer/optimize.hpp"
#include "parapet/optimizer/sobol.hpp"

namespace parapet::optimizer {
namespace {

using Errors = std::vector<std::string>;

template <typename... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

void check_numbers(const Options& options, Errors& errors) {
  if (options.max_evaluations < 1) {
    errors.push_back(sentence("max_evaluations is ", options.max_evaluations, "; allowed: >= 1"));
  }
  if (!(options.max_time_s >= 0.0)) {
    errors.push_back(sentence("max_time_s is ", options.max_time_s, "; allowed: >= 0 (0: none)"));
  }
  if (!(options.relative_tolerance > 0.0 && options.relative_tolerance < 1.0)) {
    errors.push_back(sentence("relative_tolerance is ", options.relative_tolerance,
                              "; allowed: above 0 and below 1, a share of each range"));
  }
  if (!(options.initial_step > 0.0 && options.initial_step <= 0.5)) {
    errors.push_back(sentence("initial_step is ", options.initial_step,
                              "; allowed: above 0 up to 0.5, a share of each range"));
  } else if (options.relative_tolerance >= options.initial_step) {
    errors.push_back(sentence("relative_tolerance ", options.relative_tolerance,
                              " is not below initial_step ", options.initial_step,
                              ": the search would end where it starts"));
  }
  if (options.start_count < 0) {
    errors.push_back(sentence("start_count is ", options.start_count, "; allowed: >= 0"));
  }
  if (!(options.feasibility_tolerance >= 0.0 && std::isfinite(options.feasibility_tolerance))) {
    errors.push_back(sentence("feasibility_tolerance is ", options.feasibility_tolerance,
                              "; allowed: >= 0 and finite"));
  }
}

void check_variables(const AlgorithmEntry& entry, int n_variables, int n_constraints,
                     Errors& errors) {
  const std::string& name = entry.info.name;
  if (n_variables < entry.min_variables) {
    errors.push_back(sentence(name, " needs at least ", entry.min_variables,
                              " variables and the problem has ", n_variables,
                              "; use COBYLA, SBPLX or DIRECT_L"));
  }
  if (entry.max_variables > 0 && n_variables > entry.max_variables) {
    errors.push_back(sentence(name, " works up to ", entry.max_variables,
                              " variables and the problem has ", n_variables,
                              "; use ORIG_DIRECT_L or ISRES"));
  }
  constexpr int ags_max_constraints = 10;
  if (name == "AGS" && n_constraints > ags_max_constraints) {
    errors.push_back(sentence("AGS takes up to ", ags_max_constraints,
                              " constraints and the problem has ", n_constraints,
                              "; use ISRES or COBYLA"));
  }
}

/// The local algorithm, or null after saying why there is none.
const AlgorithmEntry* check_local(const AlgorithmEntry& entry, const Options& options,
                                  Errors& errors) {
  const std::string& name = entry.info.name;
  const std::string& local_name = options.local_algorithm;
  if (!entry.needs_local) {
    if (!local_name.empty()) {
      errors.push_back(sentence("local_algorithm \"", local_name, "\" is given but ", name,
                                " takes none; only MLSL, MLSL_LDS and AUGLAG do"));
    }
    return nullptr;
  }
  const std::string allowed = "COBYLA, BOBYQA, NEWUOA_BOUND, NELDERMEAD, SBPLX or PRAXIS";
  if (local_name.empty()) {
    errors.push_back(sentence(name, " needs a local_algorithm: ", allowed));
    return nullptr;
  }
  std::string why_not;
  const AlgorithmEntry* local = find_algorithm(local_name, why_not);
  if (!local) {
    errors.push_back(sentence("local_algorithm: ", why_not));
  } else if (!local->usable_as_local) {
    errors.push_back(sentence("local_algorithm ", local->info.name,
                              " is not a local algorithm; allowed: ", allowed));
    return nullptr;
  }
  return local;
}

void check_budget(const AlgorithmEntry& entry, const AlgorithmEntry* local, const Options& options,
                  int n_variables, Errors& errors) {
  const long long given =
      static_cast<long long>(options.starts.size()) + std::max(0, options.start_count);
  if (given > options.max_evaluations) {
    errors.push_back(
        sentence(given, " starting points exceed max_evaluations ", options.max_evaluations));
    return;
  }
  const int own =
      entry.min_evaluations(n_variables) + (local ? local->min_evaluations(n_variables) : 0);
  const long long needed = std::max(1LL, given) - 1 + own;
  if (options.max_evaluations < needed) {
    errors.push_back(sentence("max_evaluations ", options.max_evaluations,
                              " is too small: ", entry.info.name, " needs at least ", own,
                              " evaluations for ", n_variables, " variables, which with ",
                              std::max(1LL, given), " starting points makes ", needed));
  }
}

void check_bounds(const Problem& problem, std::size_t n, Errors& errors) {
  for (std::size_t i = 0; i < n; ++i) {
    const double lower = problem.lower[i], upper = problem.upper[i];
    const std::string name =
        i < problem.names.size() ? problem.names[i] : "variable " + std::to_string(i);
    if (!std::isfinite(lower) || !std::isfinite(upper) || !std::isfinite(upper - lower)) {
      errors.push_back(sentence(name, ": the bounds ", lower, " .. ", upper,
                                " must be finite: every step and tolerance is a share of the "
                                "range"));
    } else if (!(lower < upper)) {
      errors.push_back(sentence(name, ": the lower bound ", lower, " is not below the upper bound ",
                                upper, "; leave a fixed value out of the variables"));
    }
  }
}

void check_starts_within(const Problem& problem, const Options& options, Errors& errors) {
  const std::size_t n = problem.lower.size();
  for (std::size_t s = 0; s < options.starts.size(); ++s) {
    if (options.starts[s].size() != n) continue;  // already said by option_errors
    for (std::size_t i = 0; i < n; ++i) {
      const double x = options.starts[s][i];
      if (x >= problem.lower[i] && x <= problem.upper[i]) continue;
      errors.push_back(sentence("starting point ", s, ": ",
                                i < problem.names.size() ? problem.names[i] : std::to_string(i),
                                " = ", x, " is outside its bounds ", problem.lower[i], " .. ",
                                problem.upper[i]));
    }
  }
}

}  // namespace

std::vector<std::string> option_errors(const Options& options, int n_variables, int n_constraints) {
  Errors errors;
  if (n_variables < 1) errors.push_back("the problem has no variables");
  if (n_constraints < 0) errors.push_back(sentence("n_constraints is ", n_constraints));
  check_numbers(options, errors);
  for (std::size_t s = 0; s < options.starts.size(); ++s) {
    if (options.starts[s].size() == static_cast<std::size_t>(std::max(0, n_variables))) continue;
    errors.push_back(sentence("starting point ", s, " has ", options.starts[s].size(),
                              " values and the problem has ", n_variables, " variables"));
  }
  if (n_variables > SobolSequence::max_dimension &&
      (options.starts.empty() || options.start_count > 0)) {
    errors.push_back(sentence("Sobol' starting points exist up to ", SobolSequence::max_dimension,
                              " variables and the problem has ", n_variables,
                              "; give starts and start_count 0"));
  }
  std::string why_not;
  const AlgorithmEntry* entry = find_algorithm(options.algorithm, why_not);
  if (!entry) {
    errors.push_back(why_not);
    return errors;
  }
  if (entry->info.name == "AGS" && !nlopt_has(entry->nlopt_name)) {
    errors.push_back(
        "this build of NLopt has no AGS (on Debian it is in libnlopt_cxx); use "
        "ORIG_DIRECT_L or ISRES");
  }
  const AlgorithmEntry* local = check_local(*entry, options, errors);
  check_variables(*entry, n_variables, n_constraints, errors);
  if (local) check_variables(*local, n_variables, n_constraints, errors);
  if (n_variables >= 1 && options.max_evaluations >= 1 && (local || !entry->needs_local)) {
    check_budget(*entry, local, options, n_variables, errors);
  }
  return errors;
}

std::vector<std::string> problem_errors(const Problem& problem, const Options& options) {
  const std::size_t n = problem.lower.size();
  Errors errors = option_errors(options, static_cast<int>(n),
                                problem.n_constraints + problem.n_cheap_constraints);
  if (problem.upper.size() != n || (!problem.names.empty() && problem.names.size() != n)) {
    errors.push_back(sentence("names, lower and upper have ", problem.names.size(), ", ", n,
                              " and ", problem.upper.size(), " entries; they must be equal"));
    return errors;
  }
  if (problem.n_constraints < 0 || problem.n_cheap_constraints < 0) {
    errors.push_back("n_constraints and n_cheap_constraints must be >= 0");
  }
  if (!problem.evaluate && !problem.evaluate_batch) errors.push_back("evaluate is not set");
  if (problem.n_cheap_constraints > 0 && !problem.cheap_constraints) {
    errors.push_back(sentence("n_cheap_constraints is ", problem.n_cheap_constraints,
                              " but cheap_constraints is not set"));
  }
  check_bounds(problem, n, errors);
  check_starts_within(problem, options, errors);
  return errors;
}

}  // namespace parapet::optimizer
