#include "study_parts.hpp"

namespace parapet::designs {
namespace {

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

const char* word(Statistic statistic) {
  switch (statistic) {
    case Statistic::mean:
      return "mean";
    case Statistic::worst:
      return "worst";
    case Statistic::quantile:
      return "quantile";
    case Statistic::probability:
      break;
  }
  return "probability";
}

const char* word(Recordings recordings) {
  switch (recordings) {
    case Recordings::none:
      return "none";
    case Recordings::all:
      return "all";
    case Recordings::front:
      break;
  }
  return "front";
}

const char* word(Scalarization scalarization) {
  switch (scalarization) {
    case Scalarization::weighted_sum:
      return "weighted_sum";
    case Scalarization::epsilon_constraint:
      return "epsilon_constraint";
    case Scalarization::augmented_chebyshev:
      break;
  }
  return "augmented_chebyshev";
}

Json options_json(const std::vector<Option>& options) {
  Json json = Json::object();
  for (const Option& option : options) {
    json[option.name] = {{"remove", option.removes}, {"set", Json::object()}};
    for (const auto& [pointer, value] : option.sets) json[option.name]["set"][pointer] = value;
  }
  return json;
}

Json condition_json(const std::vector<Variable>& variables, const ActiveWhen& condition) {
  Json names = Json::array();
  for (const Variable& choice : variables) {
    if (choice.name != condition.choice) continue;
    for (const int option : condition.options) {
      names.push_back(choice.options[static_cast<std::size_t>(option)].name);
    }
  }
  return {{condition.choice, std::move(names)}};
}

Json variables_json(const std::vector<Variable>& variables) {
  Json json = Json::object();
  for (const Variable& variable : variables) {
    Json one = Json::object();
    if (variable.kind == VariableKind::choice) {
      one["type"] = "choice";
      one["options"] = options_json(variable.options);
    } else {
      one["lower"] = variable.lower;
      one["upper"] = variable.upper;
      one["type"] = variable.kind == VariableKind::integer ? "integer" : "continuous";
      one["targets"] = variable.targets;
    }
    if (variable.active_when) one["active_when"] = condition_json(variables, *variable.active_when);
    json[variable.name] = std::move(one);
  }
  return json;
}

/// The name, and either the metric or the expression.
template <typename Goal>
Json subject_json(const Goal& goal) {
  Json json = {{"name", goal.name}};
  if (goal.metric.empty()) {
    json["expression"] = goal.expression;
  } else {
    json["metric"] = goal.metric;
  }
  if (!goal.values_when_absent.empty()) json["values_when_absent"] = goal.values_when_absent;
  return json;
}

Json terms_json(const std::vector<Term>& terms) {
  Json json = Json::object();
  for (const Term& term : terms) {
    json[term.name] = term.expression;
    if (term.values_when_absent.empty()) continue;
    json[term.name] = {{"expression", term.expression},
                       {"values_when_absent", term.values_when_absent}};
  }
  return json;
}

Json objectives_json(const std::vector<Objective>& objectives) {
  Json json = Json::array();
  for (const Objective& objective : objectives) {
    Json one = subject_json(objective);
    one["goal"] = objective.goal == Goal::maximize ? "maximize" : "minimize";
    one["weight"] = objective.weight;
    one["scale"] = objective.scale;
    one["value_when_absent"] = optional_json(objective.value_when_absent);
    one["statistic"] = word(objective.statistic);
    one["quantile"] = objective.quantile;
    one["lower"] = optional_json(objective.lower);
    one["upper"] = optional_json(objective.upper);
    one["reference"] = optional_json(objective.reference);
    json.push_back(std::move(one));
  }
  return json;
}

Json constraints_json(const std::vector<Constraint>& constraints) {
  Json json = Json::array();
  for (const Constraint& constraint : constraints) {
    Json one = subject_json(constraint);
    one["lower"] = optional_json(constraint.lower);
    one["upper"] = optional_json(constraint.upper);
    one["scale"] = constraint.scale;
    one["satisfied_when_absent"] = constraint.satisfied_when_absent;
    one["value_when_absent"] = optional_json(constraint.value_when_absent);
    one["statistic"] = word(constraint.statistic);
    one["quantile"] = constraint.quantile;
    json.push_back(std::move(one));
  }
  return json;
}

/// The list, beside the distributions where it was drawn from some.
Json scenarios_json(const std::vector<Scenario>& scenarios, const Json& given) {
  Json list = Json::array();
  for (const Scenario& scenario : scenarios) {
    Json sets = Json::object();
    for (const auto& [pointer, value] : scenario.sets) sets[pointer] = value;
    list.push_back(
        {{"name", scenario.name}, {"weight", scenario.weight}, {"set", std::move(sets)}});
  }
  if (given.is_array()) return list;
  Json json = given;
  json["list"] = std::move(list);
  return json;
}

Json fidelity_json(const std::vector<FidelityLevel>& levels) {
  Json spacings = Json::array(), seconds = Json::array(), noise = Json::object();
  for (const FidelityLevel& level : levels) {
    spacings.push_back(level.spacing);
    if (level.seconds) seconds.push_back(*level.seconds);
    for (const auto& [metric, sd] : level.noise) noise[metric].push_back(sd);
  }
  return {{"spacings_m", spacings}, {"noise", noise}, {"cpu_time_s", seconds}};
}

Json method_json(const StudySpec& study) {
  const Method& method = study.method;
  Json starts = Json::array();
  for (const Design& start : method.starts) starts.push_back(design_json(study, start));
  return {{"algorithm", method.algorithm},
          {"local_algorithm", method.local_algorithm},
          {"max_evaluations", method.max_evaluations},
          {"max_time_s", method.max_time_s},
          {"max_cpu_time_s", method.max_cpu_time_s},
          {"relative_tolerance", method.relative_tolerance},
          {"seed", method.seed},
          {"starts", starts},
          {"start_count", method.start_count},
          {"initial_step", method.initial_step},
          {"scalarization", word(method.scalarization)},
          {"pareto_points", method.pareto_points},
          {"points_per_variable", method.points_per_variable},
          {"stagnation_evaluations", method.stagnation_evaluations},
          {"least_gain", method.least_gain},
          {"repeatable", method.repeatable},
          {"max_finest_runs", method.max_finest_runs}};
}

}  // namespace

Json resolve_study(const StudySpec& study, const Json& scenarios) {
  Json json{{"format", "parapet-study/1"},
            {"name", study.name},
            {"description", study.description},
            {"case", study.base_case},
            {"variables", variables_json(study.variables)},
            {"objectives", objectives_json(study.objectives)},
            {"constraints", constraints_json(study.constraints)},
            {"scenarios", scenarios_json(study.scenarios, scenarios)},
            {"fidelity", fidelity_json(study.fidelity)},
            {"method", method_json(study)},
            {"recordings", word(study.recordings)}};
  // Only where there are some: a study without any keeps its hash.
  if (!study.terms.empty()) json["terms"] = terms_json(study.terms);
  return json;
}

}  // namespace parapet::designs
