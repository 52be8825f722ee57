#include "parapet/study/bayesian_problem.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "design_formulas.hpp"
#include "parapet/study/goal_quantity.hpp"
#include "parapet/study/knee.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/simulator.hpp"
#include "search_metrics.hpp"

namespace parapet::study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t event_count(const designs::StudySpec& study) {
  return std::max<std::size_t>(1, study.scenarios.size());
}

void add_objectives(const designs::StudySpec& study, SearchMetrics& list, SearchProblem& result) {
  for (const designs::Objective& objective : study.objectives) {
    const std::size_t metric = objective.is_of_design()
                                   ? list.of_design(objective)
                                   : list.of(objective_quantity(study, objective));
    result.problem.objectives.push_back({.metric = metric,
                                         .maximize = objective.goal == designs::Goal::maximize,
                                         .reference = objective.reference});
  }
}

void add_limits(const designs::StudySpec& study, SearchMetrics& list, SearchProblem& result) {
  for (const designs::Constraint& constraint : study.constraints) {
    if (constraint.is_of_design()) continue;
    for (const QuantityLimit& limit : constraint_quantities(study, constraint)) {
      result.problem.limits.push_back({.metric = list.of(limit.quantity),
                                       .lower = limit.lower.value_or(-infinity),
                                       .upper = limit.upper.value_or(infinity),
                                       .satisfied_when_absent = constraint.satisfied_when_absent});
    }
  }
}

void add_levels(const designs::StudySpec& study, SearchProblem& result) {
  result.problem.levels.clear();
  const auto events = static_cast<double>(event_count(study));
  const auto add = [&](double spacing, const std::optional<double>& seconds) {
    result.spacings.push_back(spacing);
    result.problem.levels.push_back(
        {.seconds = events * seconds.value_or(expected_seconds(study, spacing))});
  };
  for (const designs::FidelityLevel& level : study.fidelity) add(level.spacing, level.seconds);
  if (study.fidelity.empty()) {
    add(study.base_case.at("/numerics/spacing_m"_json_pointer).get<double>(), std::nullopt);
  }
}

void add_cheap_constraints(const designs::StudySpec& study, SearchProblem& result) {
  const bool any_formula =
      std::any_of(study.objectives.begin(), study.objectives.end(),
                  [](const designs::Objective& objective) { return objective.is_of_design(); });
  if (expression_limit_count(study) == 0 && !any_formula) return;
  struct Formulas {
    std::vector<std::pair<designs::Constraint, DesignFormula>> limits;
    std::vector<DesignFormula> objectives;
  };
  const auto formulas = std::make_shared<Formulas>();
  const bayesian::Space& space = result.problem.space;
  for (const designs::Constraint& constraint : study.constraints) {
    if (!constraint.is_of_design()) continue;
    formulas->limits.emplace_back(constraint, DesignFormula(study, space, written_out(constraint)));
  }
  for (const designs::Objective& objective : study.objectives) {
    if (!objective.is_of_design()) continue;
    formulas->objectives.emplace_back(study, space, written_out(objective));
  }
  result.problem.cheap_constraints = [formulas](const bayesian::Point& x) {
    std::vector<double> g;
    for (auto& [constraint, formula] : formulas->limits) {
      for (const double one : limit_violations(constraint, formula.value(x))) g.push_back(one);
    }
    for (DesignFormula& formula : formulas->objectives) {
      g.push_back(formula.value(x) ? -1.0 : 1.0);
    }
    return g;
  };
}

}  // namespace

SearchProblem make_search_problem(const designs::StudySpec& study) {
  SearchProblem result;
  result.problem.space = make_space(study);
  SearchMetrics list(study, result);
  add_objectives(study, list, result);
  add_limits(study, list, result);
  add_levels(study, result);
  add_cheap_constraints(study, result);
  return result;
}

bayesian::SearchOptions make_search_options(const designs::StudySpec& study) {
  bayesian::SearchOptions options;
  options.max_evaluations = study.method.max_evaluations;
  // "further" designs: beside the starts
  if (study.method.start_count > 0) {
    options.initial_designs =
        static_cast<int>(study.method.starts.size()) + study.method.start_count;
  }
  for (const designs::Design& start : study.method.starts) {
    options.starts.push_back(to_point(study, start));
  }
  options.seed = study.method.seed;
  options.feasibility_tolerance = feasibility_tolerance;
  options.max_finest = study.method.max_finest_runs / static_cast<double>(event_count(study));
  options.stagnation_evaluations = study.method.stagnation_evaluations;
  options.least_gain = study.method.least_gain;
  // What `parapet recommend` picks where it is told nothing.
  options.recommend = default_pick;
  return options;
}

bayesian::Observation observation(const designs::StudySpec& study, const SearchProblem& problem,
                                  const records::EvaluationRecord& record) {
  bayesian::Observation result;
  result.ok = record.ok;
  result.values.resize(problem.metrics.size());
  const std::vector<Event> events = events_of(record);
  for (std::size_t k = 0; k < problem.metrics.size(); ++k) {
    if (!record.ok || !problem.metrics[k].expression.empty() ||
        problem.problem.metrics[k].is_composed()) {
      continue;
    }
    const QuantityValue found =
        quantity_value(study, problem.metrics[k].quantity, record.design, events);
    result.values[k] = found.value;
    // a run that could not tell is no satisfied limit
    result.ok = result.ok && !found.unknown;
  }
  result.seconds = nominal_seconds(record.particle_steps);
  // A budget of finest runs counts particle steps.
  if (study.method.max_finest_runs > 0.0) return result;
  for (const designs::FidelityLevel& level : study.fidelity) {
    if (level.spacing == record.spacing && level.seconds) {
      result.seconds = *level.seconds * static_cast<double>(event_count(study));
    }
  }
  return result;
}

std::optional<int> level_of(const SearchProblem& problem, double spacing) {
  const auto found = std::find(problem.spacings.begin(), problem.spacings.end(), spacing);
  if (found == problem.spacings.end()) return std::nullopt;
  return static_cast<int>(found - problem.spacings.begin());
}

}  // namespace parapet::study
