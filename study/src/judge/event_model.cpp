#include "parapet/study/event_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "parapet/solver/metric_catalog.hpp"
#include "parapet/study/goal_quantity.hpp"

namespace parapet::study {
namespace {

constexpr double normal_975 = 1.959963984540054;  // 97.5 % of the standard normal
constexpr std::size_t fewest_simulations = 8;

/// Scaled so that the middle 96 % of the draws lie in 0 .. 1: a surrogate's inputs are of that
/// size.
double scaled(double value, const designs::EventVariable& variable) {
  std::vector<double> sorted = variable.draws;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t tail = sorted.size() / 50;
  const double lower = sorted[tail], upper = sorted[sorted.size() - 1 - tail];
  return upper > lower ? (value - lower) / (upper - lower) : 0.5;
}

Eigen::MatrixXd scaled_events(const designs::StudySpec& study, bool draws) {
  const auto& variables = study.event_variables;
  const std::size_t n = draws ? designs::n_event_draws : study.scenarios.size();
  Eigen::MatrixXd result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(variables.size()));
  for (std::size_t j = 0; j < variables.size(); ++j) {
    const double zero = scaled(0.0, variables[j]), slope = scaled(1.0, variables[j]) - zero;
    const std::vector<double>& values = draws ? variables[j].draws : variables[j].at;
    for (std::size_t k = 0; k < n; ++k) {
      result(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) = zero + slope * values[k];
    }
  }
  return result;
}

/// The metrics that a quantity hangs on.
std::vector<EventModel::Key> keys_of(const Quantity& quantity) {
  if (quantity.expression.empty()) return {{quantity.metric, quantity.value_when_absent}};
  std::vector<EventModel::Key> keys;
  for (const std::string& metric : quantity.metrics) {
    const auto stated = quantity.values_when_absent.find(metric);
    keys.emplace_back(metric, stated == quantity.values_when_absent.end()
                                  ? std::nullopt
                                  : std::optional(stated->second));
  }
  return keys;
}

/// Between what a metric can be at all.
double possible(double value, const EventModel::Key& key) {
  const auto info = solver::find_metric_info(key.first);
  double least = info ? info->least : -std::numeric_limits<double>::infinity();
  double greatest = info ? info->greatest : std::numeric_limits<double>::infinity();
  if (key.second) least = std::min(least, *key.second);
  if (key.second) greatest = std::max(greatest, *key.second);
  return std::clamp(value, least, greatest);
}

surrogate::Data data_of(const std::vector<Eigen::RowVectorXd>& inputs,
                        const std::vector<double>& values) {
  surrogate::Data data;
  data.inputs.resize(static_cast<Eigen::Index>(inputs.size()), inputs.front().size());
  data.values.resize(data.inputs.rows());
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    data.inputs.row(static_cast<Eigen::Index>(k)) = inputs[k];
    data.values[static_cast<Eigen::Index>(k)] = values[k];
  }
  return data;
}

}  // namespace

bool has_distribution(const designs::StudySpec& study) {
  return !study.event_variables.empty() && study.scenarios.size() > 1;
}

std::vector<Quantity> event_quantities(const designs::StudySpec& study) {
  std::vector<Quantity> result;
  for (const designs::Objective& objective : study.objectives) {
    if (!objective.is_of_design()) result.push_back(objective_quantity(study, objective));
  }
  for (const designs::Constraint& constraint : study.constraints) {
    if (constraint.is_of_design()) continue;
    for (const QuantityLimit& limit : constraint_quantities(study, constraint)) {
      result.push_back(limit.quantity);
    }
  }
  return result;
}

EventModel::EventModel(const designs::StudySpec& study,
                       const std::vector<records::EvaluationRecord>& records, int starts)
    : study_(study), space_(make_space(study)) {
  if (!has_distribution(study)) return;
  layout_ = space_.layout();
  const int n_groups = layout_.n_groups();
  for (std::size_t j = 0; j < study.event_variables.size(); ++j) {
    layout_.group.push_back(n_groups + static_cast<int>(j));
  }
  events_ = scaled_events(study, false);
  draws_ = scaled_events(study, true);
  collect(records);
  fit(starts);
}

Eigen::MatrixXd EventModel::inputs(const designs::Design& design, std::size_t n_events) const {
  const Eigen::RowVectorXd own = space_.features(to_point(study_, design));
  const Eigen::MatrixXd& events = n_events == 0 ? events_ : draws_;
  const Eigen::Index n = n_events == 0 ? events.rows() : static_cast<Eigen::Index>(n_events);
  Eigen::MatrixXd result(n, own.size() + events.cols());
  for (Eigen::Index k = 0; k < n; ++k) result.row(k) << own, events.row(k);
  return result;
}

void EventModel::collect(const std::vector<records::EvaluationRecord>& records) {
  const double spacing = designs::finest_spacing(study_);
  for (const records::EvaluationRecord& record : records) {
    if (!record.ok || record.spacing != spacing ||
        record.scenarios.size() != study_.scenarios.size() ||
        !designs::check_design(study_, record.design, "").empty()) {
      continue;
    }
    ++n_designs_;
    const Eigen::MatrixXd at = inputs(record.design, 0);
    const std::vector<Event> events = events_of(record);
    for (const Quantity& quantity : event_quantities(study_)) {
      for (const Key& key : keys_of(quantity)) {
        auto& rows = rows_[key];
        if (rows.size() >= n_designs_ * events.size()) continue;  // shared with another quantity
        for (std::size_t e = 0; e < events.size(); ++e) {
          Quantity one{
              .metric = key.first, .lower = {}, .upper = {}, .value_when_absent = key.second};
          const QuantityValue found = quantity_value(one, {events[e]});
          const double value = found.value.value_or(std::numeric_limits<double>::quiet_NaN());
          rows.push_back({e, at.row(static_cast<Eigen::Index>(e)), value});
        }
      }
    }
  }
  for (auto& [key, rows] : rows_) {
    std::erase_if(rows, [](const Row& row) { return std::isnan(row.value); });
  }
}

void EventModel::fit(int starts) {
  for (const auto& [key, rows] : rows_) {
    if (rows.size() < fewest_simulations) continue;
    std::vector<Eigen::RowVectorXd> at;
    std::vector<double> values;
    for (const Row& row : rows) {
      at.push_back(row.input);
      values.push_back(row.value);
    }
    surrogate::FitOptions options;
    options.seed = study_.method.seed;
    options.starts = starts;
    processes_.emplace(key, surrogate::GaussianProcess::fit(layout_, data_of(at, values), options));
  }
}

/// `values` [n_keys] of [n_events].
std::optional<double> EventModel::of_events(const Quantity& quantity, const designs::Design& design,
                                            const std::vector<Eigen::VectorXd>& values) const {
  const auto n = static_cast<std::size_t>(values.front().size());
  const std::vector<double> weights(n, 1.0 / static_cast<double>(n));
  std::vector<double> results(n);
  if (quantity.expression.empty()) {
    for (std::size_t e = 0; e < n; ++e) results[e] = values[0][static_cast<Eigen::Index>(e)];
    return statistic_of(quantity, results, weights);
  }
  std::vector<std::string> names;
  std::vector<double> symbols;
  for (const designs::Variable& variable : study_.variables) {
    names.push_back(variable.name);
    const auto found = design.find(variable.name);
    symbols.push_back(found == design.end() ? 0.0 : found->second);
  }
  const std::size_t n_variables = names.size();
  names.insert(names.end(), quantity.metrics.begin(), quantity.metrics.end());
  symbols.resize(names.size());
  designs::Formula formula(quantity.expression, names);
  for (std::size_t e = 0; e < n; ++e) {
    for (std::size_t m = 0; m < values.size(); ++m) {
      symbols[n_variables + m] = values[m][static_cast<Eigen::Index>(e)];
    }
    results[e] = formula.value(symbols);
    if (!std::isfinite(results[e])) return std::nullopt;
  }
  return statistic_of(quantity, results, weights);
}

std::optional<double> EventModel::value(const Quantity& quantity, const designs::Design& design,
                                        std::size_t n_events) const {
  std::vector<Eigen::VectorXd> means;
  for (const Key& key : keys_of(quantity)) {
    const auto found = processes_.find(key);
    if (found == processes_.end()) return std::nullopt;
    means.push_back(found->second.predict_mean(inputs(design, n_events)).unaryExpr([&](double z) {
      return possible(found->second.from_model(z), key);
    }));
  }
  return of_events(quantity, design, means);
}

void revise_statistics(const designs::StudySpec& study, const SearchProblem& problem,
                       const std::vector<records::EvaluationRecord>& told,
                       bayesian::Search& search) {
  constexpr std::size_t n_events = 500;  // a quarter of what results state: the search asks often
  if (!has_distribution(study)) return;
  const EventModel model(study, told, 1);
  if (model.n_designs() < fewest_event_designs) return;
  const double spacing = designs::finest_spacing(study);
  std::vector<std::vector<std::optional<double>>> values;
  for (const records::EvaluationRecord& record : told) {
    values.push_back(observation(study, problem, record).values);
    if (!record.ok || record.spacing != spacing) continue;
    for (std::size_t k = 0; k < problem.metrics.size(); ++k) {
      const Quantity& quantity = problem.metrics[k].quantity;
      if (!problem.metrics[k].expression.empty() || !values.back()[k]) continue;
      if (const auto better = model.value(quantity, record.design, n_events)) {
        values.back()[k] = better;
      }
    }
  }
  search.revise(values);
}

std::optional<DistributionStatistic> EventModel::statistic(const Quantity& quantity,
                                                           const designs::Design& design) const {
  // Of the whole, and of fewer events together, whose draws show what is left open.
  constexpr std::size_t fewer_events = 200;
  constexpr int n_samples = 100;
  const std::vector<Key> keys = keys_of(quantity);
  std::vector<Eigen::VectorXd> means, fewer_means;
  std::vector<Eigen::MatrixXd> samples;  // [n_samples, fewer_events]
  for (std::size_t m = 0; m < keys.size(); ++m) {
    const auto found = processes_.find(keys[m]);
    if (found == processes_.end()) return std::nullopt;
    const surrogate::GaussianProcess& process = found->second;
    const auto unit = [&](double z) { return possible(process.from_model(z), keys[m]); };
    means.push_back(process.predict_mean(inputs(design, designs::n_event_draws)).unaryExpr(unit));
    fewer_means.push_back(means.back().head(fewer_events));
    const surrogate::PosteriorSamples drawn(process, inputs(design, fewer_events), n_samples,
                                            study_.method.seed + 7919 * m);
    samples.push_back(drawn.values().unaryExpr(unit));
  }
  const auto value = of_events(quantity, design, means);
  const auto middle = of_events(quantity, design, fewer_means);
  if (!value || !middle) return std::nullopt;
  std::vector<double> drawn;
  for (int s = 0; s < n_samples; ++s) {
    std::vector<Eigen::VectorXd> one;
    for (const Eigen::MatrixXd& all : samples) one.emplace_back(all.row(s).transpose());
    if (const auto of_draw = of_events(quantity, design, one)) drawn.push_back(*of_draw);
  }
  DistributionStatistic result{.value = *value, .lower_95 = *value, .upper_95 = *value};
  if (drawn.empty()) return result;
  std::sort(drawn.begin(), drawn.end());
  const auto at = [&](double share) {
    return drawn[static_cast<std::size_t>(
        std::lround(share * static_cast<double>(drawn.size() - 1)))];
  };
  // From the statistic of the fewer events to that of all. Means vary less from event to event than
  // the metric does: the draws move a quantile outwards.
  result.value = *value + at(0.5) - *middle;
  result.lower_95 = *value + at(0.025) - *middle;
  result.upper_95 = *value + at(0.975) - *middle;
  for (double* one : {&result.value, &result.lower_95, &result.upper_95}) {
    if (quantity.statistic == designs::Statistic::probability) {
      *one = std::clamp(*one, 0.0, 1.0);
    } else if (quantity.expression.empty()) {
      *one = possible(*one, keys[0]);
    }
  }
  return result;
}

LeaveOneEventOut EventModel::leave_one_event_out(const Key& key) const {
  const std::vector<Row>& rows = rows_.at(key);
  const surrogate::GaussianProcess& whole = processes_.at(key);
  double squares = 0.0, sum = 0.0, sum_squares = 0.0, within = 0.0, n = 0.0;
  for (std::size_t event = 0; event < study_.scenarios.size(); ++event) {
    std::vector<Eigen::RowVectorXd> at, left_out;
    std::vector<double> values, true_values;
    for (const Row& row : rows) {
      (row.event == event ? left_out : at).push_back(row.input);
      (row.event == event ? true_values : values).push_back(row.value);
    }
    if (at.empty() || left_out.empty()) continue;
    // The parameters are those of all events: what is tested is what the others say of this one.
    surrogate::FitOptions options;
    options.warm_start = whole.parameters();
    options.transform = whole.parameters().transform.kind;
    options.keep_parameters = true;
    const auto others = surrogate::GaussianProcess::fit(layout_, data_of(at, values), options);
    const surrogate::Prediction prediction = others.predict(data_of(left_out, true_values).inputs);
    for (std::size_t k = 0; k < true_values.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      const double value = possible(others.from_model(prediction.mean[row]), key);
      const double deviation =
          std::sqrt(std::max(0.0, prediction.variance[row]) + others.noise() * others.noise());
      const double z = others.to_model(true_values[k]) - prediction.mean[row];
      squares += (value - true_values[k]) * (value - true_values[k]);
      sum += true_values[k];
      sum_squares += true_values[k] * true_values[k];
      within += std::abs(z) <= normal_975 * deviation ? 1.0 : 0.0;
      n += 1.0;
    }
  }
  if (!(n > 0.0)) return {};
  const double variance = sum_squares - sum * sum / n;
  return {.rmse = std::sqrt(squares / n),
          .q_squared = variance > 0.0 ? 1.0 - squares / variance : 0.0,
          .coverage_95 = within / n};
}

}  // namespace parapet::study
