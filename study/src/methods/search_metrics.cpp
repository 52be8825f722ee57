#include "search_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "design_formulas.hpp"
#include "parapet/study/goal_quantity.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

using designs::Statistic;

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

int barrier_count(const designs::StudySpec& study) {
  const auto found = study.base_case.find("barriers");
  return found == study.base_case.end() ? 0 : static_cast<int>(found->size());
}

}  // namespace

SearchMetrics::SearchMetrics(const designs::StudySpec& study, SearchProblem& result)
    : study_(study), result_(result), catalog_(solver::metric_catalog(barrier_count(study))) {}

std::size_t SearchMetrics::of(Quantity quantity) {
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

std::size_t SearchMetrics::of_design(const designs::Objective& objective) {
  bayesian::Metric metric;
  metric.name = objective_name(objective);
  const auto formula =
      std::make_shared<DesignFormula>(study_, result_.problem.space, written_out(objective));
  metric.exact = [formula](const bayesian::Point& x) {
    return formula->value(x).value_or(std::numeric_limits<double>::quiet_NaN());
  };
  SearchMetric& added = result_.metrics.emplace_back();
  added.expression = written_out(objective);
  result_.problem.metrics.push_back(std::move(metric));
  return result_.metrics.size() - 1;
}

std::size_t SearchMetrics::of_metrics(Quantity quantity) {
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

bool SearchMetrics::may_not_exist(const std::string& key) const {
  const auto found = std::find_if(catalog_.begin(), catalog_.end(),
                                  [&](const auto& info) { return info.key == key; });
  return found == catalog_.end() || found->may_not_exist;
}

}  // namespace parapet::study
