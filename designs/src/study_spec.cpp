#include "parapet/designs/study_spec.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case_parts.hpp"
#include "parapet/solver/metric_catalog.hpp"
#include "study_choices.hpp"
#include "study_parts.hpp"

namespace parapet::designs {
namespace {

/// The base case at each spacing must be possible; it takes the finest.
void apply_fidelity(StudySpec& study, Findings& findings) {
  for (std::size_t k = study.fidelity.size(); k-- > 0;) {  // the finest last
    Json json = study.base_case;
    json["numerics"]["spacing_m"] = study.fidelity[k].spacing;
    const CaseAttempt attempt = try_case(inner_case_schema(), json, study.source_file, "/case");
    if (attempt.spec && k == 0) study.base_case = attempt.spec->resolved;
    if (attempt.spec) continue;
    const InputIssue& first = attempt.issues.front();
    findings.add("/fidelity/spacings_m",
                 Json(study.fidelity[k].spacing).dump() + " is not possible: " + first.pointer +
                     " " + first.problem,
                 first.allowed);
  }
}

/// A budget too small for a single design.
void check_finest_runs(const StudySpec& study, Findings& findings) {
  const double events = static_cast<double>(std::max<std::size_t>(1, study.scenarios.size()));
  const double runs = study.method.max_finest_runs;
  if (runs <= 0.0 || runs >= events) return;
  findings.add("/method/max_finest_runs",
               "does not allow one design, which takes " + rounded(events) + " simulations",
               "at least " + rounded(events) + ", or 0 for no limit");
}

/// The first thing wrong with a design in any event, at any spacing.
std::optional<InputIssue> first_issue(const StudySpec& study, const Design& design) {
  std::vector<const Scenario*> events;
  for (const Scenario& scenario : study.scenarios) events.push_back(&scenario);
  if (events.empty()) events.push_back(nullptr);
  for (const FidelityLevel& level : study.fidelity) {
    for (const Scenario* event : events) {
      try {
        design_case(study, design, event, level.spacing);
      } catch (const InputError& error) {
        InputIssue issue = error.issues().front();
        if (event != nullptr) issue.problem += " (in the scenario " + event->name + ")";
        return issue;
      }
    }
  }
  return std::nullopt;
}

/// Every impossible starting design, so that no run is wasted on finding out.
void check_starts(const StudySpec& study, Findings& findings) {
  for (std::size_t k = 0; k < study.method.starts.size(); ++k) {
    if (const auto issue = first_issue(study, study.method.starts[k])) {
      findings.add(child_pointer("/method/starts", k),
                   "is not a possible scene: " + issue->pointer + " " + issue->problem,
                   issue->allowed);
    }
  }
}

/// A design somewhere between the bounds: the middle for k = 0, then the points of an additive
/// recurrence, which fills the box evenly.
Design sample_design(const std::vector<Variable>& variables, int k) {
  Design design;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const Variable& variable = variables[i];
    if (!is_active(variables, variable, design)) continue;
    const double turn = std::sqrt(static_cast<double>(2 * i + 3));
    const double share = std::fmod(0.5 + k * turn, 1.0);
    const double value = variable.lower + share * (variable.upper - variable.lower);
    const bool whole = variable.kind != VariableKind::continuous;
    design[variable.name] = whole ? std::round(value) : value;
  }
  return design;
}

/// A value of a metric for a trial of a formula: the first is 1, the others anything positive.
double sample_metric(const std::string& key, std::size_t place, int k) {
  const auto info = solver::find_metric_info(key);
  const double turn = std::sqrt(static_cast<double>(2 * place + 3));
  const double share = std::fmod(1.0 + k * turn, 1.0);
  const bool is_share = info && info->least == 0.0 && info->greatest == 1.0;
  return is_share ? 1.0 - share : (k == 0 ? 1.0 : 10.0 * share);
}

/// Formulas that have a value nowhere, such as 1/(a - a).
void check_formulas(const StudySpec& study, Findings& findings) {
  constexpr int samples = 200;
  const auto check = [&](const auto& goal, const std::string& pointer) {
    if (goal.formula.empty()) return;
    for (int k = 0; k < samples; ++k) {
      Design values = sample_design(study.variables, k);
      for (std::size_t m = 0; m < goal.metrics.size(); ++m) {
        values[goal.metrics[m]] = sample_metric(goal.metrics[m], m, k);
      }
      try {
        evaluate_expression(study, goal.formula, values);
        return;
      } catch (const InputError&) {
      }
    }
    findings.add(
        pointer,
        "has no finite value at any of " + std::to_string(samples) + " designs between the bounds",
        "a formula with a value, such as one that does not divide by zero");
  };
  for (const Term& term : study.terms) {
    check(term, child_pointer("/terms", term.name));
  }
  for (std::size_t k = 0; k < study.objectives.size(); ++k) {
    check(study.objectives[k], child_pointer("/objectives", k) + "/expression");
  }
  for (std::size_t k = 0; k < study.constraints.size(); ++k) {
    check(study.constraints[k], child_pointer("/constraints", k) + "/expression");
  }
}

/// A base case that an event makes impossible.
void check_scenarios(const StudySpec& study, Findings& findings) {
  for (const Scenario& scenario : study.scenarios) {
    try {
      design_case(study, {}, &scenario);
    } catch (const InputError& error) {
      const InputIssue& first = error.issues().front();
      findings.add(
          "/scenarios",
          scenario.name + " makes the case impossible: " + first.pointer + " " + first.problem,
          first.allowed);
    }
  }
}

}  // namespace

StudySpec parse_study(const Json& json, const std::string& file) {
  require_format(json, file, "parapet-study/1");
  refuse_control_characters(json, file);
  const SchemaNode schema = schema_document("study.schema.json");
  std::vector<InputIssue> issues = schema_issues(schema, json, file);
  if (!issues.empty()) throw InputError(std::move(issues));

  const Json complete = with_defaults(schema, json);
  Findings findings(file, complete);
  const std::optional<CaseSpec> base = base_case(json, file, findings);
  if (!base) findings.throw_if_any();

  StudySpec study;
  study.name = complete.at("name").get<std::string>();
  study.description = complete.at("description").get<std::string>();
  study.source_file = file;
  study.base_case = base->resolved;
  auto [variables, combinations] =
      read_variables(complete.at("variables"), base->resolved, findings);
  study.variables = std::move(variables);
  const bool variables_sound = findings.empty();
  if (combinations.empty()) combinations.push_back({{}, "", base->resolved});
  const Metrics metrics(combinations);
  const std::size_t before_terms = findings.size();
  study.terms = read_terms(complete.at("terms"), metrics, study.variables, findings);
  if (findings.size() == before_terms) {  // else each use of a wrong term would be found as well
    study.objectives =
        read_objectives(complete.at("objectives"), metrics, study.variables, study.terms, findings);
    study.constraints = read_constraints(complete.at("constraints"), metrics, study.variables,
                                         study.terms, findings);
  }
  ScenarioReading events =
      read_scenarios(complete.at("scenarios"), study.variables, combinations, findings);
  study.scenarios = std::move(events.scenarios);
  study.event_variables = std::move(events.variables);
  study.fidelity = read_fidelity(complete.at("fidelity"), base->resolved, metrics, findings);
  study.method = read_method(complete.at("method"),
                             variables_sound ? study.variables : std::vector<Variable>{}, findings);
  const std::string recordings = complete.at("recordings").get<std::string>();
  study.recordings = recordings == "all"    ? Recordings::all
                     : recordings == "none" ? Recordings::none
                                            : Recordings::front;
  if (findings.empty()) apply_fidelity(study, findings);
  if (findings.empty()) check_scenarios(study, findings);
  check_finest_runs(study, findings);
  check_quantiles(study, findings);
  if (findings.empty()) check_formulas(study, findings);
  if (findings.empty()) check_starts(study, findings);
  findings.throw_if_any();
  study.resolved = resolve_study(study, complete.at("scenarios"));
  return study;
}

StudySpec load_study(const std::filesystem::path& file) {
  return parse_study(read_json(file), file.string());
}

}  // namespace parapet::designs
