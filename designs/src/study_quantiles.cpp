#include <cmath>

#include "study_parts.hpp"

namespace parapet::designs {
namespace {

/// "57 %".
std::string percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + " %";
}

/// Adds an issue where n events do not bound a goal's quantile.
template <typename Goal>
void check_quantile(const Goal& goal, std::size_t n, const std::string& pointer,
                    Findings& findings) {
  const double q = goal.quantile;
  if (goal.statistic != Statistic::quantile || worst_confidence(q, n) >= event_confidence) return;
  const std::string count = std::to_string(n);
  if (q >= 1.0) {
    findings.add(pointer + "/quantile",
                 "is the worst of all events, which no number of them bounds",
                 "a number below 1, or the statistic \"worst\"");
    return;
  }
  const auto needed = static_cast<long>(std::ceil(std::log(1.0 - event_confidence) / std::log(q)));
  const double bounded = std::pow(1.0 - event_confidence, 1.0 / static_cast<double>(n));
  findings.add(pointer + "/quantile",
               "cannot be told from " + count + " events: the worst of them bounds it with only " +
                   percent(worst_confidence(q, n)) + " confidence",
               "at least " + std::to_string(needed) +
                   " events, or the statistic \"worst\", which of " + count + " bounds the " +
                   rounded(bounded) + " quantile with " + percent(event_confidence));
}

}  // namespace

double worst_confidence(double quantile, std::size_t n_events) {
  return 1.0 - std::pow(quantile, static_cast<double>(n_events));
}

void check_quantiles(const StudySpec& study, Findings& findings) {
  if (study.scenarios.empty()) return;
  const bool has_surrogates = search_kind(study) == SearchKind::bayesian;
  if (!study.event_variables.empty() && has_surrogates) return;
  for (std::size_t k = 0; k < study.objectives.size(); ++k) {
    check_quantile(study.objectives[k], study.scenarios.size(), child_pointer("/objectives", k),
                   findings);
  }
  for (std::size_t k = 0; k < study.constraints.size(); ++k) {
    check_quantile(study.constraints[k], study.scenarios.size(), child_pointer("/constraints", k),
                   findings);
  }
}

}  // namespace parapet::designs
