#include "design_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parapet/study/comparable.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::reports {
namespace {

using designs::StudySpec;
using records::EvaluationRecord;

constexpr double active_share = 0.02;    // a margin below this share of the limit is "active"
constexpr double at_bound_share = 0.01;  // of a variable's range

std::string option_of(const designs::Variable& variable, double value) {
  const auto place = static_cast<std::size_t>(std::max(0.0, std::round(value)));
  return place < variable.options.size() ? variable.options[place].name : "?";
}

VariableResult variable_result(const designs::Variable& variable, double value) {
  VariableResult result{.name = variable.name,
                        .value = value,
                        .lower = variable.lower,
                        .upper = variable.upper,
                        .option = {},
                        .options = {}};
  if (variable.kind == designs::VariableKind::choice) {
    result.option = option_of(variable, value);
    for (const designs::Option& option : variable.options) result.options.push_back(option.name);
    return result;
  }
  const double near = at_bound_share * (variable.upper - variable.lower);
  result.at_bound = value - variable.lower <= near   ? Bound::lower
                    : variable.upper - value <= near ? Bound::upper
                                                     : Bound::none;
  return result;
}

ConstraintResult constraint_result(const StudySpec& study,
                                   const records::ConstraintRecord& record) {
  ConstraintResult result{.name = record.name,
                          .metric = {},
                          .expression = {},
                          .statistic = {},
                          .value = record.value,
                          .lower = record.lower,
                          .upper = record.upper,
                          .satisfied = record.satisfied,
                          .margin = record.margin,
                          .margin_percent = {}};
  const auto stated = std::ranges::find(study.constraints, record.name, &designs::Constraint::name);
  if (stated != study.constraints.end()) {
    result.metric = stated->metric;
    result.expression = stated->expression;
    result.statistic =
        statistic_words(study, stated->is_of_design(), stated->statistic, stated->quantile);
  }
  const std::optional<double> limit = study::nearer_limit(record);
  const double size = limit && *limit != 0.0 ? std::abs(*limit) : 1.0;
  result.margin_percent = percent(record.margin, limit);
  result.active = record.satisfied && record.margin && *record.margin <= active_share * size;
  return result;
}

bool has_metric(const EvaluationRecord& record, const std::string& key) {
  const auto found = std::ranges::find(record.metrics, key, &solver::Metric::key);
  return found != record.metrics.end() && found->value;
}

std::vector<ObjectiveResult> objective_results(const StudySpec& study,
                                               const EvaluationRecord& record) {
  std::vector<ObjectiveResult> list;
  for (std::size_t j = 0; j < record.objectives.size(); ++j) {
    const records::ObjectiveRecord& one = record.objectives[j];
    const designs::Objective& stated = study.objectives.at(j);
    // With scenarios the metric may be missing in some of them only: then its mean has a value.
    list.push_back({.terms = terms_of(study, stated),
                    .weight = one.weight,
                    .value = one.value,
                    .absent = one.absent && !has_metric(record, stated.metric)});
  }
  return list;
}

}  // namespace

std::string statistic_words(const StudySpec& study, bool of_design, designs::Statistic statistic,
                            double quantile) {
  if (study.scenarios.size() < 2 || of_design) {
    return statistic == designs::Statistic::probability ? "whether within limits" : "";
  }
  switch (statistic) {
    case designs::Statistic::mean:
      return "mean over the scenarios";
    case designs::Statistic::worst:
      return "worst of the scenarios";
    case designs::Statistic::quantile:
      return fmt::format("met or bettered in {:g} % of the scenarios", 100.0 * quantile);
    case designs::Statistic::probability:
      break;
  }
  return "share of the scenarios within limits";
}

ObjectiveTerms terms_of(const StudySpec& study, const designs::Objective& objective) {
  return {.name = study::objective_name(objective),
          .metric = objective.metric,
          .expression = objective.expression,
          .goal = objective.goal,
          .statistic = statistic_words(study, objective.is_of_design(), objective.statistic,
                                       objective.quantile)};
}

WrittenDesign written_design(const StudySpec& study, const designs::Design& design) {
  WrittenDesign written;
  for (const designs::Variable& variable : study.variables) {
    const auto found = design.find(variable.name);
    if (found == design.end()) continue;
    written.push_back({variable.name, found->second});
    if (variable.kind == designs::VariableKind::choice) {
      written.back().value = option_of(variable, found->second);
    }
  }
  return written;
}

DesignReport design_report(const StudySpec& study, const EvaluationRecord& record) {
  DesignReport report{.id = record.id,
                      .stage = record.stage,
                      .design = written_design(study, record.design),
                      .variables = {},
                      .spacing = record.spacing,
                      .scenarios = {},
                      .objective_scalar = record.objective_scalar,
                      .objectives = objective_results(study, record),
                      .constraints = {},
                      .metrics = record.metrics,
                      .terms = record.terms};
  for (const designs::Variable& variable : study.variables) {
    const auto found = record.design.find(variable.name);
    if (found != record.design.end()) {
      report.variables.push_back(variable_result(variable, found->second));
    }
  }
  for (const records::ScenarioRecord& scenario : record.scenarios) {
    report.scenarios.push_back(scenario.name);
  }
  for (const records::ConstraintRecord& constraint : record.constraints) {
    report.constraints.push_back(constraint_result(study, constraint));
  }
  return report;
}

std::vector<ObjectiveEstimate> estimates_of(const StudySpec& study,
                                            const study::Candidate& candidate) {
  std::vector<ObjectiveEstimate> list;
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    list.push_back({.terms = terms_of(study, study.objectives[j]),
                    .value = candidate.design->objectives.at(j).value,
                    .estimate = {}});
    const bool formula = study.objectives[j].is_of_design();
    if (candidate.estimates != nullptr && !formula) {
      list.back().estimate = candidate.estimates->objectives.at(j);
    }
  }
  return list;
}

std::optional<double> percent(const std::optional<double>& part,
                              const std::optional<double>& whole) {
  if (!part || !whole || *whole == 0.0) return std::nullopt;
  return 100.0 * *part / std::abs(*whole);
}

}  // namespace parapet::reports
