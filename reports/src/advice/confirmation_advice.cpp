#include "confirmation_advice.hpp"

#include <algorithm>
#include <cmath>

#include "design_advice.hpp"

namespace parapet::reports {
namespace {

using records::EvaluationRecord;

ConfirmingRun run_of(const EvaluationRecord& record) {
  ConfirmingRun run{.id = record.id,
                    .stage = record.stage,
                    .spacing = record.spacing,
                    .ok = record.ok,
                    .reason = record.reason,
                    .feasible = record.ok && record.feasible,
                    .objectives = {},
                    .violated = {}};
  for (const records::ObjectiveRecord& objective : record.objectives) {
    run.objectives.push_back(objective.value);
  }
  for (const records::ConstraintRecord& constraint : record.constraints) {
    if (!constraint.satisfied) run.violated.push_back(constraint.name);
  }
  return run;
}

Spread spread_of(const std::string& name, const std::string& metric,
                 const std::vector<double>& values) {
  const auto [least, greatest] = std::ranges::minmax(values);
  double mean = 0.0, squares = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {.name = name,
          .metric = metric,
          .runs = static_cast<int>(values.size()),
          .least = least,
          .greatest = greatest,
          .standard_deviation = std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

/// How far the answer moves between the design and those near to it, at one spacing: for each
/// objective, and for each constraint with a value.
std::vector<Spread> spreads(const designs::StudySpec& study, const EvaluationRecord& pick,
                            const std::vector<const EvaluationRecord*>& near) {
  std::vector<Spread> list;
  const auto add = [&](const std::string& name, const std::string& metric, auto value_in) {
    std::vector<double> values;
    if (const auto own = value_in(pick)) values.push_back(*own);
    for (const EvaluationRecord* run : near) {
      if (const auto value = value_in(*run)) values.push_back(*value);
    }
    if (values.size() > 1) list.push_back(spread_of(name, metric, values));
  };
  std::vector<ObjectiveTerms> objectives;
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    objectives.push_back(terms_of(study, study.objectives[j]));
    if (objectives.back().metric.empty()) continue;
    add(objectives.back().name, objectives.back().metric, [j](const EvaluationRecord& record) {
      return j < record.objectives.size() ? record.objectives[j].value : std::nullopt;
    });
  }
  for (std::size_t k = 0; k < study.constraints.size(); ++k) {
    const designs::Constraint& constraint = study.constraints[k];
    const std::string statistic =
        statistic_words(study, constraint.metric, constraint.statistic, constraint.quantile);
    const bool told = std::ranges::any_of(objectives, [&](const ObjectiveTerms& objective) {
      return objective.metric == constraint.metric && objective.statistic == statistic;
    });
    if (constraint.metric.empty() || told) continue;
    add(constraint.name, constraint.metric, [k](const EvaluationRecord& record) {
      return k < record.constraints.size() ? record.constraints[k].value : std::nullopt;
    });
  }
  return list;
}

RefutedDesign refuted_design(const study::LoadedStudy& study, const std::string& id) {
  RefutedDesign result{.id = id, .violated = {}};
  for (const EvaluationRecord& run : study.confirmations) {
    if (!study::confirms(run.id, id)) continue;
    for (const records::ConstraintRecord& constraint : run.constraints) {
      const bool known = std::ranges::count(result.violated, constraint.name) > 0;
      if (!constraint.satisfied && !known) result.violated.push_back(constraint.name);
    }
  }
  return result;
}

}  // namespace

Confirmation confirmation_of(const study::LoadedStudy& study,
                             const study::ConfirmedPick& confirmed) {
  const EvaluationRecord& pick = *confirmed.pick->design;
  Confirmation result{.verdict = confirmed.verdict, .runs = {}, .spread = {}, .refuted = {}};
  std::vector<const EvaluationRecord*> near;
  std::vector<const EvaluationRecord*> runs;
  for (const EvaluationRecord& run : study.confirmations) {
    if (study::confirms(run.id, pick.id)) runs.push_back(&run);
  }
  // The file has the order in which they ended.
  std::ranges::sort(runs, {}, &EvaluationRecord::id);
  for (const EvaluationRecord* run : runs) {
    result.runs.push_back(run_of(*run));
    if (run->stage == study::confirmation_stage::near && run->ok) near.push_back(run);
  }
  result.spread = spreads(study.spec, pick, near);
  for (const study::Candidate* candidate : confirmed.refuted) {
    result.refuted.push_back(refuted_design(study, candidate->design->id));
  }
  return result;
}

}  // namespace parapet::reports
