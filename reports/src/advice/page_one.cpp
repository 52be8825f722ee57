#include "parapet/reports/page_one.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "design_text.hpp"
#include "estimate_words.hpp"
#include "key_text.hpp"
#include "markdown.hpp"
#include "verdict_words.hpp"

namespace parapet::reports {
namespace {

using study::Expectation;
using study::Role;

PageOneLine line_of(const Expectation& one, std::string label, const std::string& unit_key,
                    std::string asked) {
  PageOneLine line{.label = std::move(label),
                   .text = estimate_words(one, unit_key),
                   .asked = std::move(asked),
                   .mean = {},
                   .lower_95 = {},
                   .upper_95 = {},
                   .probability = one.probability};
  if (!one.estimate) return line;
  line.mean = one.estimate->mean;
  line.lower_95 = one.estimate->lower_95();
  line.upper_95 = one.estimate->upper_95();
  return line;
}

/// "design force on barrier 1" of "barrier_1_design_force_n_per_m".
std::string load_label(const Expectation& load) {
  return fmt::format("design {} on barrier {}",
                     load.metric.find("_moment_") == std::string::npos ? "force" : "moment",
                     load.place);
}

std::string limit_words(const Expectation& limit) {
  if (limit.lower && limit.upper) {
    return fmt::format("{} to {}", number_text(limit.lower),
                       with_unit(limit.upper, unit_key(limit)));
  }
  return limit.lower ? "at least " + with_unit(limit.lower, unit_key(limit))
                     : "at most " + with_unit(limit.upper, unit_key(limit));
}

/// Of a study over a distribution what the surrogates of design and event say of an objective; the
/// line itself is about the events that are simulated, as a repeat of the runs would be.
std::string over_drawn_events(const Recommendation& advice, std::size_t objective) {
  const auto& estimates = advice.recommended->estimates;
  if (!advice.study.events || objective >= estimates.size()) return "";
  const study::Estimate& one = estimates[objective].estimate;
  if (!one.median || !one.lower_95 || !one.upper_95) return "";
  return fmt::format("; over {} drawn events {} ({} to {})", advice.study.events->drawn,
                     number_text(one.median), number_text(one.lower_95), number_text(one.upper_95));
}

void add_lines(PageOne& page, const Recommendation& advice) {
  for (const Expectation& one : advice.recommended->repeat) {
    if (one.role == Role::objective) {
      const ObjectiveTerms& terms = advice.study.objectives.at(one.place);
      page.performance.push_back(line_of(
          one, objective_name(terms), objective_unit_key(terms),
          fmt::format("to be {}d{}", goal_word(terms.goal), over_drawn_events(advice, one.place))));
    } else if (one.role == Role::constraint) {
      const ConstraintResult& constraint = advice.recommended->design.constraints.at(one.place);
      std::string label = key_words(unit_key(one));
      if (!constraint.statistic.empty()) label += ", " + constraint.statistic;
      page.limits.push_back(line_of(one, std::move(label), unit_key(one), limit_words(one)));
    } else {
      page.loads.push_back(line_of(one, load_label(one), one.metric, ""));
    }
  }
}

std::string rule_name(const RuleFacts& rule) {
  switch (rule.kind) {
    case study::RuleKind::knee:
      return "the knee of the front";
    case study::RuleKind::balanced:
      return rule.no_knee ? "the balanced design of the front, which has no knee"
                          : "the balanced design of the front";
    case study::RuleKind::weights:
      return "the least weighted sum of the scaled objectives";
    case study::RuleKind::limits:
      return "the best first objective within the rule's limits";
    case study::RuleKind::automatic:
    case study::RuleKind::best:
      break;
  }
  return "the best value of what is asked";
}

std::string chosen_words(const RuleFacts& rule) {
  std::string words = "chosen as " + rule_name(rule);
  if (rule.share) {
    words +=
        fmt::format(", in {:.0f} % of {} draws of the surrogates", 100.0 * *rule.share, rule.draws);
  }
  return words;
}

std::string tie_words(const Recommendation& advice, const std::string& recommended) {
  const RuleFacts& rule = advice.rule;
  if (rule.draws == 0) return "ties: not known (the study has no surrogate)";
  if (rule.ties.empty())
    return "ties: none; to each other design the rule prefers this one in 95 % of the draws";
  constexpr std::size_t most_named = 5;
  std::vector<std::string> names;
  for (const TiedDesign& one : rule.ties) {
    if (names.size() == most_named) {
      names.push_back(fmt::format("{} more", rule.ties.size() - most_named));
      break;
    }
    names.push_back(fmt::format("{} ({:.0f} %)", one.id, 100.0 * one.share));
  }
  std::string words = "ties: the data cannot tell it from " + joined(names);
  if (rule.first_by_rule == recommended) return words;
  const bool refuted =
      advice.confirmation &&
      std::ranges::count(advice.confirmation->refuted, rule.first_by_rule, &RefutedDesign::id) > 0;
  words += refuted
               ? fmt::format("; {}, which the rule puts first, did not hold when simulated again",
                             rule.first_by_rule)
               : fmt::format("; it has more margin than {}, which the rule puts first",
                             rule.first_by_rule);
  return words;
}

std::string bound_words(const DesignReport& design) {
  std::vector<std::string> at;
  for (const VariableResult& one : design.variables) {
    if (one.at_bound == Bound::none) continue;
    at.push_back(fmt::format("{} at its {} bound", key_words(one.name),
                             one.at_bound == Bound::lower ? "lower" : "upper"));
  }
  if (at.empty()) return "bounds: no variable is at an end of its range";
  return "bounds: " + joined(at) + "; a wider range might give a better design";
}

std::string grid_words(const Recommendation& advice) {
  const RecommendedDesign& recommended = *advice.recommended;
  bool unknown = false, levels = false, run = false;
  for (const Expectation& one : recommended.repeat) {
    if (one.exact || !one.estimate || one.role == Role::load) continue;
    unknown = unknown || one.estimate->grid_source == study::GridSource::none;
    levels = levels || one.estimate->grid_source == study::GridSource::levels;
    run = run || one.estimate->grid_source == study::GridSource::other_run;
  }
  const std::string base = fmt::format("{:.4g} mm", 1000.0 * recommended.repeat_spacing);
  if (unknown) {
    return fmt::format(
        "particle spacing {}: grid uncertainty not known and not in these figures; "
        "--confirm-spacing-mm {:.3g} gives it",
        base, 700.0 * recommended.repeat_spacing);
  }
  if (!levels && !run) return "";
  return fmt::format("particle spacing {}: grid uncertainty {}, in these figures", base,
                     run ? "from a run at another spacing" : "from the study's spacings");
}

/// What stands in for an arrangement when none is recommended.
void say_none(PageOne& page, const Recommendation& advice) {
  const StudyFacts& study = advice.study;
  page.title = "No arrangement to recommend: " + study.spec.name;
  page.verdict = "none";
  page.verdict_words = "nothing is recommended";
  const auto counted =
      std::ranges::find(study.spacings, study.counted_spacing, &SpacingCount::spacing);
  const SpacingCount count = counted == study.spacings.end() ? SpacingCount{} : *counted;
  if (advice.rule.allows_none) {
    page.instead = fmt::format(
        "{} designs meet every constraint, but none of them the rule's limits on objectives. "
        "{} The front below shows what can be had.",
        count.feasible, advice.rule.words);
    return;
  }
  page.instead =
      fmt::format("None of the {} designs simulated at {:.4g} mm meets every constraint. ",
                  count.designs, 1000.0 * study.counted_spacing);
  if (!advice.least_violating) {
    page.instead += "No simulation succeeded either.";
    return;
  }
  const DesignReport& nearest = advice.least_violating->design;
  page.design = nearest.id;
  page.arrangement = design_words(nearest.design);
  page.instead += fmt::format(
      "The one that misses them least is design {}: {}. It is shown below to help in changing the "
      "spec, not as advice to build it.",
      nearest.id, page.arrangement);
}

}  // namespace

PageOne page_one(const Recommendation& advice) {
  PageOne page;
  if (!advice.recommended) {
    say_none(page, advice);
    return page;
  }
  const RecommendedDesign& recommended = *advice.recommended;
  page.title = "Recommended arrangement: " + advice.study.spec.name;
  page.design = recommended.design.id;
  page.arrangement = design_words(recommended.design.design);
  page.sketch = recommended.sketch;
  add_lines(page, advice);
  page.probability = recommended.probability_feasible;
  page.probability_words = limits_words(advice);
  page.chosen = chosen_words(advice.rule);
  page.ties = tie_words(advice, page.design);
  page.bounds = bound_words(recommended.design);
  page.grid = grid_words(advice);
  page.verdict = verdict_word(advice);
  page.verdict_words = verdict_words(advice);
  return page;
}

}  // namespace parapet::reports
