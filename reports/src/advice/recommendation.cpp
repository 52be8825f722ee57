#include "parapet/reports/recommendation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "caveats.hpp"
#include "confirmation_advice.hpp"
#include "definitions.hpp"
#include "design_advice.hpp"
#include "design_json.hpp"
#include "effects.hpp"
#include "front_advice.hpp"
#include "other_designs.hpp"
#include "parapet/study/comparable.hpp"
#include "parapet/study/pick.hpp"
#include "rule_words.hpp"
#include "sketch.hpp"
#include "study_facts.hpp"

namespace parapet::reports {
namespace {

using records::EvaluationRecord;
using study::LoadedStudy;

/// The designs tied with the one recommended: the rule's first among them where another was taken.
std::vector<TiedDesign> ties_of(const study::Choice& choice, const std::string& recommended) {
  std::vector<TiedDesign> ties;
  if (choice.tied.empty()) return ties;
  for (const study::Candidate& one : choice.ranked) {
    const std::string& id = one.design->id;
    const bool tied = id == choice.first_by_rule || std::ranges::count(choice.tied, id) > 0;
    if (!tied || id == recommended) continue;
    ties.push_back({.id = id,
                    .share = one.share.value_or(0.0),
                    .margin = one.margin,
                    .probability_feasible = one.probability_feasible()});
  }
  return ties;
}

RuleFacts rule_facts(const LoadedStudy& study, const study::PickRule& rule,
                     const study::Choice& choice, const study::Candidate* pick) {
  RuleFacts facts{.kind = choice.kind,
                  .limits = rule.limits,
                  .words = rule_words(study, rule, choice),
                  .all_doubtful = choice.all_doubtful,
                  .allows_none = choice.ranked.empty() && !choice.front.empty(),
                  .share = pick == nullptr ? std::nullopt : pick->share,
                  .draws = choice.draws,
                  .bulge = {},
                  .no_knee = choice.no_knee,
                  .knee_share = choice.knee_share,
                  .first_by_rule = choice.first_by_rule};
  if (choice.knee) facts.bulge = study::bulge_of(*choice.knee);
  if (pick != nullptr) facts.ties = ties_of(choice, pick->design->id);
  return facts;
}

RecommendedDesign recommended_design(const LoadedStudy& study, const study::Candidate& pick) {
  RecommendedDesign result{.design = design_report(study.spec, *pick.design),
                           .estimates = estimates_of(study.spec, pick),
                           .probability_feasible = {},
                           .probability_limits = pick.probability_limits,
                           .repeat = study::repeat_expectations(study, *pick.design),
                           .repeat_spacing = study::repeat_spacing(study, *pick.design),
                           .margin = pick.margin,
                           .sketch = sketch_of(study.spec, pick.design->design)};
  // Further runs are worth more than pareto.json's figure of the noise-free value.
  result.probability_feasible = study::probability_all_met(result.repeat);
  if (!result.probability_feasible) result.probability_feasible = pick.probability_feasible();
  return result;
}

/// The design that an engineer would look at when nothing meets the constraints: the one that
/// misses them least.
std::optional<LeastViolatingDesign> least_violating(const LoadedStudy& study,
                                                    const study::Choice& choice) {
  if (!choice.ranked.empty() || !choice.front.empty()) return std::nullopt;
  const std::vector<const EvaluationRecord*> infeasible = study::ranked_designs(study, false);
  if (infeasible.empty()) return std::nullopt;
  return LeastViolatingDesign{.design = design_report(study.spec, *infeasible.front()),
                              .violation = study::violation(study.spec, *infeasible.front())};
}

std::vector<FailedDesign> failed_designs(const LoadedStudy& study) {
  std::vector<FailedDesign> list;
  for (const EvaluationRecord& record : study.designs) {
    if (record.ok) continue;
    list.push_back({record.id, written_design(study.spec, record.design), record.reason});
  }
  return list;
}

Reproduction reproduction(const LoadedStudy& study, const study::PickRule& rule,
                          const EvaluationRecord& shown) {
  return {
      .evaluate =
          fmt::format("parapet evaluate SPEC.json --design {} --spacing-mm {:.10g}",
                      study::shell_word(to_json(written_design(study.spec, shown.design)).dump()),
                      1000.0 * shown.spacing),
      .optimize = "parapet optimize SPEC.json --out STUDY_DIR",
      .recommend = "parapet recommend STUDY_DIR" + study::command_line(rule),
      .spec = "SPEC.json is the study's spec; study.json holds it with every default under /spec",
      .spec_hash = study.spec_hash,
      .provenance = study.provenance};
}

const EvaluationRecord& record_of(const LoadedStudy& study, const std::string& id) {
  return *std::ranges::find(study.designs, id, &EvaluationRecord::id);
}

}  // namespace

const DesignReport* Recommendation::shown() const {
  if (recommended) return &recommended->design;
  return least_violating ? &least_violating->design : nullptr;
}

Recommendation recommend(const LoadedStudy& study, const study::PickRule& rule) {
  const study::Choice choice = study::choose(study, rule);
  const study::ConfirmedPick confirmed = study::confirmed_pick(study, choice);
  Recommendation result;
  result.study = study_facts(study);
  result.rule = rule_facts(study, rule, choice, confirmed.pick);
  result.least_violating = least_violating(study, choice);
  result.progress = search_progress(study);
  result.effects = variable_effects(study);
  const bool several = study.spec.objectives.size() > 1;
  if (several) result.front = front_designs(study.spec, choice);
  if (confirmed.pick != nullptr) {
    const EvaluationRecord& best = *confirmed.pick->design;
    result.recommended = recommended_design(study, *confirmed.pick);
    result.confirmation = confirmation_of(study, confirmed);
    if (several) result.leaving = ways_out(choice, best);
    result.improvement = improvement(study, best);
    result.alternatives =
        alternatives(study, best, result.effects, result.confirmation->spread, result.rule);
  }
  result.sensitivity = study.sensitivity;
  result.failed = failed_designs(study);
  const DesignReport* shown = result.shown();
  result.caveats = caveats(study, result.recommended ? shown : nullptr);
  if (shown != nullptr) result.reproduce = reproduction(study, rule, record_of(study, shown->id));
  result.definitions = metric_definitions(study);
  return result;
}

}  // namespace parapet::reports
