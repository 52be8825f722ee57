#include "verdict_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "estimate_words.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

std::string runs_words(const Confirmation& confirmation) {
  const std::size_t runs = confirmation.runs.size();
  return fmt::format("{} further run{}", runs, runs == 1 ? "" : "s");
}

int broken_runs(const Confirmation& confirmation) {
  return static_cast<int>(std::ranges::count(confirmation.runs, false, &ConfirmingRun::feasible));
}

/// Whether a study's own limits need a simulation at all.
std::string tested_words(const Confirmation& confirmation) {
  if (!confirmation.constraints_tested) {
    return "the objectives came as predicted. No constraint needs a simulation, so none was put to "
           "the test";
  }
  return confirmation.objectives_tested
             ? "every constraint held and the objectives came as predicted"
             : "every constraint held. Nothing was predicted of the objectives (no surrogate)";
}

std::string refuted_words(const Confirmation& confirmation) {
  const std::size_t tried = confirmation.refuted.size();
  return fmt::format(
      "Not confirmed: the {} design{} tried did not hold when simulated again. The one shown is "
      "the rule's first; do not build it on this evidence",
      tried, tried == 1 ? "" : "s");
}

}  // namespace

std::string verdict_word(const Recommendation& advice) {
  const Confirmation& confirmation = *advice.confirmation;
  if (confirmation.verdict == study::Verdict::refuted) return "refuted";
  if (confirmation.verdict == study::Verdict::none) return "untested";
  const double probability = advice.recommended->probability_feasible.value_or(1.0);
  return broken_runs(confirmation) > 0 || probability < sure_probability ? "narrow" : "confirmed";
}

std::string verdict_words(const Recommendation& advice) {
  const Confirmation& confirmation = *advice.confirmation;
  const std::string word = verdict_word(advice);
  if (word == "refuted") return refuted_words(confirmation);
  if (word == "untested") {
    if (confirmation.runs.empty()) {
      return "Not confirmed: it was not simulated again. Run parapet recommend without "
             "--no-confirm";
    }
    return fmt::format(
        "Not put to the test: {} measured the scatter, but every constraint is a formula of "
        "the design and nothing was predicted of the objectives",
        runs_words(confirmation));
  }
  if (word == "confirmed") {
    return fmt::format("Confirmed by {}: {}", runs_words(confirmation), tested_words(confirmation));
  }
  const int broken = broken_runs(confirmation);
  return fmt::format(
      "Confirmed, narrowly: {}. The scatter decides; a tighter limit in the spec leaves a "
      "margin",
      broken > 0 ? fmt::format("{} of {} broke a constraint", broken, runs_words(confirmation))
                 : fmt::format("{} held, but a repeat meets every constraint with a probability of "
                               "{} only",
                               runs_words(confirmation),
                               probability_words(advice.recommended->probability_feasible)));
}

std::string limits_words(const Recommendation& advice) {
  const RecommendedDesign& recommended = *advice.recommended;
  const bool metric = std::ranges::any_of(recommended.repeat, [](const study::Expectation& one) {
    return one.role == study::Role::constraint;
  });
  if (!metric) {
    return recommended.design.constraints.empty()
               ? "constraints: none"
               : "constraints: all are formulas of the design, which it meets";
  }
  std::string words = "probability that a repeat meets every constraint: " +
                      probability_words(recommended.probability_feasible);
  if (!recommended.probability_feasible) words += " (its scatter was not measured)";
  return words;
}

}  // namespace parapet::reports
