#include "parapet/designs/study_spec.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "case_parts.hpp"
#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

std::vector<std::string> variable_names(const std::vector<Variable>& variables) {
  std::vector<std::string> names;
  for (const Variable& variable : variables) names.push_back(variable.name);
  return names;
}

/// "from 0 to 75 [deg]".
std::string bounds_text(const Variable& variable) {
  std::string text = "from " + Json(variable.lower).dump() + " to " + Json(variable.upper).dump();
  const std::string_view unit = unit_symbol(variable.name);
  if (!unit.empty()) text.append(" [").append(unit).append("]");
  return text;
}

void check_design_values(const std::vector<Variable>& variables, const Design& design,
                         const std::string& pointer, Findings& findings) {
  for (const Variable& variable : variables) {
    const auto found = design.find(variable.name);
    const std::string place = child_pointer(pointer, variable.name);
    if (found == design.end()) {
      findings.add(place, "is missing", "a number " + bounds_text(variable));
    } else if (!std::isfinite(found->second) || found->second < variable.lower ||
               found->second > variable.upper) {
      findings.add(place, "is outside the variable's bounds", "a number " + bounds_text(variable));
    }
  }
  const std::vector<std::string> names = variable_names(variables);
  for (const auto& [name, value] : design) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    findings.add(child_pointer(pointer, name), "unknown variable" + did_you_mean(name, names),
                 "the variables " + joined(names));
  }
}

/// Every impossible starting design, so that no run is wasted on finding out.
void check_starts(const StudySpec& study, Findings& findings) {
  for (std::size_t k = 0; k < study.method.starts.size(); ++k) {
    try {
      design_case(study, study.method.starts[k]);
    } catch (const InputError& error) {
      const InputIssue& first = error.issues().front();
      findings.add(child_pointer("/method/starts", k),
                   "is not a possible scene: " + first.pointer + " " + first.problem,
                   first.allowed);
    }
  }
}

}  // namespace

Method read_method(const Json& json, const std::vector<Variable>& variables, Findings& findings) {
  Method method;
  method.algorithm = json.at("algorithm").get<std::string>();
  method.local_algorithm = json.at("local_algorithm").get<std::string>();
  method.max_evaluations = static_cast<int>(json.at("max_evaluations").get<double>());
  method.max_time_s = json.at("max_time_s").get<double>();
  method.relative_tolerance = json.at("relative_tolerance").get<double>();
  method.seed = static_cast<std::uint64_t>(json.at("seed").get<double>());
  method.start_count = static_cast<int>(json.at("start_count").get<double>());
  method.initial_step = json.at("initial_step").get<double>();
  const Json& starts = json.at("starts");
  for (std::size_t k = 0; k < starts.size(); ++k) {
    method.starts.push_back(starts[k].get<Design>());
    // A start cannot be judged by variables that are wrong themselves.
    if (!variables.empty()) {
      check_design_values(variables, method.starts.back(), child_pointer("/method/starts", k),
                          findings);
    }
  }
  const auto n_starts = static_cast<long>(starts.size()) + method.start_count;
  if (n_starts > method.max_evaluations) {
    findings.add("/method/max_evaluations",
                 "does not even allow the " + std::to_string(n_starts) + " starting designs",
                 "at least the number of starts and start_count together");
  }
  return method;
}

StudySpec parse_study(const Json& json, const std::string& file) {
  require_format(json, file, "parapet-study/1");
  const SchemaNode schema = schema_document("study.schema.json");
  std::vector<InputIssue> issues = schema_issues(schema, json, file);
  if (!issues.empty()) throw InputError(std::move(issues));

  Json complete = with_defaults(schema, json);
  Findings findings(file, complete);
  const std::optional<CaseSpec> base = base_case(json, file, findings);
  if (!base) findings.throw_if_any();

  StudySpec study;
  study.name = complete.at("name").get<std::string>();
  study.description = complete.at("description").get<std::string>();
  study.source_file = file;
  study.base_case = base->resolved;
  const int n_barriers = static_cast<int>(base->scene.barriers.size());
  study.variables = read_variables(complete.at("variables"), base->resolved, findings);
  const bool variables_sound = findings.empty();
  study.objectives = read_objectives(complete.at("objectives"), n_barriers, findings);
  study.constraints =
      read_constraints(complete.at("constraints"), n_barriers, study.variables, findings);
  study.method = read_method(complete.at("method"),
                             variables_sound ? study.variables : std::vector<Variable>{}, findings);
  if (findings.empty()) check_starts(study, findings);
  findings.throw_if_any();
  study.resolved = resolve_study(study);
  return study;
}

StudySpec load_study(const std::filesystem::path& file) {
  return parse_study(read_json(file), file.string());
}

std::vector<InputIssue> check_design(const StudySpec& study, const Design& design,
                                     const std::string& source) {
  const Json json(design);
  Findings findings(source, json);
  check_design_values(study.variables, design, "", findings);
  return findings.issues();
}

CaseSpec design_case(const StudySpec& study, const Design& design) {
  Json json = study.base_case;
  std::map<std::string, std::string> setter;
  for (const Variable& variable : study.variables) {
    const auto found = design.find(variable.name);
    if (found == design.end()) continue;
    for (const std::string& target : variable.targets) {
      json.at(Json::json_pointer(target)) = found->second;
      setter["/case" + target] = variable.name;
    }
  }
  for (const auto& [name, value] : design) {
    const std::vector<std::string> names = variable_names(study.variables);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw InputError(
        {{study.source_file, child_pointer("/variables", name), short_text(value),
          "unknown variable" + did_you_mean(name, names), "the variables " + joined(names)}});
  }
  CaseAttempt attempt = try_case(inner_case_schema(), json, study.source_file, "/case");
  if (attempt.spec) return *std::move(attempt.spec);
  for (InputIssue& issue : attempt.issues) {
    const auto found = setter.find(issue.pointer);
    if (found != setter.end()) issue.problem += " (set by the variable " + found->second + ")";
  }
  throw InputError(std::move(attempt.issues));
}

}  // namespace parapet::designs
