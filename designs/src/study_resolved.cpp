#include "study_parts.hpp"

namespace parapet::designs {
namespace {

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json variables_json(const std::vector<Variable>& variables) {
  Json json = Json::object();
  for (const Variable& variable : variables) {
    json[variable.name] = {
        {"lower", variable.lower}, {"upper", variable.upper}, {"targets", variable.targets}};
  }
  return json;
}

Json objectives_json(const std::vector<Objective>& objectives) {
  Json json = Json::array();
  for (const Objective& objective : objectives) {
    json.push_back({{"metric", objective.metric},
                    {"goal", objective.goal == Goal::maximize ? "maximize" : "minimize"},
                    {"weight", objective.weight},
                    {"scale", objective.scale},
                    {"value_when_absent", optional_json(objective.value_when_absent)}});
  }
  return json;
}

Json constraints_json(const std::vector<Constraint>& constraints) {
  Json json = Json::array();
  for (const Constraint& constraint : constraints) {
    Json one = Json::object();
    one["name"] = constraint.name;
    if (constraint.metric.empty()) {
      one["expression"] = constraint.expression;
    } else {
      one["metric"] = constraint.metric;
    }
    one["lower"] = optional_json(constraint.lower);
    one["upper"] = optional_json(constraint.upper);
    one["scale"] = constraint.scale;
    one["satisfied_when_absent"] = constraint.satisfied_when_absent;
    json.push_back(std::move(one));
  }
  return json;
}

Json method_json(const Method& method) {
  Json starts = Json::array();
  for (const Design& start : method.starts) starts.push_back(Json(start));
  return {{"algorithm", method.algorithm},
          {"local_algorithm", method.local_algorithm},
          {"max_evaluations", method.max_evaluations},
          {"max_time_s", method.max_time_s},
          {"relative_tolerance", method.relative_tolerance},
          {"seed", method.seed},
          {"starts", starts},
          {"start_count", method.start_count},
          {"initial_step", method.initial_step}};
}

}  // namespace

Json resolve_study(const StudySpec& study) {
  return {{"format", "parapet-study/1"},
          {"name", study.name},
          {"description", study.description},
          {"case", study.base_case},
          {"variables", variables_json(study.variables)},
          {"objectives", objectives_json(study.objectives)},
          {"constraints", constraints_json(study.constraints)},
          {"method", method_json(study.method)}};
}

}  // namespace parapet::designs
