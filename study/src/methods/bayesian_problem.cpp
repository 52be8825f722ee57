#include "parapet/study/bayesian_problem.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "design_formulas.hpp"
#include "parapet/solver/metric_catalog.hpp"
#include "parapet/study/knee.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/simulator.hpp"

namespace parapet::study {
namespace {

using designs::Statistic;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t event_count(const designs::StudySpec& study) {
  return std::max<std::size_t>(1, study.scenarios.size());
}

/// What a metric is multiplied by on its way over the events; see make_search_problem.
double noise_factor(const designs::StudySpec& study, const Quantity& quantity) {
  const bool over_events = quantity.event.empty() && !study.scenarios.empty();
  if (quantity.statistic != Statistic::mean || !over_events) return 1.0;
  double squares = 0.0;
  for (const designs::Scenario& scenario : study.scenarios) {
    squares += scenario.weight * scenario.weight;
  }
  return std::sqrt(squares);
}

std::vector<double> known_noise(const designs::StudySpec& study, const Quantity& quantity) {
  std::vector<double> noise;
  if (quantity.statistic == Statistic::probability) return noise;
  for (const designs::FidelityLevel& level : study.fidelity) {
    const auto found = level.noise.find(quantity.metric);
    if (found == level.noise.end()) return {};
    noise.push_back(found->second * noise_factor(study, quantity));
  }
  return noise;
}

/// The values that a metric can have at all, by its definition.
void set_bounds(const Quantity& quantity, bayesian::Metric& metric) {
  if (quantity.statistic == Statistic::probability) {
    metric.least = 0.0;
    metric.greatest = 1.0;
    return;
  }
  if (!quantity.expression.empty()) return;
  if (const auto info = solver::find_metric_info(quantity.metric)) {
    metric.least = info->least;
    metric.greatest = info->greatest;
  }
  if (quantity.value_when_absent) {
    metric.least = std::min(metric.least, *quantity.value_when_absent);
    metric.greatest = std::max(metric.greatest, *quantity.value_when_absent);
  }
}

/// Of an objective or constraint.
template <typename Goal>
const std::string& formula_of(const Goal& goal) {
  return goal.formula.empty() ? goal.expression : goal.formula;
}

/// Of several events their names; of one an empty one, which stands for it.
std::vector<std::string> event_names(const designs::StudySpec& study) {
  std::vector<std::string> names;
  for (const designs::Scenario& scenario : study.scenarios) names.push_back(scenario.name);
  if (names.size() <= 1) names.assign(1, "");
  return names;
}

/// The quantity's expression in each event, and their statistic, from the values of its metrics
/// [n_events * n_metrics], event after event.
std::function<double(const bayesian::Point&, const std::vector<double>&)> expression_over_events(
    const designs::StudySpec& study, const bayesian::Space& space, const Quantity& quantity) {
  std::vector<std::string> names;
  for (const designs::Variable& variable : study.variables) names.push_back(variable.name);
  names.insert(names.end(), quantity.metrics.begin(), quantity.metrics.end());
  std::vector<double> weights;
  for (const designs::Scenario& scenario : study.scenarios) weights.push_back(scenario.weight);
  if (weights.size() <= 1) weights.assign(1, 1.0);
  const auto formula = std::make_shared<designs::Formula>(quantity.expression, names);
  const std::size_t n_metrics = quantity.metrics.size();
  return [space, quantity, weights, formula, n_metrics](const bayesian::Point& x,
                                                        const std::vector<double>& inputs) {
    std::vector<double> symbols = space.canonical(x);
    for (double& one : symbols) one = std::isnan(one) ? 0.0 : one;  // not active
    const std::size_t n_variables = symbols.size();
    symbols.resize(n_variables + n_metrics);
    std::vector<double> values;
    for (std::size_t event = 0; event < weights.size(); ++event) {
      for (std::size_t m = 0; m < n_metrics; ++m) {
        symbols[n_variables + m] = inputs[event * n_metrics + m];
      }
      values.push_back(formula->value(symbols));
      if (!std::isfinite(values.back())) return std::numeric_limits<double>::quiet_NaN();
    }
    const bool alone = values.size() == 1 && quantity.statistic != Statistic::probability;
    return alone ? values.front() : statistic_of(quantity, values, weights);
  };
}

/// Collects metrics, each once.
class MetricList {
 public:
  MetricList(const designs::StudySpec& study, SearchProblem& result)
      : study_(study), result_(result), catalog_(solver::metric_catalog(barrier_count(study))) {}

  std::size_t of(Quantity quantity) {
    // Over a distribution the metrics are modelled by design and event (EventModel), and what is
    // told of an expression is its statistic.
    const bool over_distribution = !study_.event_variables.empty() && study_.scenarios.size() > 1;
    if (!quantity.expression.empty() && !over_distribution) return of_metrics(std::move(quantity));
    // Where there is always a value, two goals differ in nothing by what they say of its absence.
    if (quantity.expression.empty() && !may_not_exist(quantity.metric)) {
      quantity.absent_is_good = false;
      quantity.value_when_absent.reset();
    }
    auto& metrics = result_.metrics;
    for (std::size_t k = 0; k < metrics.size(); ++k) {
      if (metrics[k].expression.empty() && metrics[k].quantity == quantity) return k;
    }
    bayesian::Metric metric;
    metric.name = quantity_name(quantity);
    metric.known_noise = known_noise(study_, quantity);
    set_bounds(quantity, metric);
    metrics.emplace_back().quantity = quantity;
    result_.problem.metrics.push_back(std::move(metric));
    return metrics.size() - 1;
  }

  std::size_t of_design(const designs::Objective& objective) {
    bayesian::Metric metric;
    metric.name = objective_name(objective);
    const auto formula =
        std::make_shared<DesignFormula>(study_, result_.problem.space, formula_of(objective));
    metric.exact = [formula](const bayesian::Point& x) {
      return formula->value(x).value_or(std::numeric_limits<double>::quiet_NaN());
    };
    SearchMetric& added = result_.metrics.emplace_back();
    added.expression = formula_of(objective);
    result_.problem.metrics.push_back(std::move(metric));
    return result_.metrics.size() - 1;
  }

 private:
  /// An expression of metrics: the surrogates model each of these, in each event.
  std::size_t of_metrics(Quantity quantity) {
    for (std::size_t k = 0; k < result_.metrics.size(); ++k) {
      if (result_.metrics[k].quantity == quantity) return k;
    }
    bayesian::Composition composition;
    for (const std::string& event : event_names(study_)) {
      for (const std::string& key : quantity.metrics) {
        const auto absent = quantity.values_when_absent.find(key);
        Quantity input{.metric = key, .lower = {}, .upper = {}, .value_when_absent = {}};
        input.event = event;
        if (absent != quantity.values_when_absent.end()) input.value_when_absent = absent->second;
        composition.inputs.push_back(of(input));
      }
    }
    composition.value = expression_over_events(study_, result_.problem.space, quantity);
    bayesian::Metric metric;
    metric.name = quantity_name(quantity);
    metric.composition = std::move(composition);
    result_.metrics.emplace_back().quantity = std::move(quantity);
    result_.problem.metrics.push_back(std::move(metric));
    return result_.metrics.size() - 1;
  }

  static int barrier_count(const designs::StudySpec& study) {
    const auto found = study.base_case.find("barriers");
    return found == study.base_case.end() ? 0 : static_cast<int>(found->size());
  }

  bool may_not_exist(const std::string& key) const {
    const auto found = std::find_if(catalog_.begin(), catalog_.end(),
                                    [&](const auto& info) { return info.key == key; });
    return found == catalog_.end() || found->may_not_exist;
  }

  const designs::StudySpec& study_;
  SearchProblem& result_;
  std::vector<solver::MetricInfo> catalog_;
};

void add_objectives(const designs::StudySpec& study, MetricList& list, SearchProblem& result) {
  for (const designs::Objective& objective : study.objectives) {
    const std::size_t metric = objective.is_of_design()
                                   ? list.of_design(objective)
                                   : list.of(objective_quantity(study, objective));
    result.problem.objectives.push_back({.metric = metric,
                                         .maximize = objective.goal == designs::Goal::maximize,
                                         .reference = objective.reference});
  }
}

void add_limits(const designs::StudySpec& study, MetricList& list, SearchProblem& result) {
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
    formulas->limits.emplace_back(constraint, DesignFormula(study, space, formula_of(constraint)));
  }
  for (const designs::Objective& objective : study.objectives) {
    if (!objective.is_of_design()) continue;
    formulas->objectives.emplace_back(study, space, formula_of(objective));
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

bayesian::Space make_space(const designs::StudySpec& study) {
  std::vector<bayesian::Variable> variables;
  for (const designs::Variable& variable : study.variables) {
    bayesian::Variable one;
    one.name = variable.name;
    one.lower = variable.lower;
    one.upper = variable.upper;
    switch (variable.kind) {
      case designs::VariableKind::continuous:
        one.kind = bayesian::VariableKind::continuous;
        break;
      case designs::VariableKind::integer:
        one.kind = bayesian::VariableKind::integer;
        break;
      case designs::VariableKind::choice:
        one.kind = bayesian::VariableKind::choice;
        break;
    }
    if (variable.active_when) {
      bayesian::Condition condition;
      while (condition.choice < study.variables.size() &&
             study.variables[condition.choice].name != variable.active_when->choice) {
        ++condition.choice;
      }
      condition.options = variable.active_when->options;
      one.active_when = std::move(condition);
    }
    variables.push_back(std::move(one));
  }
  return bayesian::Space(std::move(variables));
}

SearchProblem make_search_problem(const designs::StudySpec& study) {
  SearchProblem result;
  result.problem.space = make_space(study);
  MetricList list(study, result);
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

bayesian::Point to_point(const designs::StudySpec& study, const designs::Design& design) {
  bayesian::Point point;
  for (const designs::Variable& variable : study.variables) {
    const auto found = design.find(variable.name);
    point.push_back(found == design.end() ? std::numeric_limits<double>::quiet_NaN()
                                          : found->second);
  }
  return point;
}

designs::Design to_design(const designs::StudySpec& study, const bayesian::Space& space,
                          const bayesian::Point& point) {
  const bayesian::Point canonical = space.canonical(point);
  designs::Design design;
  for (std::size_t i = 0; i < canonical.size(); ++i) {
    if (std::isnan(canonical[i])) continue;
    design[study.variables[i].name] = canonical[i] + 0.0;  // -0 and 0 are one design
  }
  return design;
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
