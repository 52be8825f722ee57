#include "design_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "design_text.hpp"
#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

std::string limit_words(const ConstraintResult& constraint) {
  const auto &lower = constraint.lower, &upper = constraint.upper;
  if (lower && upper) return fmt::format("{} to {}", number_text(lower), number_text(upper));
  return lower ? "at least " + number_text(lower) : "at most " + number_text(upper);
}

std::string bound_words(Bound bound) {
  if (bound == Bound::none) return "";
  return fmt::format("at its {} bound", bound == Bound::lower ? "lower" : "upper");
}

std::string state_words(const ConstraintResult& constraint) {
  if (!constraint.satisfied) return "**violated**";
  // Rounding may carry a value beyond its limit: the judge's tolerance is 1e-9 of the scale.
  if (constraint.margin && *constraint.margin < 0.0) return "holds within the tolerance";
  if (constraint.active) return "active";
  return constraint.value ? "holds" : "holds (no value)";
}

/// A metric's value; empty where it is missing or not finite.
std::optional<double> value_of(const solver::Metric& metric) {
  return metric.value && std::isfinite(*metric.value) ? metric.value : std::nullopt;
}

std::optional<double> metric_value(const DesignReport& design, const std::string& key) {
  const auto found = std::ranges::find(design.metrics, key, &solver::Metric::key);
  return found == design.metrics.end() ? std::nullopt : value_of(*found);
}

}  // namespace

std::string variables_section(const DesignReport& design) {
  std::vector<std::vector<std::string>> rows{{"variable", "value", "range allowed", ""}};
  for (const VariableResult& variable : design.variables) {
    const std::string& name = variable.name;
    if (!variable.options.empty()) {
      rows.push_back({key_words(name), variable.option, joined(variable.options), ""});
      continue;
    }
    rows.push_back(
        {key_words(name), with_unit(variable.value, name),
         fmt::format("{} to {}", number_text(variable.lower), with_unit(variable.upper, name)),
         bound_words(variable.at_bound)});
  }
  return "## The design\n\n" + table(rows, "lrll");
}

std::string margins_section(const DesignReport& design) {
  if (design.constraints.empty()) return "";
  std::vector<std::vector<std::string>> rows{
      {"constraint", "value", "limit", "margin", "of the limit", "state"}};
  for (const ConstraintResult& constraint : design.constraints) {
    rows.push_back({constraint_label(constraint), number_text(constraint.value),
                    limit_words(constraint), signed_text(constraint.margin),
                    percent_text(constraint.margin_percent), state_words(constraint)});
  }
  return "## Margins\n\nA margin is the distance to the nearer limit, negative outside it; below 2 "
         "% "
         "of the limit the constraint is called active.\n\n" +
         table(rows, "lrlrrl");
}

std::string hand_formula_section(const DesignReport& design) {
  const auto simulated = metric_value(design, "launch_length_m");
  const auto formula = metric_value(design, "ballistic_launch_length_m");
  if (!simulated || !formula) return "";
  const std::string share =
      *simulated != 0.0 ? fmt::format(" ({:+.0f} %)", 100.0 * (*formula / *simulated - 1.0)) : "";
  return fmt::format(
      "## Launch length against the hand formula\n\nThe simulation lands the overflow {} m from "
      "the barrier's foot; the ballistic formula that engineers use (a point mass thrown where the "
      "overflow crosses the barrier's line, with the simulated speed and angle) gives {} m{}.\n\n",
      number_text(simulated), number_text(formula), share);
}

std::string load_formulas_section(const DesignReport& design) {
  std::vector<std::vector<std::string>> rows{
      {"barrier", "design force", "alpha of alpha rho v^2 h", "k of k rho g h^2/2"}};
  for (int k = 1;; ++k) {
    const std::string barrier = fmt::format("barrier_{}_", k);
    const auto force = metric_value(design, barrier + "design_force_n_per_m");
    if (!force) break;
    const auto alpha = metric_value(design, barrier + "hydrodynamic_coefficient");
    const auto static_k = metric_value(design, barrier + "hydrostatic_coefficient");
    if (!alpha && !static_k) continue;
    rows.push_back({fmt::format("{}", k), number_text(force) + " N/m", number_text(alpha),
                    number_text(static_k)});
  }
  if (rows.size() == 1) return "";
  return "## Loads against the hand formulas\n\nThe coefficients with which the two formulas give "
         "the "
         "simulated design force, for the velocity v and the depth h of the same event without "
         "barriers at the barrier's foot (approach.json). Compare them with the values of your "
         "code; "
         "Huebl et al. 2009 (Debris flow impact estimation, Ohrid) and Scheidl et al. 2013 (doi "
         "10.1007/s10712-012-9199-6) collect measured ones.\n\n" +
         table(rows, "rrrr");
}

std::string metrics_section(const DesignReport& design,
                            const std::vector<std::pair<std::string, std::string>>& definitions) {
  const std::map<std::string, std::string> meaning(definitions.begin(), definitions.end());
  std::vector<std::vector<std::string>> rows{{"metric", "value", "meaning"}};
  std::map<std::string, std::vector<std::string>> absent;  // reason -> metrics
  for (const solver::Metric& metric : design.metrics) {
    const std::string words = key_words(metric.key);
    const std::optional<double> value = value_of(metric);
    if (!value) {
      absent[metric.value ? "no reason given" : metric.absent_reason].push_back(words);
      continue;
    }
    const auto found = meaning.find(metric.key);
    rows.push_back(
        {words, with_unit(value, metric.key), found == meaning.end() ? "" : found->second});
  }
  std::string text = "## Everything measured\n\n" + table(rows, "lrl");
  for (const auto& [reason, keys] : absent) {
    text += fmt::format("Without a value ({}): {}.\n\n", reason, joined(keys));
  }
  return text;
}

}  // namespace parapet::reports
