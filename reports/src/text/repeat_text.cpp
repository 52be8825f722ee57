#include "repeat_text.hpp"

#include <fmt/format.h>

#include "design_text.hpp"
#include "estimate_words.hpp"
#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

using study::Expectation;

std::string label_of(const Expectation& one, const Recommendation& advice) {
  if (one.role == study::Role::objective) {
    return objective_label(advice.study.objectives.at(one.place));
  }
  return key_label(unit_key(one));
}

std::string size_text(const std::optional<double>& value) {
  return value ? fmt::format("{:.2g}", *value) : "not known";
}

std::string interval_text(const study::RepeatEstimate& estimate) {
  const auto lower = estimate.lower_95(), upper = estimate.upper_95();
  if (!lower || !upper) return "not known";
  return fmt::format("{} to {}", number_text(lower), number_text(upper));
}

}  // namespace

std::string repeat_section(const Recommendation& advice) {
  if (!advice.recommended) return "";
  std::vector<std::vector<std::string>> rows{
      {"quantity", "mean", "95 % of repeats", "scatter", "of the mean", "grid", "runs", "holds"}};
  for (const Expectation& one : advice.recommended->repeat) {
    const bool limited = one.role == study::Role::constraint;
    const std::string holds = limited ? probability_words(one.probability) : "";
    if (!one.estimate) {
      rows.push_back({label_of(one, advice), "-", "-", "-", "-", "-", "-", holds});
      continue;
    }
    const study::RepeatEstimate& estimate = *one.estimate;
    if (one.exact) {
      rows.push_back({label_of(one, advice), number_text(estimate.mean), "a formula: exact", "0",
                      "0", "0", "-", ""});
      continue;
    }
    rows.push_back({label_of(one, advice), number_text(estimate.mean), interval_text(estimate),
                    size_text(estimate.scatter),
                    estimate.scatter ? size_text(estimate.mean_uncertainty) : "not known",
                    size_text(estimate.grid), std::to_string(estimate.runs), holds});
  }
  return fmt::format(
             "## What a repeat gives\n\nOne more run of the built design, at {:.4g} mm. Scatter "
             "(s.d. "
             "of a run): the surrogate's noise and the runs of the design and those near it, "
             "pooled. "
             "Mean: the surrogate's estimate, which knows the study's own run, with the further "
             "runs; "
             "without a surrogate the mean of all runs. Grid: the difference between particle "
             "spacings, as one standard uncertainty. All three are in the interval (Student's t), "
             "which "
             "keeps to values that can be. The last column is the probability that a repeat meets "
             "the limit.\n\n",
             1000.0 * advice.recommended->repeat_spacing) +
         table(rows, "lrrrrrrr");
}

}  // namespace parapet::reports
