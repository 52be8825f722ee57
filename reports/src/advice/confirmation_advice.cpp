#include "confirmation_advice.hpp"

#include <algorithm>
#include <cmath>

#include "design_advice.hpp"
#include "key_text.hpp"
#include "parapet/study/predicted.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::reports {
namespace {

using records::EvaluationRecord;

std::vector<std::string> names_of(const designs::StudySpec& study,
                                  const std::vector<std::size_t>& objectives) {
  std::vector<std::string> names;
  for (const std::size_t j : objectives)
    names.push_back(study::objective_name(study.objectives[j]));
  return names;
}

ConfirmingRun run_of(const designs::StudySpec& study, const study::Pick& pick,
                     const EvaluationRecord& record) {
  ConfirmingRun run{.id = record.id,
                    .stage = record.stage,
                    .spacing = record.spacing,
                    .ok = record.ok,
                    .reason = record.reason,
                    .feasible = record.ok && record.feasible,
                    .objectives = {},
                    .violated = {},
                    .worse = names_of(study, study::worse_than_predicted(study, pick, record))};
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

/// How far the answer moves between runs of the design and of those near to it, all at one spacing:
/// for each objective, and for each constraint with a value.
std::vector<Spread> spreads(const designs::StudySpec& study,
                            const std::vector<const EvaluationRecord*>& runs) {
  std::vector<Spread> list;
  const auto add = [&](const std::string& name, const std::string& metric, auto value_in) {
    std::vector<double> values;
    for (const EvaluationRecord* run : runs) {
      if (const auto value = value_in(*run)) values.push_back(*value);
    }
    if (values.size() > 1) list.push_back(spread_of(name, metric, values));
  };
  std::vector<ObjectiveTerms> objectives;
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    objectives.push_back(terms_of(study, study.objectives[j]));
    if (study.objectives[j].is_of_design()) continue;
    add(objectives.back().name, unit_key(objectives.back()), [j](const EvaluationRecord& record) {
      return j < record.objectives.size() ? record.objectives[j].value : std::nullopt;
    });
  }
  for (std::size_t k = 0; k < study.constraints.size(); ++k) {
    const designs::Constraint& constraint = study.constraints[k];
    const std::string statistic = statistic_words(study, constraint.is_of_design(),
                                                  constraint.statistic, constraint.quantile);
    const bool told = std::ranges::any_of(objectives, [&](const ObjectiveTerms& objective) {
      return !constraint.metric.empty() && objective.metric == constraint.metric &&
             objective.statistic == statistic;
    });
    if (constraint.is_of_design() || told) continue;
    add(constraint.name, unit_key(constraint), [k](const EvaluationRecord& record) {
      return k < record.constraints.size() ? record.constraints[k].value : std::nullopt;
    });
  }
  return list;
}

void add_new(std::vector<std::string>& list, const std::string& name) {
  if (std::ranges::count(list, name) == 0) list.push_back(name);
}

RefutedDesign refuted_design(const study::LoadedStudy& study, const study::Candidate& candidate) {
  const study::Pick pick = study::pick_of(candidate);
  RefutedDesign result{.id = pick.id, .violated = {}};
  for (const EvaluationRecord& run : study.confirmations) {
    if (!study::confirms(run.id, pick.id)) continue;
    const auto worse = study::worse_than_predicted(study.spec, pick, run);
    for (const std::string& name : names_of(study.spec, worse)) add_new(result.worse, name);
    for (const records::ConstraintRecord& constraint : run.constraints) {
      if (!constraint.satisfied) add_new(result.violated, constraint.name);
    }
  }
  return result;
}

}  // namespace

Confirmation confirmation_of(const study::LoadedStudy& study,
                             const study::ConfirmedPick& confirmed) {
  const EvaluationRecord& design = *confirmed.pick->design;
  const study::Pick pick = study::pick_of(*confirmed.pick);
  Confirmation result{.verdict = confirmed.verdict, .runs = {}, .spread = {}, .refuted = {}};
  result.constraints_tested = study::has_metric_constraint(study.spec);
  std::vector<const EvaluationRecord*> runs;
  for (const EvaluationRecord& run : study.confirmations) {
    if (study::confirms(run.id, design.id)) runs.push_back(&run);
  }
  // The file has the order in which they ended.
  std::ranges::sort(runs, {}, &EvaluationRecord::id);
  const double spacing = study::repeat_spacing(study, design);
  std::vector<const EvaluationRecord*> repeats;
  if (design.spacing == spacing) repeats.push_back(&design);
  for (const EvaluationRecord* run : runs) {
    result.runs.push_back(run_of(study.spec, pick, *run));
    if (run->spacing == spacing && run->ok) repeats.push_back(run);
  }
  result.objectives_tested =
      !runs.empty() &&
      std::ranges::any_of(pick.predicted, [](const auto& one) { return one.has_value(); });
  result.spread = spreads(study.spec, repeats);
  for (const study::Candidate* candidate : confirmed.refuted) {
    result.refuted.push_back(refuted_design(study, *candidate));
  }
  return result;
}

}  // namespace parapet::reports
