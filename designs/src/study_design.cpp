#include <algorithm>
#include <cmath>
#include <utility>

#include "case_parts.hpp"
#include "parapet/math/units.hpp"
#include "study_choices.hpp"
#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

std::vector<std::string> variable_names(const std::vector<Variable>& variables) {
  std::vector<std::string> names;
  for (const Variable& variable : variables) names.push_back(variable.name);
  return names;
}

std::vector<std::string> names_of(const std::vector<Option>& options) {
  std::vector<std::string> names;
  for (const Option& option : options) names.push_back(option.name);
  return names;
}

const Variable* find_variable(const std::vector<Variable>& variables, const std::string& name) {
  const auto found = std::find_if(variables.begin(), variables.end(),
                                  [&](const Variable& variable) { return variable.name == name; });
  return found == variables.end() ? nullptr : &*found;
}

/// "a number from 0 to 75 [deg]", or the options.
std::string allowed_text(const Variable& variable) {
  if (variable.kind == VariableKind::choice) {
    return "one of the options " + joined(names_of(variable.options), "\"");
  }
  const bool whole = variable.kind == VariableKind::integer;
  const auto bound = [&](double value) {
    return whole ? std::to_string(static_cast<long long>(value)) : Json(value).dump();
  };
  std::string text = whole ? "a whole number from " : "a number from ";
  text += bound(variable.lower) + " to " + bound(variable.upper);
  const std::string_view unit = math::unit_of(variable.name).plain;
  if (!unit.empty()) text.append(" [").append(unit).append("]");
  return text;
}

std::string option_numbers(const Variable& choice) {
  return "a whole number from 0 to " + std::to_string(choice.options.size() - 1);
}

/// `deflector "plate" or "big"`.
std::string condition_text(const std::vector<Variable>& variables, const ActiveWhen& condition) {
  const Variable* choice = find_variable(variables, condition.choice);
  std::string text;
  for (const int number : condition.options) {
    text.append(text.empty() ? "" : " or ")
        .append("\"" + choice->options.at(static_cast<std::size_t>(number)).name + "\"");
  }
  return condition.choice + " " + text;
}

/// Whether it is known that the variable exists, or that it does not: the choices that decide are
/// in the design.
bool is_decided(const std::vector<Variable>& variables, const Variable& variable,
                const Design& design) {
  if (!variable.active_when) return true;
  const Variable* choice = find_variable(variables, variable.active_when->choice);
  if (!is_decided(variables, *choice, design)) return false;
  return !is_active(variables, *choice, design) || design.contains(choice->name);
}

/// A value that is beyond a bound by its last digits only becomes the bound.
double within_bounds(const Variable& variable, double value) {
  const double range = variable.upper - variable.lower;  // counts where a bound is 0
  const auto is_near = [&](double bound) {
    return nearly_equal(value, bound) || nearly_equal(value - bound + range, range);
  };
  if (value < variable.lower && is_near(variable.lower)) return variable.lower;
  if (value > variable.upper && is_near(variable.upper)) return variable.upper;
  return value;
}

std::string value_problem(const Variable& variable, double given) {
  const double value = within_bounds(variable, given);
  const bool outside = !std::isfinite(value) || value < variable.lower || value > variable.upper;
  if (variable.kind == VariableKind::choice) {
    return outside || std::floor(value) != value ? "is not the number of an option" : "";
  }
  if (outside) return "is outside the variable's bounds";
  const bool broken = variable.kind == VariableKind::integer && std::floor(value) != value;
  return broken ? "is not a whole number" : "";
}

/// The names in the file that are no variables.
void check_names(const std::vector<Variable>& variables, const std::vector<std::string>& given,
                 const std::string& pointer, Findings& findings) {
  const std::vector<std::string> names = variable_names(variables);
  for (const std::string& name : given) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    findings.add(child_pointer(pointer, name), "unknown variable" + did_you_mean(name, names),
                 "the variables " + joined(names));
  }
}

/// Goes through the variables in their order. `value_of(variable, place)` gives the value, or
/// nothing and a finding where what stands there is no value.
template <typename ValueOf>
Design sound_values(const std::vector<Variable>& variables, const std::vector<std::string>& given,
                    const std::string& pointer, Findings& findings, ValueOf value_of) {
  Design design;
  for (const Variable& variable : variables) {
    const std::string place = child_pointer(pointer, variable.name);
    const bool is_given = std::find(given.begin(), given.end(), variable.name) != given.end();
    const bool active = is_active(variables, variable, design);
    if (!is_decided(variables, variable, design)) continue;
    if (is_given && !active) {
      findings.add(place, "does not exist under the options that the design takes",
                   "no value, or the choice " + condition_text(variables, *variable.active_when));
    } else if (active && !is_given) {
      findings.add(place, "is missing", allowed_text(variable));
    } else if (active) {
      if (const std::optional<double> value = value_of(variable, place)) {
        design[variable.name] = *value;
      }
    }
  }
  check_names(variables, given, pointer, findings);
  return design;
}

/// The number that a JSON value stands for.
std::optional<double> json_value(const Variable& variable, const Json& json,
                                 const std::string& place, Findings& findings) {
  std::string problem;
  if (variable.kind == VariableKind::choice) {
    const std::vector<std::string> names = names_of(variable.options);
    const std::string word = json.is_string() ? json.get<std::string>() : "";
    const auto found = std::find(names.begin(), names.end(), word);
    if (json.is_string() && found != names.end()) return static_cast<double>(found - names.begin());
    problem = json.is_string() ? "is not an option of " + variable.name + did_you_mean(word, names)
                               : "is not the name of an option";
  } else if (!json.is_number()) {
    problem = "is not a number";
  } else {
    const double value = json.get<double>() + 0.0;  // -0 and 0 are one design
    problem = value_problem(variable, value);
    if (problem.empty()) return within_bounds(variable, value);
  }
  findings.add(place, problem, allowed_text(variable));
  return std::nullopt;
}

/// A case into which values are put; it remembers who did.
class CaseInputs {
 public:
  CaseInputs(Json start, const std::string& file) : json(std::move(start)), file_(file) {}

  void put(const std::string& pointer, double value, const std::string& by) {
    if (find_value(json, pointer) == nullptr) {  // an option is missing in the design
      throw InputError({{file_, "/case" + pointer, short_text(value),
                         "does not exist under the options taken (set by " + by + ")",
                         "a design with a value for every choice"}});
    }
    json.at(Json::json_pointer(pointer)) = value;
    setter_["/case" + pointer] = by;
  }

  InputError blamed(std::vector<InputIssue> issues) const {
    for (InputIssue& issue : issues) {
      const auto found = setter_.find(issue.pointer);
      if (found != setter_.end()) issue.problem += " (set by " + found->second + ")";
    }
    return InputError(std::move(issues));
  }

  Json json;

 private:
  const std::string& file_;
  std::map<std::string, std::string> setter_;
};

/// @throws InputError for what makes no sense before any value is looked at.
void require_structure(const StudySpec& study, const Design& design) {
  const std::vector<std::string> names = variable_names(study.variables);
  for (const auto& entry : design) {
    const std::string& name = entry.first;
    const double value = entry.second;
    const auto fail = [&](const std::string& problem, const std::string& allowed) {
      return InputError({{study.source_file, child_pointer("/variables", name), short_text(value),
                          problem, allowed}});
    };
    const Variable* variable = find_variable(study.variables, name);
    if (variable == nullptr) {
      throw fail("unknown variable" + did_you_mean(name, names), "the variables " + joined(names));
    }
    if (!is_active(study.variables, *variable, design)) {
      throw fail(
          "does not exist under the options that the design takes",
          "no value, or the choice " + condition_text(study.variables, *variable->active_when));
    }
    if (variable->kind != VariableKind::choice) continue;
    const std::string problem = value_problem(*variable, value);
    if (!problem.empty()) {
      throw fail(problem, option_numbers(*variable));
    }
  }
}

}  // namespace

Design read_design_values(const std::vector<Variable>& variables, const Json& json,
                          const std::string& pointer, Findings& findings) {
  std::vector<std::string> given;
  for (const auto& [name, value] : json.items()) given.push_back(name);
  return sound_values(variables, given, pointer, findings,
                      [&](const Variable& variable, const std::string& place) {
                        return json_value(variable, json.at(variable.name), place, findings);
                      });
}

DesignReading read_design(const StudySpec& study, const Json& json, const std::string& source) {
  Findings findings(source, json);
  if (!json.is_object()) {
    return {{},
            {{source, "", short_text(json), "is not an object",
              "an object of values by variable, for example {\"deflector_angle_deg\": 45}"}}};
  }
  Design design = read_design_values(study.variables, json, "", findings);
  return {std::move(design), findings.issues()};
}

std::vector<InputIssue> check_design(const StudySpec& study, const Design& design,
                                     const std::string& source) {
  const Json json(design);
  Findings findings(source, json);
  std::vector<std::string> given;
  for (const auto& [name, value] : design) given.push_back(name);
  sound_values(study.variables, given, "", findings,
               [&](const Variable& variable, const std::string& place) -> std::optional<double> {
                 const double value = design.at(variable.name);
                 const std::string problem = value_problem(variable, value);
                 if (problem.empty()) return value;
                 findings.add(place, problem,
                              variable.kind == VariableKind::choice ? option_numbers(variable)
                                                                    : allowed_text(variable));
                 return std::nullopt;
               });
  return findings.issues();
}

bool is_active(const StudySpec& study, const Variable& variable, const Design& design) {
  return is_active(study.variables, variable, design);
}

std::map<std::string, std::string> option_names(const StudySpec& study, const Design& design) {
  std::map<std::string, std::string> names;
  for (const Variable& variable : study.variables) {
    const auto taken = design.find(variable.name);
    if (variable.kind != VariableKind::choice || taken == design.end()) continue;
    if (!value_problem(variable, taken->second).empty()) continue;
    names[variable.name] = variable.options[static_cast<std::size_t>(taken->second)].name;
  }
  return names;
}

Json design_json(const StudySpec& study, const Design& design) {
  const std::map<std::string, std::string> names = option_names(study, design);
  Json json = Json::object();
  for (const auto& [name, value] : design) {
    const auto option = names.find(name);
    json[name] = option == names.end() ? Json(value) : Json(option->second);
  }
  return json;
}

double evaluate_expression(const StudySpec& study, const std::string& expression,
                           const Design& design) {
  Design complete = design;
  for (const Variable& variable : study.variables) complete.try_emplace(variable.name, 0.0);
  return evaluate_expression(expression, complete);
}

CaseSpec design_case(const StudySpec& study, const Design& design, const Scenario* scenario,
                     std::optional<double> spacing) {
  require_structure(study, design);
  CaseInputs inputs(structured_case(study, design), study.source_file);
  const std::size_t n_barriers = inputs.json.at("barriers").size();
  for (const Variable& variable : study.variables) {
    const auto found = design.find(variable.name);
    if (found == design.end()) continue;
    for (const std::string& target : variable.targets) {
      for (const std::string& pointer : expand_target(target, n_barriers)) {
        inputs.put(pointer, found->second, "the variable " + variable.name);
      }
    }
  }
  if (scenario != nullptr) {
    for (const auto& [pointer, value] : scenario->sets) {
      inputs.put(pointer, value, "the scenario " + scenario->name);
    }
  }
  if (spacing) inputs.json["numerics"]["spacing_m"] = *spacing;
  CaseAttempt attempt = try_case(inner_case_schema(), inputs.json, study.source_file, "/case");
  if (!attempt.spec) throw inputs.blamed(std::move(attempt.issues));
  CaseSpec& spec = *attempt.spec;
  if (study.undisturbed && study.undisturbed->fits(spec)) {
    set_approach(spec, study.undisturbed->profile);
  }
  return std::move(spec);
}

bool UndisturbedFlow::fits(const CaseSpec& spec) const {
  solver::Scene open = solver::undisturbed(spec.scene);
  open.monitor_x = scene.monitor_x;  // where it is gauged does not change it
  return open == scene && spec.run.gauges == gauges;
}

}  // namespace parapet::designs
