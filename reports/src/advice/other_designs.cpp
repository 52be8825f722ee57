#include "other_designs.hpp"

#include <algorithm>
#include <cmath>

#include "design_advice.hpp"
#include "effects.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::reports {
namespace {

using records::EvaluationRecord;
using study::LoadedStudy;

constexpr double distinct_share = 0.05;  // of some variable's range, between alternatives
constexpr std::size_t most_alternatives = 5;

bool distinct(const designs::StudySpec& study, const EvaluationRecord& a,
              const EvaluationRecord& b) {
  return std::ranges::any_of(study.variables, [&](const designs::Variable& variable) {
    const auto one = a.design.find(variable.name), other = b.design.find(variable.name);
    if (one == a.design.end() || other == b.design.end()) {
      return (one == a.design.end()) != (other == b.design.end());
    }
    const double apart = std::abs(one->second - other->second);
    if (variable.kind == designs::VariableKind::choice) return apart > 0.0;
    return apart >= distinct_share * (variable.upper - variable.lower) && apart > 0.0;
  });
}

/// The best starting design that meets every constraint, else the least violating one.
const EvaluationRecord* best_start(const LoadedStudy& study) {
  for (const bool feasible : {true, false}) {
    for (const EvaluationRecord* design : study::ranked_designs(study, feasible)) {
      if (design->stage == "start") return design;
    }
  }
  return nullptr;
}

ObjectiveChange objective_change(const designs::Objective& objective,
                                 const std::optional<double>& start,
                                 const std::optional<double>& best) {
  ObjectiveChange result{.name = study::objective_name(objective),
                         .of = objective.metric.empty() ? objective.expression : objective.metric,
                         .goal = objective.goal,
                         .start = start,
                         .best = best,
                         .change = {},
                         .change_percent = {},
                         .better = {}};
  if (!start || !best) return result;
  const double change = *best - *start;
  result.change = change;
  result.change_percent = percent(change, start);
  result.better = objective.goal == designs::Goal::maximize ? change > 0.0 : change < 0.0;
  return result;
}

/// Twice the scatter about a fit of the study's only objective, where that predicts; else 0. A
/// formula is exact: the scatter of some other metric says nothing about it.
double tie_width(const designs::StudySpec& study, const std::vector<MetricResponse>& effects) {
  const std::string& metric = study.objectives.front().metric;
  if (metric.empty() || effects.empty()) return 0.0;
  const MetricResponse& fit = effects.front();
  return fit.r2_left_out && *fit.r2_left_out >= rough_r2 ? 2.0 * fit.scatter.value() : 0.0;
}

}  // namespace

std::optional<Improvement> improvement(const LoadedStudy& study, const EvaluationRecord& best) {
  const EvaluationRecord* start = best_start(study);
  if (start == nullptr) return std::nullopt;
  Improvement result{.start_id = start->id,
                     .start_feasible = start->feasible,
                     .same_design = start->id == best.id,
                     .start_design = written_design(study.spec, start->design),
                     .scalar_start = start->objective_scalar,
                     .scalar_best = best.objective_scalar,
                     .objectives = {}};
  for (std::size_t j = 0; j < study.spec.objectives.size(); ++j) {
    result.objectives.push_back(objective_change(
        study.spec.objectives[j], start->objectives.at(j).value, best.objectives.at(j).value));
  }
  return result;
}

std::vector<Alternative> alternatives(const LoadedStudy& study, const EvaluationRecord& best,
                                      const std::vector<MetricResponse>& effects) {
  std::vector<Alternative> list;
  std::vector<const EvaluationRecord*> chosen{&best};
  const bool one_objective = study.spec.objectives.size() == 1;
  for (const EvaluationRecord* design : study::ranked_designs(study, true)) {
    if (list.size() == most_alternatives) break;
    const bool apart = std::ranges::all_of(chosen, [&](const EvaluationRecord* other) {
      return distinct(study.spec, *design, *other);
    });
    if (!apart) continue;
    chosen.push_back(design);
    list.push_back({design_report(study.spec, *design), std::nullopt});
    if (!one_objective) continue;
    const double behind =
        std::abs(best.objectives.at(0).value.value() - design->objectives.at(0).value.value());
    list.back().within_scatter = behind < tie_width(study.spec, effects);
  }
  return list;
}

}  // namespace parapet::reports
