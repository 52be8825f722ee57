#include "design_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

using designs::InputError;
using designs::Json;

/// The entry of pareto.json with an id; null when there is none.
Json view_of(const StudyLog& log, const std::string& id) {
  if (!log.pareto.is_object() || !log.pareto.contains("designs")) return nullptr;
  for (const Json& entry : log.pareto["designs"]) {
    if (entry.is_object() && entry.value("id", "") == id) return entry;
  }
  return nullptr;
}

std::vector<Candidate> feasible_designs(const StudyLog& log) {
  std::vector<Candidate> list;
  for (const LoggedDesign& design : log.designs) {
    if (!design.feasible || !log.counts(design)) continue;
    Candidate candidate{.design = &design};
    for (const LoggedObjective& objective : design.objectives) {
      const std::optional<double> value = objective.minimised();
      if (value) candidate.values.push_back(*value);
    }
    if (candidate.values.size() != design.objectives.size()) continue;
    candidate.view = view_of(log, design.id);
    list.push_back(std::move(candidate));
  }
  return list;
}

std::vector<Candidate> front_of(const std::vector<Candidate>& feasible) {
  std::vector<ObjectiveValues> points;
  for (const Candidate& candidate : feasible) points.push_back(candidate.values);
  std::vector<Candidate> front;
  for (const std::size_t k : undominated(points)) front.push_back(feasible[k]);
  std::ranges::stable_sort(front, {}, &Candidate::values);
  return front;
}

std::vector<ObjectiveValues> values_of(const std::vector<Candidate>& list) {
  std::vector<ObjectiveValues> values;
  for (const Candidate& candidate : list) values.push_back(candidate.values);
  return values;
}

/// The place of an objective that an option names.
std::size_t objective_index(const StudyLog& log, const std::string& name, const char* option) {
  std::vector<std::string> names;
  const std::vector<LoggedObjective>* objectives = nullptr;
  for (const LoggedDesign& design : log.designs) {
    if (!design.objectives.empty()) objectives = &design.objectives;
  }
  for (std::size_t j = 0; objectives != nullptr && j < objectives->size(); ++j) {
    const LoggedObjective& objective = (*objectives)[j];
    if (objective.metric == name || objective.of == name) return j;
    names.push_back(objective.metric);
  }
  throw InputError(
      {{option, "", name, "the study has no objective of that name", "one of " + joined(names)}});
}

std::string score_knee(Choice& choice) {
  if (choice.front.size() == 1) {
    return "One design is at least as good as every other in every objective: there is nothing to "
           "trade off, and it is taken.";
  }
  const Knee knee = knee_of(values_of(choice.front));
  std::vector<std::string> ends;
  for (std::size_t k = 0; k < choice.front.size(); ++k) {
    // The ends lie on the plane but for rounding, which must not decide between them.
    const double distance = std::abs(knee.distance[k]) < 1e-12 ? 0.0 : knee.distance[k];
    choice.front[k].score = -distance;
  }
  for (const std::size_t end : knee.ends) ends.push_back(choice.front[end].design->id);
  const std::string scaled =
      "The knee of the front: each objective is scaled to 0 at its best and 1 at its worst value "
      "on the front; ";
  std::string words =
      knee.through_ends
          ? fmt::format(
                "{}the design is taken that lies farthest, towards the best values, from "
                "the {} through the ends of the front (the designs best in each objective: "
                "{}).",
                scaled, knee.ends.size() == 2 ? "line" : "plane", joined(ends))
          : fmt::format(
                "{}the design is taken whose worst objective is least bad (the designs best "
                "in each objective, {}, span no plane to measure a distance from).",
                scaled, joined(ends));
  if (choice.front.size() <= knee.ends.size()) {
    words +=
        " This front consists of its ends or less, so the rule tells little here: equal ones "
        "go by the first objective.";
  }
  return words;
}

std::string score_weights(const StudyLog& log, const study::PickRule& rule, Choice& choice) {
  std::vector<double> weights(log.n_objectives(), 0.0);
  std::vector<std::string> words;
  for (const auto& [name, weight] : rule.weights) {
    const std::size_t j = objective_index(log, name, "--weights");
    if (j >= weights.size()) weights.resize(j + 1, 0.0);
    weights[j] = weight;
    words.push_back(fmt::format("{} {:g}", key_words(name), weight));
  }
  if (!choice.front.empty()) {
    const FrontRange range = range_of(values_of(choice.front));
    for (Candidate& candidate : choice.front) {
      const ObjectiveValues scaled = range.normalised(candidate.values);
      candidate.score = 0.0;
      for (std::size_t j = 0; j < std::min(scaled.size(), weights.size()); ++j) {
        candidate.score += weights[j] * scaled[j];
      }
    }
  }
  return fmt::format(
      "Weights: each objective is scaled to 0 at its best and 1 at its worst value on the front; "
      "the design with the least weighted sum is taken (weights: {}{}).",
      joined(words), rule.weights.size() < log.n_objectives() ? "; 0 for the others" : "");
}

std::string limit_words(const study::ObjectiveLimit& limit) {
  const std::string name = key_words(limit.objective);
  if (limit.upper) return name + " at most " + with_unit(limit.upper, limit.objective);
  return name + " at least " + with_unit(limit.lower, limit.objective);
}

std::string score_limits(const StudyLog& log, const study::PickRule& rule, Choice& choice) {
  std::vector<std::string> words;
  for (const study::ObjectiveLimit& limit : rule.limits) {
    const std::size_t j = objective_index(log, limit.objective, "--limit");
    words.push_back(limit_words(limit));
    for (Candidate& candidate : choice.front) {
      candidate.score = candidate.values.front();
      const double value = candidate.design->objectives[j].value.value();
      if ((limit.lower && value < *limit.lower) || (limit.upper && value > *limit.upper)) {
        candidate.within_limits = false;
      }
      const std::optional<double> share =
          candidate.view.is_object() ? probability_within(candidate.view["objectives"][j], limit)
                                     : std::nullopt;
      if (share) candidate.probability_limits = candidate.probability_limits.value_or(1.0) * *share;
    }
  }
  return fmt::format(
      "Limits: of the designs on the front with {}, the one best in the first objective is taken.",
      joined(words));
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

study::RuleKind resolved_kind(const StudyLog& log, const study::PickRule& rule) {
  const bool several = log.n_objectives() > 1;
  if (rule.kind == study::RuleKind::automatic)
    return several ? study::RuleKind::knee : study::RuleKind::best;
  if (!several && rule.kind != study::RuleKind::best && rule.kind != study::RuleKind::limits) {
    throw InputError(
        {{"--rule", "", to_string(rule.kind),
          "the study has one objective, so there is no front to choose from", "best, or limits"}});
  }
  return rule.kind;
}

}  // namespace

std::optional<double> Candidate::probability_feasible() const {
  return view.is_object() && view.contains("probability_feasible")
             ? value_of(view["probability_feasible"])
             : std::nullopt;
}

bool Candidate::doubtful() const {
  return probability_feasible().value_or(1.0) < least_probability;
}

std::optional<double> probability_within(const Json& objective,
                                         const study::ObjectiveLimit& limit) {
  if (!objective.is_object()) return std::nullopt;
  const auto number = [&](const char* key) {
    return objective.contains(key) ? value_of(objective[key]) : std::nullopt;
  };
  const auto middle = number("estimate"), lower = number("lower_95"), upper = number("upper_95");
  if (!middle || !lower || !upper) return std::nullopt;
  constexpr double interval_width = 1.959963984540054;  // of half a 95 % interval, in s.d.
  const auto below = [&](double value) {
    const double side = (value < *middle ? *middle - *lower : *upper - *middle) / interval_width;
    if (!(side > 0.0)) return value >= *middle ? 1.0 : 0.0;  // known exactly
    return 0.5 * std::erfc(-(value - *middle) / side / std::sqrt(2.0));
  };
  return (limit.upper ? below(*limit.upper) : 1.0) - (limit.lower ? below(*limit.lower) : 0.0);
}

std::string to_string(study::RuleKind kind) {
  switch (kind) {
    case study::RuleKind::automatic:
      return "automatic";
    case study::RuleKind::best:
      return "best";
    case study::RuleKind::knee:
      return "knee";
    case study::RuleKind::weights:
      return "weights";
    case study::RuleKind::limits:
      break;
  }
  return "limits";
}

Choice choose(const StudyLog& log, const study::PickRule& rule) {
  Choice choice;
  choice.kind = resolved_kind(log, rule);
  std::vector<Candidate> feasible = feasible_designs(log);
  choice.front = front_of(feasible);
  switch (choice.kind) {
    case study::RuleKind::knee:
      choice.words = choice.front.empty() ? "The knee of the front." : score_knee(choice);
      break;
    case study::RuleKind::weights:
      choice.words = score_weights(log, rule, choice);
      break;
    case study::RuleKind::limits:
      choice.words = score_limits(log, rule, choice);
      break;
    default:
      for (Candidate& candidate : feasible) candidate.score = *candidate.design->objective_scalar;
      choice.words = log.n_objectives() > 1
                         ? "The least weighted sum of the objectives, with the spec's own weights "
                           "and scales."
                         : "The best value of the objective among the designs that meet every "
                           "constraint.";
      rank(choice, std::move(feasible));
      return choice;
  }
  rank(choice, choice.front);
  return choice;
}

std::vector<study::Pick> ranked_picks(const std::filesystem::path& study_dir,
                                      const study::PickRule& rule) {
  const StudyLog log = read_study_log(study_dir);
  std::vector<study::Pick> picks;
  for (const Candidate& candidate : choose(log, rule).ranked) {
    picks.push_back({candidate.design->id, candidate.design->design,
                     candidate.design->spacing.value_or(0.0), candidate.probability_feasible()});
  }
  return picks;
}

}  // namespace parapet::reports
