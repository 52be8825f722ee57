#include "confirmation_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "design_text.hpp"
#include "key_text.hpp"
#include "markdown.hpp"
#include "verdict_words.hpp"

namespace parapet::reports {
namespace {

std::string probability_text(const Recommendation& advice) {
  std::string text = "As simulated it meets every constraint; " + limits_words(advice) + ".";
  if (advice.rule.all_doubtful) {
    text += " **No design that the rule allows reaches 50 %**: each may be here by chance.";
  }
  if (const auto limits = advice.recommended->probability_limits) {
    text += fmt::format(
        " That it meets the rule's limits on objectives has a probability of {:.0f} % (objectives "
        "taken as independent).",
        100.0 * *limits);
  }
  return text;
}

std::string estimates_table(const std::vector<ObjectiveEstimate>& estimates) {
  std::vector<std::vector<std::string>> rows{
      {"objective", "simulated", "surrogate (95 % interval)", "simulated value is"}};
  bool any = false;
  for (const ObjectiveEstimate& objective : estimates) {
    const auto &value = objective.value, &lower = objective.estimate.lower_95,
               &upper = objective.estimate.upper_95;
    if (!objective.terms.expression.empty() && !lower) continue;  // a formula, known exactly
    any = any || lower;
    const char* place = !lower || !upper || !value             ? "-"
                        : *value >= *lower && *value <= *upper ? "within the interval"
                                                               : "outside: scatter, or a bad model";
    rows.push_back({objective_label(objective.terms), number_text(value),
                    estimate_text(objective.estimate), place});
  }
  return any ? table(rows, "lrrl") : "";
}

std::string run_name(const ConfirmingRun& run) {
  const bool near = run.stage == study::confirmation_stage::near;
  return fmt::format("{}, at {:.4g} mm", near ? "near it" : "the design itself",
                     1000.0 * run.spacing);
}

std::string runs_table(const Recommendation& advice) {
  std::vector<std::vector<std::string>> rows{{"run", "what"}};
  std::string alignment = "ll";
  const std::vector<ObjectiveResult>& objectives = advice.recommended->design.objectives;
  for (const ObjectiveResult& objective : objectives) {
    rows[0].push_back(objective_label(objective.terms));
    alignment += 'r';
  }
  rows[0].push_back("constraints");
  alignment += 'l';
  const bool predicted = advice.confirmation->objectives_tested;
  if (predicted) {
    rows[0].push_back("objectives");
    alignment += 'l';
  }
  const auto add = [&](const std::string& id, const std::string& what,
                       const std::vector<std::optional<double>>& values, const std::string& state,
                       const std::string& worse) {
    std::vector<std::string> row{id, what};
    for (std::size_t j = 0; j < objectives.size(); ++j) {
      row.push_back(j < values.size() ? number_text(values[j]) : "-");
    }
    row.push_back(state);
    if (predicted) row.push_back(worse.empty() ? "as predicted" : "**worse**: " + worse);
    rows.push_back(std::move(row));
  };
  std::vector<std::optional<double>> own;
  for (const ObjectiveResult& objective : objectives) own.push_back(objective.value);
  add(advice.recommended->design.id, "the study's own run", own, "all hold", "");
  for (const ConfirmingRun& run : advice.confirmation->runs) {
    add(run.id, run_name(run), run.objectives,
        !run.ok                ? "failed: " + run.reason
        : run.violated.empty() ? "all hold"
                               : "**violated**: " + joined(run.violated),
        joined(run.worse));
  }
  return table(rows, alignment);
}

/// What is rounding alone counts as none.
std::string deviation_text(const Spread& spread) {
  const double size = std::max(std::abs(spread.least), std::abs(spread.greatest));
  const double deviation = spread.standard_deviation;
  return deviation <= 1e-12 * size ? "0" : fmt::format("{:.2g}", deviation);
}

std::string spread_text(const std::vector<Spread>& spread) {
  if (spread.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"quantity", "runs", "least", "greatest", "s.d."}};
  for (const Spread& one : spread) {
    rows.push_back({fmt::format("{}{}", key_words(one.name), bracketed_unit(one.metric)),
                    std::to_string(one.runs), number_text(one.least), number_text(one.greatest),
                    deviation_text(one)});
  }
  return "The design and those near it differ by half a per cent of each variable's range, which "
         "no "
         "construction work could tell apart, and were simulated at one spacing. So the "
         "differences "
         "between them are scatter, and a difference between two designs that is not larger means "
         "nothing.\n\n" +
         table(rows, "lrrrr");
}

std::string why_refuted(const RefutedDesign& one) {
  std::vector<std::string> reasons;
  if (!one.violated.empty()) reasons.push_back(joined(one.violated) + " was violated");
  if (!one.worse.empty()) reasons.push_back(joined(one.worse) + " was worse than predicted");
  return reasons.empty() ? " (a simulation failed)" : ": " + joined(reasons);
}

std::string refuted_text(const Confirmation& confirmation) {
  std::string text;
  const bool all = confirmation.verdict == study::Verdict::refuted;
  for (const RefutedDesign& one : confirmation.refuted) {
    text +=
        fmt::format("Design {}, which the rule {}, did not hold when it was simulated again{}.\n\n",
                    one.id, all ? "ranks high" : "prefers", why_refuted(one));
  }
  return text;
}

/// Ids of the confirmation's runs that lie outside the rule's limits on objectives.
std::vector<std::string> runs_outside_limits(const Recommendation& advice) {
  std::vector<std::string> ids;
  const std::vector<ObjectiveTerms>& objectives = advice.study.objectives;
  for (const ConfirmingRun& run : advice.confirmation->runs) {
    bool outside = false;
    for (const study::ObjectiveLimit& limit : advice.rule.limits) {
      for (std::size_t j = 0; j < run.objectives.size() && j < objectives.size(); ++j) {
        const bool meant =
            objectives[j].name == limit.objective || objectives[j].metric == limit.objective;
        const auto& value = run.objectives[j];
        if (!meant || !value) continue;
        outside = outside || *value > limit.upper.value_or(*value) ||
                  *value < limit.lower.value_or(*value);
      }
    }
    if (outside) ids.push_back(run.id);
  }
  return ids;
}

std::string limits_text(const Recommendation& advice) {
  const std::vector<std::string> ids = runs_outside_limits(advice);
  if (ids.empty()) return "";
  return fmt::format(
      "**The rule's limits on objectives do not hold in every run**: {} lie{} outside. They chose "
      "the design and are no constraints of the study, so this does not refute it.\n\n",
      joined(ids), ids.size() == 1 ? "s" : "");
}

/// What the estimates of a study over a distribution of events rest on.
std::string events_text(const StudyFacts& study) {
  if (!study.events) return "";
  const study::EventBasis& basis = *study.events;
  std::string text = fmt::format(
      "Simulated are {} events. The surrogate's column is the statistic over {} events drawn from "
      "the "
      "distributions, by surrogates of design and event together, from {} designs. How well these "
      "predict "
      "an event that they have not seen (each event left out in turn):\n\n",
      basis.simulated, basis.drawn, basis.designs);
  std::vector<std::vector<std::string>> rows{
      {"metric", "root mean square error", "Q²", "within 95 %"}};
  for (const study::EventError& error : basis.errors) {
    rows.push_back({key_label(error.metric), number_text(error.rmse), number_text(error.q_squared),
                    error.coverage_95 ? fmt::format("{:.0f} %", 100.0 * *error.coverage_95) : "-"});
  }
  return text + table(rows, "lrrr");
}

}  // namespace

std::string confirmation_section(const Recommendation& advice) {
  if (!advice.recommended) return "";
  const Confirmation& confirmation = *advice.confirmation;
  std::string text = "## How sure\n\n" + probability_text(advice) + "\n\n";
  text += estimates_table(advice.recommended->estimates);
  text += events_text(advice.study);
  text += refuted_text(confirmation) + verdict_words(advice) + ".\n\n";
  text += limits_text(advice);
  if (!confirmation.runs.empty()) text += runs_table(advice) + spread_text(confirmation.spread);
  return text;
}

}  // namespace parapet::reports
