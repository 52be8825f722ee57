#include "parapet/study/expected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parapet/solver/metric_catalog.hpp"
#include "parapet/study/confirmation.hpp"
#include "parapet/study/goal_quantity.hpp"
#include "parapet/study/quantity.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/study_surrogates.hpp"

namespace parapet::study {
namespace {

using designs::StudySpec;
using records::EvaluationRecord;
using Runs = std::vector<const EvaluationRecord*>;

/// A goal with what reads it off a record.
struct Goal {
  Expectation what;                // without an estimate
  std::optional<GoalPlace> place;  // of its surrogate
  std::optional<Quantity> quantity;
  bool satisfied_when_absent = true;
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

void set_bounds(Goal& goal) {
  if (goal.quantity && goal.quantity->statistic == designs::Statistic::probability) {
    goal.least = 0.0;
    goal.greatest = 1.0;
    return;
  }
  const auto info = solver::find_metric_info(goal.what.metric);
  if (!info) return;
  goal.least = info->least;
  goal.greatest = info->greatest;
  if (goal.quantity && goal.quantity->value_when_absent) {
    goal.least = std::min(goal.least, *goal.quantity->value_when_absent);
    goal.greatest = std::max(goal.greatest, *goal.quantity->value_when_absent);
  }
}

std::vector<Goal> goals_of(const StudySpec& study) {
  std::vector<Goal> goals;
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    const designs::Objective& objective = study.objectives[j];
    Goal& goal = goals.emplace_back();
    goal.what.role = Role::objective;
    goal.what.name = objective_name(objective);
    goal.what.metric = objective.metric;
    goal.what.place = j;
    goal.what.exact = is_exact(objective);
    if (!goal.what.exact) goal.place = GoalPlace{GoalPlace::Kind::objective, j};
    if (!goal.what.exact) goal.quantity = objective_quantity(study, objective);
    set_bounds(goal);
  }
  std::size_t limit = 0;
  for (std::size_t k = 0; k < study.constraints.size(); ++k) {
    const designs::Constraint& constraint = study.constraints[k];
    if (constraint.is_of_design()) continue;
    for (const QuantityLimit& one : constraint_quantities(study, constraint)) {
      Goal& goal = goals.emplace_back();
      goal.what.role = Role::constraint;
      goal.what.name = constraint.name;
      goal.what.metric = constraint.metric;
      goal.what.place = k;
      goal.what.lower = one.lower;
      goal.what.upper = one.upper;
      goal.place = GoalPlace{GoalPlace::Kind::limit, limit++};
      goal.quantity = one.quantity;
      goal.satisfied_when_absent = constraint.satisfied_when_absent;
      set_bounds(goal);
    }
  }
  return goals;
}

std::vector<Goal> loads_of(const EvaluationRecord& design) {
  std::vector<Goal> goals;
  for (std::size_t barrier = 1;; ++barrier) {
    const std::string prefix = fmt::format("barrier_{}_", barrier);
    for (const char* load : {"design_force_n_per_m", "design_moment_nm_per_m"}) {
      const std::string key = prefix + load;
      if (std::ranges::count(design.metrics, key, &solver::Metric::key) == 0) return goals;
      Goal& goal = goals.emplace_back();
      goal.what.role = Role::load;
      goal.what.name = goal.what.metric = key;
      goal.what.place = barrier;
      goal.quantity = Quantity{.metric = key,
                               .statistic = designs::Statistic::worst,
                               .lower = {},
                               .upper = {},
                               .value_when_absent = {}};
      set_bounds(goal);
    }
  }
}

/// Its value in a run.
std::optional<double> value_in(const StudySpec& study, const Goal& goal,
                               const EvaluationRecord& run, bool* absent) {
  if (goal.what.role == Role::objective) {
    if (goal.what.place >= run.objectives.size()) return std::nullopt;
    const records::ObjectiveRecord& objective = run.objectives[goal.what.place];
    if (absent != nullptr) *absent = !objective.value && objective.absent;
    return objective.value;
  }
  const QuantityValue found = quantity_value(study, *goal.quantity, run.design, events_of(run));
  if (absent != nullptr) *absent = !found.value && found.absent && !found.unknown;
  return found.value;
}

/// The runs of a design in the study and in confirmations.jsonl, by what they can tell.
struct DesignRuns {
  double spacing = 0.0;                     // that counts [m]
  const EvaluationRecord* own = nullptr;    // at that spacing
  Runs again = {};                          // likewise
  const EvaluationRecord* other = nullptr;  // at another spacing
};

/// Of two spacings that are not the one that counts, the better one for a grid uncertainty: finer
/// before coarser, then the nearest.
bool tells_more(double one, double other, double counted) {
  if ((one < counted) != (other < counted)) return one < counted;
  return std::abs(one - counted) < std::abs(other - counted);
}

DesignRuns runs_of(const LoadedStudy& study, const EvaluationRecord& design) {
  const double spacing = repeat_spacing(study, design);
  DesignRuns runs{.spacing = spacing};
  const auto at_another = [&](const EvaluationRecord& run) {
    if (runs.other == nullptr || tells_more(run.spacing, runs.other->spacing, spacing)) {
      runs.other = &run;
    }
  };
  for (const EvaluationRecord& run : study.designs) {
    if (!run.ok || run.design != design.design || run.id == design.id) continue;
    if (run.spacing != spacing) at_another(run);
  }
  if (design.spacing == spacing) {
    runs.own = &design;
  } else {
    at_another(design);
  }
  for (const EvaluationRecord& run : study.confirmations) {
    if (!run.ok || !confirms(run.id, design.id)) continue;
    if (run.spacing == spacing) {
      runs.again.push_back(&run);
    } else {
      at_another(run);
    }
  }
  // The file has the order in which they ended.
  std::ranges::sort(runs.again, {}, &EvaluationRecord::id);
  return runs;
}

Expectation expectation(const StudySpec& study, const Goal& goal, const DesignRuns& runs,
                        const std::optional<SurrogateBelief>& belief) {
  Expectation result = goal.what;
  RepeatEvidence evidence{.surrogate = belief, .least = goal.least, .greatest = goal.greatest};
  int present = 0;
  const auto read = [&](const EvaluationRecord& run) {
    bool absent = false;
    const std::optional<double> value = value_in(study, goal, run, &absent);
    result.absent += absent ? 1 : 0;
    present += value ? 1 : 0;
    return value;
  };
  if (runs.own != nullptr) evidence.own = read(*runs.own);
  for (const EvaluationRecord* run : runs.again) {
    if (const auto value = read(*run)) evidence.again.push_back(*value);
  }
  // A coarser run tells less than the surrogate of both spacings.
  const bool levels = belief && belief->grid;
  if (runs.other != nullptr && (!levels || runs.other->spacing < runs.spacing)) {
    evidence.finer = value_in(study, goal, *runs.other, nullptr);
  }
  if (goal.what.exact) {
    const EvaluationRecord* any = runs.own != nullptr ? runs.own : runs.other;
    const auto value = any == nullptr ? std::nullopt : value_in(study, goal, *any, nullptr);
    if (value) result.estimate = exact_estimate(*value);
    return result;
  }
  // No run of the design has it: the surrogates, which know it from others, say nothing of a
  // repeat.
  const bool none = present == 0 && result.absent > 0;
  if (!none) result.estimate = repeat_estimate(evidence);
  if (result.role != Role::constraint) return result;
  const double without = goal.satisfied_when_absent ? 1.0 : 0.0;
  const int all = present + result.absent;
  const double absent_share = all == 0 ? 0.0 : static_cast<double>(result.absent) / all;
  const auto within = result.estimate
                          ? result.estimate->probability_within(result.lower, result.upper)
                          : std::nullopt;
  if (within) {
    result.probability = absent_share * without + (1.0 - absent_share) * *within;
  } else if (none && (belief || result.absent > 1)) {
    result.probability = without;
  }
  return result;
}

std::optional<SurrogateBelief> belief_of(const LoadedStudy& study, const Goal& goal,
                                         const designs::Design& design, double spacing) {
  if (study.surrogates == nullptr || !goal.place) return std::nullopt;
  const auto beliefs = study.surrogates->beliefs(*goal.place, {&design}, spacing);
  return beliefs.empty() ? std::nullopt : std::optional(beliefs.front());
}

/// Loads that the search did not model are modelled from its runs.
std::optional<SurrogateBelief> load_belief(const LoadedStudy& study, const Goal& load,
                                           const designs::Design& design, double spacing) {
  if (study.surrogates == nullptr) return std::nullopt;
  RunSamples samples{.least = load.least, .greatest = load.greatest};
  for (const EvaluationRecord& run : study.designs) {
    const auto value = run.ok ? value_in(study.spec, load, run, nullptr) : std::nullopt;
    if (!value) continue;
    samples.designs.push_back(&run.design);
    samples.spacings.push_back(run.spacing);
    samples.values.push_back(*value);
  }
  return study.surrogates->fitted_belief(samples, design, spacing);
}

}  // namespace

bool is_exact(const designs::Objective& objective) {
  return objective.is_of_design();
}

bool has_metric_constraint(const StudySpec& study) {
  return std::ranges::any_of(study.constraints,
                             [](const auto& constraint) { return !constraint.is_of_design(); });
}

double repeat_spacing(const LoadedStudy& study, const EvaluationRecord& design) {
  const double finest = designs::finest_spacing(study.spec);
  if (design.spacing <= finest) return design.spacing;
  const bool any = std::ranges::any_of(study.confirmations, [&](const EvaluationRecord& run) {
    return run.ok && confirms(run.id, design.id) && run.spacing == finest;
  });
  return any ? finest : design.spacing;
}

std::vector<std::vector<Expectation>> predicted_expectations(
    const LoadedStudy& study, const std::vector<const EvaluationRecord*>& designs) {
  std::vector<std::vector<Expectation>> list(designs.size());
  if (designs.empty()) return list;
  std::vector<const designs::Design*> points;
  for (const EvaluationRecord* record : designs) points.push_back(&record->design);
  const double spacing = designs.front()->spacing;  // comparable designs share it
  for (const Goal& goal : goals_of(study.spec)) {
    std::vector<SurrogateBelief> beliefs;
    if (study.surrogates != nullptr && goal.place) {
      beliefs = study.surrogates->beliefs(*goal.place, points, spacing);
    }
    for (std::size_t k = 0; k < designs.size(); ++k) {
      const auto belief = beliefs.empty() ? std::nullopt : std::optional(beliefs[k]);
      list[k].push_back(
          expectation(study.spec, goal, {.spacing = spacing, .own = designs[k]}, belief));
    }
  }
  return list;
}

std::vector<Expectation> repeat_expectations(const LoadedStudy& study,
                                             const EvaluationRecord& design) {
  const DesignRuns runs = runs_of(study, design);
  const double spacing = repeat_spacing(study, design);
  std::vector<Expectation> list;
  for (const Goal& goal : goals_of(study.spec)) {
    list.push_back(
        expectation(study.spec, goal, runs, belief_of(study, goal, design.design, spacing)));
  }
  for (const Goal& goal : loads_of(design)) {
    // One estimate of one quantity: that of an objective or limit, where the load is one.
    const auto same = std::ranges::find_if(list, [&](const Expectation& one) {
      return one.metric == goal.what.metric && one.estimate && study.spec.scenarios.empty();
    });
    Expectation load = goal.what;
    if (same != list.end()) {
      load.estimate = same->estimate;
    } else {
      load = expectation(study.spec, goal, runs, load_belief(study, goal, design.design, spacing));
    }
    list.push_back(std::move(load));
  }
  return list;
}

std::optional<double> probability_all_met(const std::vector<Expectation>& expectations) {
  double product = 1.0;
  for (const Expectation& one : expectations) {
    if (one.role != Role::constraint || one.exact) continue;
    if (!one.probability) return std::nullopt;
    product *= *one.probability;
  }
  return product;
}

std::optional<double> margin_in_uncertainties(const std::vector<Expectation>& expectations) {
  std::optional<double> least;
  for (const Expectation& one : expectations) {
    if (one.role != Role::constraint || one.exact) continue;
    const auto deviation = one.estimate ? one.estimate->standard_uncertainty() : std::nullopt;
    if (!deviation) return std::nullopt;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double mean = one.estimate->mean;
    const double apart =
        std::min(mean - one.lower.value_or(-infinity), one.upper.value_or(infinity) - mean);
    const double margin = *deviation > 0.0 ? apart / *deviation
                          : apart >= 0.0   ? most_margin
                                           : -most_margin;
    least = std::min(least.value_or(most_margin), margin);
  }
  return least;
}

}  // namespace parapet::study
