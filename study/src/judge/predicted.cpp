#include "parapet/study/predicted.hpp"

#include <algorithm>

#include "parapet/study/expected.hpp"
#include "parapet/study/goal_quantity.hpp"
#include "parapet/study/quantity.hpp"

namespace parapet::study {
namespace {

/// A prediction as it holds for a run; empty where it says nothing of it.
std::optional<RepeatEstimate> for_run(const std::optional<RepeatEstimate>& prediction,
                                      const Pick& pick, const records::EvaluationRecord& run) {
  if (!prediction || !prediction->scatter) return std::nullopt;
  if (run.spacing != pick.spacing) return prediction->grid ? prediction : std::nullopt;
  RepeatEstimate here = *prediction;
  here.grid.reset();
  return here;
}

/// Of an expression of metrics what the pick itself would have with the run's metrics: that a
/// design near it has longer plates is no surprise.
std::optional<double> value_for(const designs::StudySpec& study, std::size_t j, const Pick& pick,
                                const records::EvaluationRecord& run) {
  const designs::Objective& objective = study.objectives[j];
  if (!objective.metric.empty() || objective.is_of_design()) return run.objectives[j].value;
  return quantity_value(study, objective_quantity(study, objective), pick.design, events_of(run))
      .value;
}

}  // namespace

std::vector<std::size_t> worse_than_predicted(const designs::StudySpec& study, const Pick& pick,
                                              const records::EvaluationRecord& run) {
  std::vector<std::size_t> worse;
  const std::size_t count =
      std::min({pick.predicted.size(), run.objectives.size(), study.objectives.size()});
  for (std::size_t j = 0; j < count; ++j) {
    const auto prediction = for_run(pick.predicted[j], pick, run);
    const auto value = value_for(study, j, pick, run);
    if (!prediction || !value) continue;
    const bool low = *value < prediction->lower_95().value();
    const bool high = *value > prediction->upper_95().value();
    if (study.objectives[j].goal == designs::Goal::maximize ? low : high) worse.push_back(j);
  }
  return worse;
}

ConfirmationRun confirmation_run(const designs::StudySpec& study, const Pick& pick,
                                 const records::EvaluationRecord& run) {
  const bool predicted = std::ranges::any_of(
      pick.predicted, [&](const auto& one) { return for_run(one, pick, run).has_value(); });
  return {.id = run.id,
          .stage = run.stage,
          .feasible = run.ok && run.feasible,
          .as_predicted = worse_than_predicted(study, pick, run).empty(),
          .tested = predicted || has_metric_constraint(study)};
}

}  // namespace parapet::study
