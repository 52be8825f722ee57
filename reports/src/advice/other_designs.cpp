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

/// Twice the residuals of a fit of the study's only objective, where that predicts, or twice its
/// scatter as measured, where that is more; else 0. A formula is exact: the scatter of some other
/// metric says nothing about it.
double tie_width(const designs::StudySpec& study, const std::vector<MetricResponse>& effects,
                 const std::vector<Spread>& spread) {
  const std::string& metric = study.objectives.front().metric;
  if (metric.empty()) return 0.0;
  const auto measured = std::ranges::find(spread, metric, &Spread::metric);
  double scatter = measured == spread.end() ? 0.0 : measured->standard_deviation;
  if (!effects.empty() && effects.front().r2_left_out.value_or(0.0) >= rough_r2) {
    scatter = std::max(scatter, effects.front().scatter.value());
  }
  return 2.0 * scatter;
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
                                      const std::vector<MetricResponse>& effects,
                                      const std::vector<Spread>& spread, const RuleFacts& rule) {
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
    list.back().within_scatter =
        rule.draws > 0 ? std::ranges::count(rule.ties, design->id, &TiedDesign::id) > 0
                       : behind < tie_width(study.spec, effects, spread);
  }
  return list;
}

}  // namespace parapet::reports
