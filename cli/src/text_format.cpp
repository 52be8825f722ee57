#include "text_format.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parapet/designs/text.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::cli {
namespace {

// " +- 0.02  (grid 0.018, scatter 0.004)"; "~" where the order of convergence was assumed, not
// observed.
std::string uncertainty_text(const solver::Metric& metric) {
  if (!metric.uncertainty) return {};
  const solver::MetricUncertainty& u = *metric.uncertainty;
  return fmt::format(" +- {:.2g}  (grid {}{:.2g}, scatter {:.2g})", u.expanded,
                     u.order_observed ? "" : "~", u.discretisation, u.scatter);
}

}  // namespace

std::string metrics_text(const std::vector<solver::Metric>& metrics) {
  std::size_t width = 0;
  for (const solver::Metric& metric : metrics) width = std::max(width, metric.key.size());
  std::string text;
  for (const solver::Metric& metric : metrics) {
    text += metric.value ? fmt::format("  {:<{}}  {:.5g}{}\n", metric.key, width, *metric.value,
                                       uncertainty_text(metric))
                         : fmt::format("  {:<{}}  - ({})\n", metric.key, width,
                                       designs::visible_text(metric.absent_reason));
  }
  return text;
}

std::string warnings_text(const std::vector<solver::Warning>& warnings) {
  std::string text;
  for (const solver::Warning& warning : warnings) {
    text += fmt::format("  warning: {}\n", designs::visible_text(warning.text));
  }
  return text;
}

namespace {

/// A variable's value; an option by its name.
std::string value_text(const records::EvaluationRecord& record, const std::string& name) {
  const auto option = record.options.find(name);
  if (option != record.options.end()) return designs::visible_text(option->second);
  const auto value = record.design.find(name);
  return value == record.design.end() ? "-" : fmt::format("{:.5g}", value->second);
}

}  // namespace

std::string design_text(const designs::Design& design) {
  std::string text;
  for (const auto& [name, value] : design) {
    text += fmt::format("{}{} {:.5g}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

std::string design_text(const records::EvaluationRecord& record) {
  std::string text;
  for (const auto& [name, value] : record.design) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value_text(record, name));
  }
  return text;
}

std::string violated_text(const records::EvaluationRecord& record) {
  std::string text;
  for (const auto& constraint : record.constraints) {
    if (constraint.satisfied) continue;
    text += (text.empty() ? "" : ", ") + designs::visible_text(constraint.name);
  }
  return text;
}

std::string front_table(const designs::StudySpec& study,
                        const std::vector<records::EvaluationRecord>& records) {
  std::vector<std::vector<std::string>> rows(1, {"design"});
  for (const auto& variable : study.variables) rows.front().push_back(variable.name);
  for (const auto& objective : study.objectives) {
    rows.front().push_back(study::objective_name(objective));
  }
  for (const auto& record : records) {
    rows.push_back({record.id});
    for (const auto& variable : study.variables) {
      rows.back().push_back(value_text(record, variable.name));
    }
    for (const auto& objective : record.objectives) {
      rows.back().push_back(objective.value ? fmt::format("{:.5g}", *objective.value) : "-");
    }
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      std::size_t width = 0;
      for (const auto& other : rows) width = std::max(width, other[k].size());
      text += fmt::format("  {:>{}}", row[k], width);
    }
    text += "\n";
  }
  return text;
}

std::string objectives_text(const records::EvaluationRecord& record) {
  std::string text;
  for (const auto& objective : record.objectives) {
    const std::string name = designs::visible_text(objective.metric);
    text += text.empty() ? "" : ", ";
    text += objective.value ? fmt::format("{} {:.4g}", name, *objective.value) : name + " -";
    if (objective.absent) text += " (absent)";
  }
  return text;
}

namespace {

/// What lies beyond a limit by less than the tolerance says so.
std::string state_text(const records::ConstraintRecord& constraint) {
  if (!constraint.satisfied) return ", VIOLATED";
  const bool beyond = constraint.margin && *constraint.margin < 0.0 && constraint.tolerance;
  return beyond ? fmt::format(", satisfied within the tolerance of {:.1g}", *constraint.tolerance)
                : ", satisfied";
}

}  // namespace

std::string record_text(const records::EvaluationRecord& record) {
  std::string text = fmt::format("  design {}: {}\n  {}\n", record.id, design_text(record),
                                 objectives_text(record));
  for (const auto& constraint : record.constraints) {
    text +=
        fmt::format("  {}: {}{}{}{}{}\n", designs::visible_text(constraint.name),
                    constraint.value ? fmt::format("{:.4g}", *constraint.value) : "no value",
                    constraint.lower ? fmt::format(", at least {:.4g}", *constraint.lower) : "",
                    constraint.upper ? fmt::format(", at most {:.4g}", *constraint.upper) : "",
                    state_text(constraint),
                    constraint.margin ? fmt::format(" (margin {:.4g})", *constraint.margin) : "");
  }
  return text + warnings_text(record.warnings);
}

}  // namespace parapet::cli
