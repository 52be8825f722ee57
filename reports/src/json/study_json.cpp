#include "study_json.hpp"

#include "design_json.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

Json variable_json(const designs::Variable& variable) {
  Json json{{"name", variable.name}, {"conditional", variable.active_when.has_value()}};
  if (variable.kind == designs::VariableKind::choice) {
    Json options = Json::array();
    for (const designs::Option& option : variable.options) options.push_back(option.name);
    json.emplace("options", std::move(options));
    return json;
  }
  json.update({{"lower", variable.lower},
               {"upper", variable.upper},
               {"integer", variable.kind == designs::VariableKind::integer}});
  return json;
}

/// The list of scenarios as the resolved spec has it.
Json scenarios_json(const designs::StudySpec& spec) {
  const Json& scenarios = spec.resolved.at("scenarios");
  return scenarios.is_object() ? scenarios.at("list") : scenarios;
}

}  // namespace

Json to_json(const StudyFacts& study) {
  Json spacings = Json::array(), variables = Json::array(), objectives = Json::array();
  for (const SpacingCount& one : study.spacings) {
    spacings.push_back({{"spacing_m", one.spacing},
                        {"designs", one.designs},
                        {"feasible", one.feasible},
                        {"failed", one.failed}});
  }
  for (const designs::Variable& one : study.spec.variables) variables.push_back(variable_json(one));
  for (const ObjectiveTerms& one : study.objectives) objectives.push_back(to_json(one));
  return {{"name", study.spec.name},
          {"folder", study.folder},
          {"evaluations", study.evaluations},
          {"ok", study.evaluations - study.failed},
          {"failed", study.failed},
          {"feasible", study.feasible},
          {"simulations", study.simulations},
          {"cpu_time_s", study.cpu_time > 0.0 ? Json(study.cpu_time) : Json(nullptr)},
          {"log_complete", study.log_complete},
          {"counted_spacing_m", study.counted_spacing},
          {"spacings", std::move(spacings)},
          {"variables", std::move(variables)},
          {"objectives", std::move(objectives)},
          {"constraints", study.spec.resolved.at("constraints")},
          {"scenarios", scenarios_json(study.spec)},
          {"method", study.spec.resolved.at("method")}};
}

}  // namespace parapet::reports
