#include "study_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "parapet/records/evaluation_log.hpp"
#include "study_log_spec.hpp"

namespace parapet::reports {
namespace {

using designs::InputError;
using designs::InputIssue;
using designs::Json;

std::string file_text(const std::filesystem::path& file, const std::string& wanted) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError({InputIssue{file.string(), "", "", "the file cannot be read", wanted}});
  }
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

LoggedDesign read_design(const Json& line, const Json& spec) {
  const records::EvaluationRecord record = records::record_from_json(line);
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
  design.options = record.options;
  design.cpu_time = record.cpu_time;
  for (const records::ScenarioRecord& scenario : record.scenarios) {
    design.scenarios.push_back(scenario.name);
  }
  for (const records::ObjectiveRecord& objective : record.objectives) {
    design.objectives.push_back(read_objective(objective, spec));
  }
  for (const records::ConstraintRecord& constraint : record.constraints) {
    design.constraints.push_back(read_constraint(constraint, spec));
  }
  return design;
}

void check_variables(const LoggedDesign& design, const StudyLog& log) {
  for (const LoggedVariable& variable : log.variables) {
    if (!design.design.contains(variable.name) && !variable.conditional) {
      throw std::invalid_argument(fmt::format("design {} has no {}", design.id, variable.name));
    }
  }
}

/// Lines that are whole; a last one that is not is passed over.
std::vector<LoggedDesign> read_lines(const std::filesystem::path& file, const StudyLog& log,
                                     bool& incomplete_last_line) {
  std::vector<LoggedDesign> designs;
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
      designs.push_back(std::move(design));
    } catch (const std::exception& error) {
      if (last) {
        incomplete_last_line = true;
        continue;
      }
      throw InputError(
          {InputIssue{fmt::format("{}:{}", file.string(), number_of_line), "", line.substr(0, 60),
                      fmt::format("the line is damaged ({})", error.what()),
                      "one evaluated design as a JSON object"}});
    }
  }
  return designs;
}

/// A file that tells more of the study, when it is there, whole and of the same spec.
Json read_companion(const StudyLog& log, const char* name, const std::string& format) {
  std::ifstream file(log.path / name);
  if (!file) return nullptr;
  Json json = Json::parse(file, nullptr, false);
  const bool fits = json.is_object() && text(json, "format") == format &&
                    text(json, "spec_hash") == log.spec_hash;
  return fits ? json : Json();
}

void read_designs(StudyLog& log) {
  const std::filesystem::path file = log.path / "evaluations.jsonl";
  log.designs = read_lines(file, log, log.incomplete_last_line);
  if (log.designs.empty()) {
    throw InputError({InputIssue{file.string(), "", "", "no design has been evaluated yet",
                                 "at least one complete line"}});
  }
  const std::filesystem::path confirmed = log.path / "confirmations.jsonl";
  bool ignored = false;
  if (std::filesystem::exists(confirmed)) {
    log.confirmations = read_lines(confirmed, log, ignored);
  }
}

}  // namespace

std::optional<double> LoggedObjective::minimised() const {
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return goal == "minimize" ? *value : -*value;
}

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
      if (!metric.key.starts_with("barrier_")) continue;
      int number = 0;
      for (std::size_t k = 8; k < metric.key.size() && metric.key[k] >= '0' && metric.key[k] <= '9';
           ++k) {
        number = 10 * number + (metric.key[k] - '0');
      }
      count = std::max(count, number);
    }
  }
  return count;
}

std::optional<double> StudyLog::counted_spacing() const {
  std::vector<double> levels;
  const Json& fidelity = member(spec, "fidelity");
  for (const Json& spacing : member(fidelity, "spacings_m")) {
    if (spacing.is_number()) levels.push_back(spacing.get<double>());
  }
  std::ranges::sort(levels);
  for (const double level : levels) {
    const auto used = [&](const LoggedDesign& design) {
      return design.ok && design.spacing == level;
    };
    if (std::ranges::any_of(designs, used)) return level;
  }
  return levels.empty() ? std::nullopt : std::optional(levels.front());
}

bool StudyLog::counts(const LoggedDesign& design) const {
  if (!design.ok || !design.objective_scalar) return false;
  const std::optional<double> spacing = counted_spacing();
  return !spacing || design.spacing == spacing;
}

bool StudyLog::all_numbers() const {
  return std::ranges::none_of(variables, [](const LoggedVariable& variable) {
    return variable.choice() || variable.conditional;
  });
}

std::size_t StudyLog::n_objectives() const {
  return member(spec, "objectives").size();
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
  read_designs(log);
  log.pareto = read_companion(log, "pareto.json", "parapet-pareto/1");
  log.sensitivity = read_companion(log, "sensitivity.json", "parapet-sensitivity/1");
  return log;
}

}  // namespace parapet::reports
