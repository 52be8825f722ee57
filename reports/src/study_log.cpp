#include "study_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "parapet/reports/evaluation_log.hpp"

namespace parapet::reports {
namespace {

using designs::InputError;
using designs::InputIssue;
using designs::Json;

std::optional<double> number(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::string text(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

std::string file_text(const std::filesystem::path& file, const std::string& wanted) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError({InputIssue{file.string(), "", "", "the file cannot be read", wanted}});
  }
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

std::vector<LoggedVariable> read_variables(const Json& spec, const std::string& file) {
  std::vector<LoggedVariable> variables;
  for (const auto& [name, entry] : member(spec, "variables").items()) {
    if (entry.is_object() && entry.contains("options")) {
      const auto last = static_cast<double>(entry["options"].size()) - 1.0;
      variables.push_back({name, 0.0, last, true, entry.contains("active_when")});
      continue;
    }
    const std::optional<double> lower = entry.is_object() ? number(entry, "lower") : std::nullopt;
    const std::optional<double> upper = entry.is_object() ? number(entry, "upper") : std::nullopt;
    if (!lower || !upper) {
      throw InputError({InputIssue{file, "/spec/variables/" + name, entry.dump(),
                                   "the variable has no bounds", "lower and upper, numbers"}});
    }
    variables.push_back({name, *lower, *upper, false, entry.contains("active_when")});
  }
  if (variables.empty()) {
    throw InputError({InputIssue{file, "/spec/variables", "", "the study has no variables",
                                 "an object of at least one variable"}});
  }
  return variables;
}

/// The record's constraint with what the spec says of it.
LoggedConstraint read_constraint(const ConstraintRecord& record, const Json& spec) {
  LoggedConstraint constraint;
  constraint.name = record.name;
  constraint.value = record.value;
  constraint.lower = record.lower;
  constraint.upper = record.upper;
  constraint.satisfied = record.satisfied;
  for (const Json& stated : member(spec, "constraints")) {
    if (!stated.is_object() || text(stated, "name") != constraint.name) continue;
    constraint.scale = number(stated, "scale");
    constraint.of = text(stated, "metric");
    constraint.on_metric = !constraint.of.empty();
    if (!constraint.on_metric) constraint.of = text(stated, "expression");
  }
  return constraint;
}

LoggedDesign read_design(const Json& line, const Json& spec) {
  const EvaluationRecord record = record_from_json(line);
  LoggedDesign design;
  design.id = record.id;
  design.stage = record.stage;
  design.design = record.design;
  design.ok = record.ok;
  design.reason = record.reason;
  design.feasible = record.ok && record.feasible;
  design.objective_scalar = record.objective_scalar;
  design.spacing = record.spacing > 0.0 ? std::optional(record.spacing) : std::nullopt;
  design.metrics = record.metrics;
  for (const ObjectiveRecord& objective : record.objectives) {
    design.objectives.push_back(
        {objective.metric, objective.goal == designs::Goal::minimize ? "minimize" : "maximize",
         objective.weight, objective.value, objective.absent});
  }
  for (const ConstraintRecord& constraint : record.constraints) {
    design.constraints.push_back(read_constraint(constraint, spec));
  }
  return design;
}

void check_variables(const LoggedDesign& design, const StudyLog& log) {
  for (const LoggedVariable& variable : log.variables) {
    if (!variable.conditional && !design.design.contains(variable.name)) {
      throw std::invalid_argument(fmt::format("design {} has no {}", design.id, variable.name));
    }
  }
}

void leave_out_coarse(std::vector<LoggedDesign>& designs) {
  double finest = std::numeric_limits<double>::infinity();
  for (const LoggedDesign& design : designs)
    finest = std::min(finest, design.spacing.value_or(0.0));
  std::erase_if(designs,
                [&](const LoggedDesign& design) { return design.spacing.value_or(0.0) > finest; });
}

void read_designs(const std::filesystem::path& file, StudyLog& log) {
  const std::string bytes = file_text(file, "the log of a study that has started");
  std::size_t start = 0;
  for (int number_of_line = 1; start < bytes.size(); ++number_of_line) {
    std::size_t end = bytes.find('\n', start);
    const bool last = end == std::string::npos || end + 1 == bytes.size();
    if (end == std::string::npos) end = bytes.size();
    const std::string line = bytes.substr(start, end - start);
    start = end + 1;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      LoggedDesign design = read_design(Json::parse(line), log.spec);
      check_variables(design, log);
      log.designs.push_back(std::move(design));
    } catch (const std::exception& error) {
      if (last) {
        log.incomplete_last_line = true;
        continue;
      }
      throw InputError(
          {InputIssue{fmt::format("{}:{}", file.string(), number_of_line), "", line.substr(0, 60),
                      fmt::format("the line is damaged ({})", error.what()),
                      "one evaluated design as a JSON object"}});
    }
  }
  if (log.designs.empty()) {
    throw InputError({InputIssue{file.string(), "", "", "no design has been evaluated yet",
                                 "at least one complete line"}});
  }
}

}  // namespace

std::optional<double> LoggedConstraint::nearer_limit() const {
  if (lower && upper && value) return *value - *lower < *upper - *value ? lower : upper;
  return lower ? lower : upper;
}

std::optional<double> LoggedConstraint::margin() const {
  if (!value || (!lower && !upper)) return std::nullopt;
  double margin = std::numeric_limits<double>::infinity();
  if (lower) margin = *value - *lower;
  if (upper) margin = std::min(margin, *upper - *value);
  return margin;
}

std::optional<double> LoggedDesign::metric(const std::string& key) const {
  const auto found = std::ranges::find(metrics, key, &solver::Metric::key);
  return found == metrics.end() ? std::nullopt : found->value;
}

double LoggedDesign::violation() const {
  double sum = 0.0;
  for (const LoggedConstraint& constraint : constraints) {
    if (constraint.satisfied) continue;
    const std::optional<double> margin = constraint.margin();
    if (!margin) {
      sum += 1.0;  // a value is asked for and there is none
      continue;
    }
    const double limit = std::abs(constraint.nearer_limit().value_or(1.0));
    sum += std::max(0.0, -*margin) / constraint.scale.value_or(limit > 0.0 ? limit : 1.0);
  }
  return sum;
}

int StudyLog::barriers() const {
  int count = 0;
  for (const LoggedDesign& design : designs) {
    for (const solver::Metric& metric : design.metrics) {
      if (metric.key.starts_with("barrier_")) count = std::max(count, metric.key[8] - '0');
    }
  }
  return count;
}

StudyLog read_study_log(const std::filesystem::path& study_dir) {
  const std::filesystem::path file = study_dir / "study.json";
  StudyLog log;
  log.path = study_dir;
  log.folder = study_dir.string();
  const std::string wanted = "a study folder, as `parapet optimize` writes it";
  Json state;
  try {
    state = Json::parse(file_text(file, wanted));
  } catch (const Json::exception& error) {
    throw InputError({InputIssue{file.string(), "", "", error.what(), wanted}});
  }
  if (!state.is_object() || text(state, "format") != "parapet-study-state/1") {
    throw InputError({InputIssue{file.string(), "/format",
                                 state.is_object() ? member(state, "format").dump() : "",
                                 "this is not a study's state", "\"parapet-study-state/1\""}});
  }
  log.spec = member(state, "spec");
  log.spec_hash = text(state, "spec_hash");
  log.provenance = member(state, "provenance");
  log.variables = read_variables(log.spec, file.string());
  read_designs(study_dir / "evaluations.jsonl", log);
  leave_out_coarse(log.designs);
  return log;
}

}  // namespace parapet::reports
