#include "parapet/study/pick.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/math/normal.hpp"
#include "parapet/math/pareto.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/predicted.hpp"
#include "parapet/study/scoring.hpp"
#include "rank_draws.hpp"
#include "rule_scores.hpp"
#include "to_objectives.hpp"

namespace parapet::study {
namespace {

using designs::InputError;
using records::EvaluationRecord;

/// What the surrogates expect of the objectives, to be minimised; as observed without them.
std::vector<double> expected_objectives(const designs::StudySpec& study,
                                        const Candidate& candidate) {
  std::vector<double> expected = candidate.values;
  for (const Expectation& one : candidate.predicted) {
    if (one.role != Role::objective || !one.estimate || !one.estimate->scatter) continue;
    const bool maximize = study.objectives[one.place].goal == designs::Goal::maximize;
    expected[one.place] = maximize ? -one.estimate->mean : one.estimate->mean;
  }
  return expected;
}

std::vector<Candidate> feasible_designs(const LoadedStudy& study) {
  std::vector<const EvaluationRecord*> records;
  for (const EvaluationRecord* design : comparable_designs(study)) {
    if (design->feasible) records.push_back(design);
  }
  auto predicted = predicted_expectations(study, records);
  std::vector<Candidate> list;
  for (std::size_t k = 0; k < records.size(); ++k) {
    Candidate& candidate = list.emplace_back();
    candidate.design = records[k];
    candidate.values = minimized_objectives(*records[k]);
    candidate.estimates = study.front ? study.front->find(records[k]->id) : nullptr;
    candidate.predicted = std::move(predicted[k]);
    candidate.expected = expected_objectives(study.spec, candidate);
    candidate.margin = margin_in_uncertainties(candidate.predicted);
  }
  return list;
}

std::vector<std::vector<double>> expected_of(const std::vector<Candidate>& list) {
  std::vector<std::vector<double>> values;
  for (const Candidate& candidate : list) values.push_back(candidate.expected);
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

void hold_to_limits(const LoadedStudy& study, const PickRule& rule, Choice& choice) {
  for (const ObjectiveLimit& limit : rule.limits) {
    const std::size_t j = objective_index(study.spec, limit.objective, "--limit");
    for (Candidate& candidate : choice.front) {
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

/// Whether the front has a knee: as it is expected, and in at least half of the draws.
void look_for_knee(const LoadedStudy& study, Choice& choice) {
  if (choice.front.size() < 2) return;
  constexpr double most_draws = 0.5;
  choice.knee = knee_of(expected_of(choice.front));
  const auto draws = objective_draws(study, choice.front);
  double with_knee = 0.0;
  for (const auto& values : draws) {
    with_knee += bulge_of(knee_of(values)) >= least_bulge ? 1.0 : 0.0;
  }
  if (!draws.empty()) choice.knee_share = with_knee / static_cast<double>(draws.size());
  choice.no_knee =
      bulge_of(*choice.knee) < least_bulge || choice.knee_share.value_or(1.0) < most_draws;
  if (choice.no_knee) choice.kind = RuleKind::balanced;
}

void set_scores(const Scores& scores, std::vector<Candidate>& list) {
  if (list.empty()) return;
  const std::vector<double> score = scores(expected_of(list));
  for (std::size_t k = 0; k < list.size(); ++k) list[k].score = score[k];
}

/// Names what the draws cannot tell from the first, and puts the one with the largest margin first.
void settle_ties(const LoadedStudy& study, const Scores& scores, Choice& choice) {
  std::vector<Candidate>& ranked = choice.ranked;
  if (ranked.empty()) return;
  choice.first_by_rule = ranked.front().design->id;
  constexpr std::size_t most_compared = 50;  // farther behind nothing is tied
  std::vector<Candidate> compared(
      ranked.begin(),
      ranked.begin() + static_cast<std::ptrdiff_t>(std::min(ranked.size(), most_compared)));
  const auto draws = objective_draws(study, compared);
  choice.draws = static_cast<int>(draws.size());
  count_draws(draws, scores, compared);
  std::copy(compared.begin(), compared.end(), ranked.begin());
  std::size_t taken = 0;
  for (std::size_t k = 1; k < compared.size(); ++k) {
    const Candidate& one = ranked[k];
    if (one.beats.value_or(0.0) < tie_share || (one.doubtful() && !choice.all_doubtful)) continue;
    choice.tied.push_back(one.design->id);
    if (one.margin && ranked[taken].margin && *one.margin > *ranked[taken].margin) taken = k;
  }
  const auto place = ranked.begin() + static_cast<std::ptrdiff_t>(taken);
  std::rotate(ranked.begin(), place, place + 1);
}

/// Draws' shares belong to the front's designs too.
void share_with_front(Choice& choice) {
  for (Candidate& candidate : choice.front) {
    const auto ranked = std::ranges::find(choice.ranked, candidate.design, &Candidate::design);
    if (ranked == choice.ranked.end()) continue;
    candidate.share = ranked->share;
    candidate.beats = ranked->beats;
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
  if (const auto known = predicted.empty() ? std::nullopt : probability_all_met(predicted)) {
    const bool by_surrogate = std::ranges::any_of(predicted, [](const Expectation& one) {
      return !one.exact && one.estimate && one.estimate->scatter;
    });
    if (by_surrogate) return known;
  }
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
  if (choice.kind == RuleKind::knee) look_for_knee(study, choice);
  if (choice.kind == RuleKind::limits) hold_to_limits(study, rule, choice);
  const Scores scores = scores_of(study, rule, choice.kind);
  set_scores(scores, choice.front);
  if (choice.kind == RuleKind::best) {
    set_scores(scores, feasible);
    rank(choice, std::move(feasible));
  } else {
    rank(choice, choice.front);
  }
  settle_ties(study, scores, choice);
  share_with_front(choice);
  return choice;
}

Pick pick_of(const Candidate& candidate) {
  Pick pick{.id = candidate.design->id,
            .design = candidate.design->design,
            .spacing = candidate.design->spacing,
            .probability_feasible = candidate.probability_feasible()};
  for (const Expectation& one : candidate.predicted) {
    if (one.role != Role::objective) continue;
    const bool known = !one.exact && one.estimate && one.estimate->scatter;
    pick.predicted.push_back(known ? one.estimate : std::nullopt);
  }
  return pick;
}

std::vector<Pick> ranked_picks(const LoadedStudy& study, const PickRule& rule) {
  std::vector<Pick> picks;
  for (const Candidate& candidate : choose(study, rule).ranked) picks.push_back(pick_of(candidate));
  return picks;
}

ConfirmedPick confirmed_pick(const LoadedStudy& study, const Choice& choice) {
  ConfirmedPick result;
  const auto tried =
      std::min(choice.ranked.size(), static_cast<std::size_t>(most_confirmed_designs));
  for (std::size_t k = 0; k < tried; ++k) {
    const Candidate& candidate = choice.ranked[k];
    const Pick pick = pick_of(candidate);
    std::vector<ConfirmationRun> runs;
    for (const EvaluationRecord& run : study.confirmations) {
      runs.push_back(confirmation_run(study.spec, pick, run));
    }
    const Verdict verdict = verdict_of(pick.id, runs);
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
