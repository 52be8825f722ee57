#include "design_json.hpp"

#include <cmath>

#include "key_text.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

Json bound_json(Bound bound) {
  if (bound == Bound::none) return nullptr;
  return bound == Bound::lower ? "lower" : "upper";
}

Json variable_json(const VariableResult& variable) {
  if (!variable.options.empty()) {
    return {{"name", variable.name},
            {"option", variable.option},
            {"options", variable.options},
            {"at_bound", nullptr}};
  }
  return {{"name", variable.name},
          {"value", variable.value},
          {"lower", variable.lower},
          {"upper", variable.upper},
          {"at_bound", bound_json(variable.at_bound)}};
}

Json objective_json(const ObjectiveResult& objective) {
  Json json = to_json(objective.terms);
  json.update({{"weight", objective.weight},
               {"value", optional_json(objective.value)},
               {"absent", objective.absent}});
  return json;
}

Json constraint_json(const ConstraintResult& constraint) {
  Json json{{"name", constraint.name}};
  if (!constraint.metric.empty()) json.emplace("metric", constraint.metric);
  if (!constraint.expression.empty()) json.emplace("expression", constraint.expression);
  if (!constraint.statistic.empty()) json.emplace("statistic", constraint.statistic);
  json.update({{"value", optional_json(constraint.value)},
               {"lower", optional_json(constraint.lower)},
               {"upper", optional_json(constraint.upper)},
               {"satisfied", constraint.satisfied},
               {"margin", optional_json(constraint.margin)},
               {"margin_percent", optional_json(constraint.margin_percent)},
               {"active", constraint.active}});
  return json;
}

template <typename List, typename ToJson>
Json list_json(const List& list, ToJson to) {
  Json json = Json::array();
  for (const auto& one : list) json.push_back(to(one));
  return json;
}

}  // namespace

Json optional_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json to_json(const WrittenDesign& design) {
  Json json = Json::object();
  for (const WrittenVariable& variable : design) {
    std::visit([&](const auto& value) { json[variable.name] = value; }, variable.value);
  }
  return json;
}

Json to_json(const ObjectiveTerms& terms) {
  Json json{{"name", terms.name}, {"metric", unit_key(terms)}, {"goal", goal_word(terms.goal)}};
  if (!terms.expression.empty()) json.emplace("expression", terms.expression);
  if (!terms.statistic.empty()) json.emplace("statistic", terms.statistic);
  return json;
}

Json estimates_json(const std::vector<ObjectiveEstimate>& estimates) {
  return list_json(estimates, [](const ObjectiveEstimate& one) {
    Json json = to_json(one.terms);
    json.update({{"value", optional_json(one.value)},
                 {"estimate", optional_json(one.estimate.median)},
                 {"lower_95", optional_json(one.estimate.lower_95)},
                 {"upper_95", optional_json(one.estimate.upper_95)}});
    return json;
  });
}

Json to_json(const DesignReport& design) {
  Json json{{"id", design.id},
            {"stage", design.stage},
            {"design", to_json(design.design)},
            {"variables", list_json(design.variables, variable_json)},
            {"spacing_m", design.spacing}};
  if (!design.scenarios.empty()) json.emplace("scenarios", design.scenarios);
  for (const records::TermRecord& term : design.terms) {
    json["terms"][term.name] = optional_json(term.value);
  }
  Json metrics = Json::object(), absent = Json::object();
  for (const solver::Metric& metric : design.metrics) {
    metrics[metric.key] = optional_json(metric.value);
    if (!metric.value) absent[metric.key] = metric.absent_reason;
  }
  json.update({{"objective_scalar", optional_json(design.objective_scalar)},
               {"objectives", list_json(design.objectives, objective_json)},
               {"constraints", list_json(design.constraints, constraint_json)},
               {"metrics", std::move(metrics)},
               {"metrics_absent", std::move(absent)}});
  return json;
}

}  // namespace parapet::reports
