#include "parapet/study/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

using designs::Statistic;

/// A metric's value under one event; `value` empty: at the end that absent_is_good says, and at the
/// bad end where it is unknown.
struct Weighted {
  std::optional<double> value;
  double weight = 1.0;
  bool unknown = false;  // there is none because the run was too short or too coarse to tell
};

const solver::Metric* find_metric(const Event& event, const std::string& key) {
  const auto found = std::find_if(event.metrics.begin(), event.metrics.end(),
                                  [&](const solver::Metric& metric) { return metric.key == key; });
  return found == event.metrics.end() ? nullptr : &*found;
}

bool is_unknown(solver::Absence absence) {
  return absence == solver::Absence::run_too_short || absence == solver::Absence::too_coarse;
}

/// The values by event; says in `result` whether and why one is absent.
std::vector<Weighted> weighted_values(const Quantity& quantity, const std::vector<Event>& events,
                                      QuantityValue& result) {
  std::vector<Weighted> values;
  for (const Event& event : events) {
    const solver::Metric* metric = find_metric(event, quantity.metric);
    Weighted one{.value = std::nullopt, .weight = event.weight};
    if (metric != nullptr && metric->value && std::isfinite(*metric->value)) {
      one.value = metric->value;
    } else {
      if (!result.absent) {
        result.reason = metric == nullptr || metric->absent_reason.empty()
                            ? std::string("the simulation does not give it")
                            : metric->absent_reason;
        if (!event.name.empty()) result.reason += " (" + event.name + ")";
      }
      result.absent = true;
      one.unknown = metric != nullptr && is_unknown(metric->absence);
      if (!one.unknown) one.value = quantity.value_when_absent;
    }
    values.push_back(one);
  }
  return values;
}

bool is_good(const Quantity& quantity, const Weighted& without_value) {
  return quantity.absent_is_good && !without_value.unknown;
}

std::optional<double> mean(const Quantity& quantity, const std::vector<Weighted>& values) {
  // One event's value keeps its bits.
  if (values.size() == 1) return values.front().value;
  double sum = 0.0, weight = 0.0, all = 0.0;
  bool complete = true;
  for (const Weighted& one : values) {
    all += one.weight;
    complete = complete && one.value;
    if (!one.value && !is_good(quantity, one)) return std::nullopt;
    if (!one.value) continue;
    sum += one.weight * *one.value;
    weight += one.weight;
  }
  if (!(weight > 0.0)) return std::nullopt;
  return complete && all == 1.0 ? sum : sum / weight;
}

std::optional<double> worst(const Quantity& quantity, const std::vector<Weighted>& values) {
  std::optional<double> result;
  for (const Weighted& one : values) {
    if (!one.value) {
      if (!is_good(quantity, one)) return std::nullopt;
      continue;
    }
    if (!result || (quantity.high_is_good ? *one.value < *result : *one.value > *result)) {
      result = one.value;
    }
  }
  return result;
}

/// The event, from the good end, up to which the weights add up to the quantile.
Weighted quantile(const Quantity& quantity, std::vector<Weighted> values) {
  // Weights such as 1/8 eight times add up to the quantile 0.75 exactly or nearly so.
  constexpr double rounding = 1e-12;
  std::stable_sort(values.begin(), values.end(), [&](const Weighted& a, const Weighted& b) {
    const auto rank = [&](const Weighted& one) {  // of the good end, the values, the bad end
      return one.value ? 1 : is_good(quantity, one) ? 0 : 2;
    };
    if (!a.value || !b.value) return rank(a) < rank(b);
    return quantity.high_is_good ? *a.value > *b.value : *a.value < *b.value;
  });
  double sum = 0.0;
  for (const Weighted& one : values) {
    sum += one.weight;
    if (sum >= quantity.quantile - rounding) return one;
  }
  return values.empty() ? Weighted{} : values.back();
}

double probability(const Quantity& quantity, const std::vector<Weighted>& values) {
  double within = 0.0, all = 0.0;
  for (const Weighted& one : values) {
    all += one.weight;
    const bool good = one.value ? (!quantity.lower || *one.value >= *quantity.lower) &&
                                      (!quantity.upper || *one.value <= *quantity.upper)
                                : is_good(quantity, one);
    if (good) within += one.weight;
  }
  return all > 0.0 ? within / all : 0.0;
}

}  // namespace

QuantityValue quantity_value(const Quantity& quantity, const std::vector<Event>& events) {
  if (!quantity.event.empty()) {
    const auto one = std::find_if(events.begin(), events.end(),
                                  [&](const Event& event) { return event.name == quantity.event; });
    Quantity alone = quantity;
    alone.event.clear();
    if (one == events.end()) return {.value = {}, .reason = "there is no such event"};
    return quantity_value(alone,
                          {Event{.name = one->name, .weight = 1.0, .metrics = one->metrics}});
  }
  QuantityValue result;
  const std::vector<Weighted> values = weighted_values(quantity, events, result);
  switch (quantity.statistic) {
    case Statistic::mean:
      result.value = mean(quantity, values);
      break;
    case Statistic::worst:
      result.value = worst(quantity, values);
      break;
    case Statistic::quantile: {
      const Weighted place = quantile(quantity, values);
      result.value = place.value;
      result.unknown = place.unknown;
      return result;
    }
    case Statistic::probability:
      result.value = probability(quantity, values);
      break;
  }
  result.unknown = !result.value && std::any_of(values.begin(), values.end(),
                                                [](const Weighted& one) { return one.unknown; });
  return result;
}

solver::Metric expression_metric(const designs::StudySpec& study, const Quantity& quantity,
                                 const designs::Design& design,
                                 const std::vector<solver::Metric>& metrics) {
  solver::Metric result{.key = quantity.metric, .value = {}, .absent_reason = {}};
  const Event event{.name = "", .weight = 1.0, .metrics = metrics};
  designs::Design symbols = design;
  for (const std::string& key : quantity.metrics) {
    const auto stated = quantity.values_when_absent.find(key);
    const QuantityValue found =
        quantity_value({.metric = key,
                        .lower = {},
                        .upper = {},
                        .value_when_absent = stated == quantity.values_when_absent.end()
                                                 ? std::nullopt
                                                 : std::optional(stated->second)},
                       {event});
    if (!found.value) {
      result.absent_reason = key + ": " + found.reason;
      result.absence =
          found.unknown ? solver::Absence::run_too_short : solver::Absence::does_not_exist;
      return result;
    }
    symbols[key] = *found.value;
  }
  result.value = formula_value(study, quantity.expression, symbols);
  if (!result.value) {
    result.absent_reason = "the expression has no finite value";
    result.absence = solver::Absence::does_not_exist;
  }
  return result;
}

QuantityValue quantity_value(const designs::StudySpec& study, const Quantity& quantity,
                             const designs::Design& design, const std::vector<Event>& events) {
  if (quantity.expression.empty()) return quantity_value(quantity, events);
  std::vector<Event> evaluated;
  for (const Event& event : events) {
    evaluated.push_back({.name = event.name,
                         .weight = event.weight,
                         .metrics = {expression_metric(study, quantity, design, event.metrics)}});
  }
  return quantity_value(quantity, evaluated);
}

double statistic_of(const Quantity& quantity, const std::vector<double>& values,
                    const std::vector<double>& weights) {
  std::vector<Weighted> all;
  for (std::size_t k = 0; k < values.size(); ++k) {
    all.push_back({.value = values[k], .weight = weights[k]});
  }
  switch (quantity.statistic) {
    case Statistic::mean:
      return mean(quantity, all).value();
    case Statistic::worst:
      return worst(quantity, all).value();
    case Statistic::quantile:
      return quantile(quantity, std::move(all)).value.value();
    case Statistic::probability:
      break;
  }
  return probability(quantity, all);
}

std::string quantity_name(const Quantity& quantity) {
  if (!quantity.event.empty()) return quantity.metric + " (" + quantity.event + ")";
  switch (quantity.statistic) {
    case Statistic::mean:
      return quantity.metric;
    case Statistic::worst:
      return fmt::format("{} ({} value)", quantity.metric,
                         quantity.high_is_good ? "lowest" : "highest");
    case Statistic::quantile:
      return fmt::format("{} ({:g} % of the events {} or better)", quantity.metric,
                         100.0 * quantity.quantile, quantity.high_is_good ? "so high" : "so low");
    case Statistic::probability:
      break;
  }
  const std::string lower = quantity.lower ? fmt::format("{:g} <= ", *quantity.lower) : "";
  const std::string upper = quantity.upper ? fmt::format(" <= {:g}", *quantity.upper) : "";
  return "P(" + lower + quantity.metric + upper + ")";
}

std::vector<Event> events_of(const records::EvaluationRecord& record) {
  if (record.scenarios.empty()) return {{"", 1.0, record.metrics}};
  std::vector<Event> events;
  for (const records::ScenarioRecord& scenario : record.scenarios) {
    events.push_back({scenario.name, scenario.weight, scenario.metrics});
  }
  return events;
}

std::vector<solver::Metric> mean_metrics(const std::vector<Event>& events) {
  if (events.empty()) return {};
  if (events.size() == 1) return events.front().metrics;
  std::vector<solver::Metric> means;
  for (const Event& event : events) {
    for (const solver::Metric& metric : event.metrics) {
      const bool known = std::any_of(means.begin(), means.end(), [&](const solver::Metric& mean) {
        return mean.key == metric.key;
      });
      if (known) continue;
      const QuantityValue value = quantity_value({.metric = metric.key,
                                                  .lower = {},
                                                  .upper = {},
                                                  .value_when_absent = {},
                                                  .absent_is_good = true},
                                                 events);
      solver::Metric mean{.key = metric.key, .value = value.value, .absent_reason = {}};
      if (!mean.value) {
        mean.absent_reason = value.reason;
        mean.absence =
            value.unknown ? solver::Absence::run_too_short : solver::Absence::does_not_exist;
      }
      means.push_back(std::move(mean));
    }
  }
  return means;
}

}  // namespace parapet::study
