#include "parapet/study/pick.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/math/normal.hpp"
#include "parapet/math/pareto.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/scoring.hpp"
#include "to_objectives.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using records::EvaluationRecord;

std::vector<Candidate> feasible_designs(const LoadedStudy& study) {
  std::vector<Candidate> list;
  for (const EvaluationRecord* design : comparable_designs(study)) {
    if (!design->feasible) continue;
    list.push_back({.design = design,
                    .values = minimized_objectives(*design),
                    .estimates = study.front ? study.front->find(design->id) : nullptr});
  }
  return list;
}

std::vector<std::vector<double>> values_of(const std::vector<Candidate>& list) {
  std::vector<std::vector<double>> values;
  for (const Candidate& candidate : list) values.push_back(candidate.values);
  return values;
}

std::vector<Candidate> front_of(const std::vector<Candidate>& feasible) {
  std::vector<math::Objectives> points;
  for (const Candidate& candidate : feasible) points.push_back(to_objectives(candidate.values));
  std::vector<Candidate> front;
  for (const std::size_t k : math::non_dominated(points)) front.push_back(feasible[k]);
  std::ranges::stable_sort(front, {}, &Candidate::values);
  return front;
}

/// The place of an objective that an option names, by its name or its metric.
std::size_t objective_index(const designs::StudySpec& study, const std::string& name,
                            const char* option) {
  std::string names;
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    const designs::Objective& objective = study.objectives[j];
    const std::string own = objective_name(objective);
    const std::string& of = objective.metric.empty() ? objective.expression : objective.metric;
    if (own == name || of == name) return j;
    names += j == 0 ? "" : j + 1 == study.objectives.size() ? " and " : ", ";
    names += own;
  }
  throw InputError(
      {{option, "", name, "the study has no objective of that name", "one of " + names}});
}

void score_by_knee(Choice& choice) {
  if (choice.front.size() < 2) return;
  choice.knee = knee_of(values_of(choice.front));
  for (std::size_t k = 0; k < choice.front.size(); ++k) {
    // The ends lie on the plane but for rounding, which must not decide between them.
    const double distance = choice.knee->distance[k];
    choice.front[k].score = std::abs(distance) < 1e-12 ? -0.0 : -distance;
  }
}

void score_by_weights(const LoadedStudy& study, const PickRule& rule, Choice& choice) {
  std::vector<double> weights(study.spec.objectives.size(), 0.0);
  for (const auto& [name, weight] : rule.weights) {
    weights[objective_index(study.spec, name, "--weights")] = weight;
  }
  if (choice.front.empty()) return;
  const FrontRange range = range_of(values_of(choice.front));
  for (Candidate& candidate : choice.front) {
    const std::vector<double> scaled = range.normalised(candidate.values);
    candidate.score = 0.0;
    for (std::size_t j = 0; j < scaled.size(); ++j) candidate.score += weights[j] * scaled[j];
  }
}

void score_by_limits(const LoadedStudy& study, const PickRule& rule, Choice& choice) {
  for (const ObjectiveLimit& limit : rule.limits) {
    const std::size_t j = objective_index(study.spec, limit.objective, "--limit");
    for (Candidate& candidate : choice.front) {
      candidate.score = candidate.values.front();
      const double value = candidate.design->objectives[j].value.value();
      if ((limit.lower && value < *limit.lower) || (limit.upper && value > *limit.upper)) {
        candidate.within_limits = false;
      }
      if (candidate.estimates == nullptr) continue;
      const auto share = probability_within(candidate.estimates->objectives.at(j), limit);
      if (share) candidate.probability_limits = candidate.probability_limits.value_or(1.0) * *share;
    }
  }
}

/// Ranks by the score; then what the surrogate doubts goes behind what it does not.
void rank(Choice& choice, std::vector<Candidate> list) {
  std::erase_if(list, [](const Candidate& candidate) { return !candidate.within_limits; });
  std::ranges::stable_sort(list, {}, &Candidate::score);
  const auto known = [](const Candidate& c) { return c.probability_feasible().has_value(); };
  const bool any_known = std::ranges::any_of(list, known);
  choice.all_doubtful = any_known && std::ranges::none_of(list, [&](const Candidate& candidate) {
                          return known(candidate) && !candidate.doubtful();
                        });
  if (!choice.all_doubtful) {
    std::stable_partition(list.begin(), list.end(),
                          [](const Candidate& candidate) { return !candidate.doubtful(); });
  }
  choice.ranked = std::move(list);
}

RuleKind resolved_kind(const LoadedStudy& study, const PickRule& rule) {
  const bool several = study.spec.objectives.size() > 1;
  if (rule.kind == RuleKind::automatic) return several ? RuleKind::knee : RuleKind::best;
  if (!several && rule.kind != RuleKind::best && rule.kind != RuleKind::limits) {
    throw InputError(
        {{"--rule", "", to_string(rule.kind),
          "the study has one objective, so there is no front to choose from", "best, or limits"}});
  }
  return rule.kind;
}

}  // namespace

std::optional<double> Candidate::probability_feasible() const {
  return estimates == nullptr ? std::nullopt : estimates->probability_feasible;
}

bool Candidate::doubtful() const {
  return probability_feasible().value_or(1.0) < least_probability;
}

std::optional<double> probability_within(const Estimate& estimate, const ObjectiveLimit& limit) {
  const auto &middle = estimate.median, &lower = estimate.lower_95, &upper = estimate.upper_95;
  if (!middle || !lower || !upper) return std::nullopt;
  constexpr double interval_width = 1.959963984540054;  // of half a 95 % interval, in s.d.
  const auto below = [&](double value) {
    const double side = (value < *middle ? *middle - *lower : *upper - *middle) / interval_width;
    if (!(side > 0.0)) return value >= *middle ? 1.0 : 0.0;  // known exactly
    return math::normal_cdf((value - *middle) / side);
  };
  return (limit.upper ? below(*limit.upper) : 1.0) - (limit.lower ? below(*limit.lower) : 0.0);
}

Choice choose(const LoadedStudy& study, const PickRule& rule) {
  Choice choice{.kind = resolved_kind(study, rule)};
  std::vector<Candidate> feasible = feasible_designs(study);
  choice.front = front_of(feasible);
  if (choice.kind == RuleKind::best) {
    for (Candidate& candidate : feasible) candidate.score = *candidate.design->objective_scalar;
    rank(choice, std::move(feasible));
    return choice;
  }
  if (choice.kind == RuleKind::knee) score_by_knee(choice);
  if (choice.kind == RuleKind::weights) score_by_weights(study, rule, choice);
  if (choice.kind == RuleKind::limits) score_by_limits(study, rule, choice);
  rank(choice, choice.front);
  return choice;
}

std::vector<Pick> ranked_picks(const LoadedStudy& study, const PickRule& rule) {
  std::vector<Pick> picks;
  for (const Candidate& candidate : choose(study, rule).ranked) {
    picks.push_back({candidate.design->id, candidate.design->design, candidate.design->spacing,
                     candidate.probability_feasible()});
  }
  return picks;
}

ConfirmedPick confirmed_pick(const LoadedStudy& study, const Choice& choice) {
  std::vector<ConfirmationRun> runs;
  for (const EvaluationRecord& run : study.confirmations) {
    runs.push_back({run.id, run.stage, run.ok && run.feasible});
  }
  ConfirmedPick result;
  const auto tried =
      std::min(choice.ranked.size(), static_cast<std::size_t>(most_confirmed_designs));
  for (std::size_t k = 0; k < tried; ++k) {
    const Candidate& candidate = choice.ranked[k];
    const Verdict verdict = verdict_of(candidate.design->id, runs);
    if (verdict == Verdict::refuted) {
      result.refuted.push_back(&candidate);
      continue;
    }
    result.pick = &candidate;
    result.verdict = verdict;
    return result;
  }
  if (!choice.ranked.empty()) {
    result.pick = &choice.ranked.front();
    result.verdict = Verdict::refuted;
  }
  return result;
}

}  // namespace parapet::study
