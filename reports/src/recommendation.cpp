#include "parapet/reports/recommendation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "confirmations.hpp"
#include "design_choice.hpp"
#include "parapet/solver/result.hpp"
#include "recommendation_caveats.hpp"
#include "recommendation_json.hpp"
#include "recommendation_parts.hpp"
#include "study_log.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

constexpr double distinct_share = 0.05;  // of some variable's range, between alternatives
constexpr std::size_t most_alternatives = 5;

/// Usable designs from best to worst: the feasible by objective, or the others by violation.
std::vector<const LoggedDesign*> ranked(const StudyLog& log, bool feasible) {
  std::vector<const LoggedDesign*> list;
  for (const LoggedDesign& design : log.designs) {
    if (design.feasible == feasible && log.counts(design)) {
      list.push_back(&design);
    }
  }
  std::ranges::stable_sort(list, [&](const LoggedDesign* a, const LoggedDesign* b) {
    if (!feasible && a->violation() != b->violation()) return a->violation() < b->violation();
    return *a->objective_scalar < *b->objective_scalar;
  });
  return list;
}

bool distinct(const StudyLog& log, const LoggedDesign& a, const LoggedDesign& b) {
  return std::ranges::any_of(log.variables, [&](const LoggedVariable& variable) {
    const auto one = a.design.find(variable.name), other = b.design.find(variable.name);
    if (one == a.design.end() || other == b.design.end()) {
      return (one == a.design.end()) != (other == b.design.end());
    }
    const double apart = std::abs(one->second - other->second);
    if (variable.choice()) return apart > 0.0;
    return apart >= distinct_share * (variable.upper - variable.lower) && apart > 0.0;
  });
}

/// The best feasible designs that are apart from the recommended one and from each other.
Json alternatives_json(const StudyLog& log, const LoggedDesign* best) {
  Json list = Json::array();
  if (best == nullptr) return list;
  std::vector<const LoggedDesign*> chosen{best};
  for (const LoggedDesign* design : ranked(log, true)) {
    const bool apart = std::ranges::all_of(
        chosen, [&](const LoggedDesign* other) { return distinct(log, *design, *other); });
    if (!apart) continue;
    chosen.push_back(design);
    list.push_back(design_json(log, *design));
    if (list.size() == most_alternatives) break;
  }
  return list;
}

/// Alternatives whose single objective differs from the best by less than twice the scatter about
/// a fit that predicts.
void mark_ties(Json& json) {
  double scatter = 0.0;
  const Json& fits = json["effects"];
  const Json& best = json.at("recommended");
  // A formula is exact: the scatter of some other metric says nothing about it.
  const bool of_objective = best.is_object() && !fits.empty() && !best["objectives"].empty() &&
                            fits[0]["metric"] == best["objectives"][0]["metric"];
  if (of_objective && fits[0]["r2_left_out"].is_number() && fits[0]["r2_left_out"] >= rough_r2) {
    scatter = fits[0]["scatter"].get<double>();
  }
  for (Json& alternative : json["alternatives"]) {
    const Json& ours = json["recommended"]["objectives"];
    const Json& theirs = alternative["objectives"];
    alternative["within_scatter"] =
        ours.size() == 1 && theirs.size() == 1 && ours[0]["value"].is_number() &&
        theirs[0]["value"].is_number() &&
        std::abs(ours[0]["value"].get<double>() - theirs[0]["value"].get<double>()) < 2.0 * scatter;
  }
}

/// The recommended design against the best starting design; null without a usable one.
Json improvement_json(const StudyLog& log, const LoggedDesign& best) {
  const LoggedDesign* start = nullptr;
  for (const bool feasible : {true, false}) {
    for (const LoggedDesign* design : ranked(log, feasible)) {
      if (start == nullptr && design->stage == "start") start = design;
    }
  }
  if (start == nullptr) return nullptr;
  Json json{{"start_id", start->id},
            {"start_feasible", start->feasible},
            {"same_design", start->id == best.id},
            {"start_design", design_json(log, *start)["design"]},
            {"objective_scalar_start", optional_json(start->objective_scalar)},
            {"objective_scalar_best", optional_json(best.objective_scalar)},
            {"objectives", Json::array()}};
  for (std::size_t k = 0; k < std::min(best.objectives.size(), start->objectives.size()); ++k) {
    const LoggedObjective& objective = best.objectives[k];
    const std::optional<double> from = start->objectives[k].value;
    std::optional<double> change;
    if (from && objective.value) change = *objective.value - *from;
    const bool more = objective.goal != "minimize";
    json["objectives"].push_back(
        {{"name", objective.metric},
         {"metric", objective.of},
         {"goal", objective.goal},
         {"start", optional_json(from)},
         {"best", optional_json(objective.value)},
         {"change", optional_json(change)},
         {"change_percent", percent_json(change, from)},
         {"better", change ? Json(more ? *change > 0.0 : *change < 0.0) : Json(nullptr)}});
  }
  return json;
}

Json failed_json(const StudyLog& log) {
  Json list = Json::array();
  for (const LoggedDesign& design : log.designs) {
    if (design.ok) continue;
    list.push_back(
        {{"id", design.id}, {"design", written_design(log, design)}, {"reason", design.reason}});
  }
  return list;
}

Json definitions_json(const StudyLog& log) {
  Json json = Json::object();
  for (const solver::MetricInfo& info : solver::metric_catalog(log.barriers())) {
    json[info.key] = info.definition;
  }
  return json;
}

Json reproduce_json(const StudyLog& log, const study::PickRule& rule, const LoggedDesign& design) {
  const Json values = written_design(log, design);
  std::string evaluate = fmt::format("parapet evaluate SPEC.json --design '{}'", values.dump());
  if (design.spacing) evaluate += fmt::format(" --spacing-mm {:.10g}", 1000.0 * *design.spacing);
  return {{"evaluate", evaluate},
          {"optimize", "parapet optimize SPEC.json --out STUDY_DIR"},
          {"recommend", "parapet recommend STUDY_DIR" + study::command_line(rule)},
          {"spec",
           "SPEC.json is the study's spec; study.json holds it with every default under "
           "/spec"},
          {"spec_hash", log.spec_hash},
          {"provenance", log.provenance}};
}

Json candidates_json(const StudyLog& log, const std::vector<Candidate>& list) {
  Json json = Json::array();
  for (const Candidate& candidate : list) {
    json.push_back({{"id", candidate.design->id},
                    {"design", written_design(log, *candidate.design)},
                    {"objectives", estimates_json(candidate)},
                    {"probability_feasible", optional_json(candidate.probability_feasible())},
                    {"probability_limits", optional_json(candidate.probability_limits)},
                    {"within_limits", candidate.within_limits},
                    {"score", candidate.score}});
  }
  return json;
}

Json rule_json(const Choice& choice, const study::PickRule& rule) {
  Json limits = Json::array();
  for (const study::ObjectiveLimit& limit : rule.limits) {
    limits.push_back({{"objective", limit.objective},
                      {"lower", optional_json(limit.lower)},
                      {"upper", optional_json(limit.upper)}});
  }
  return {{"name", to_string(choice.kind)},
          {"limits", limits},
          {"words", choice.words},
          {"all_doubtful", choice.all_doubtful},
          {"allows_none", choice.ranked.empty() && !choice.front.empty()}};
}

/// The design that an engineer would look at when nothing is recommended: of the front when the
/// rule's limits allow none of it, else the one that misses the constraints least.
const LoggedDesign* nearest_design(const StudyLog& log, const Choice& choice) {
  if (!choice.ranked.empty()) return nullptr;
  const std::vector<const LoggedDesign*> infeasible = ranked(log, false);
  if (!choice.front.empty() || infeasible.empty()) return nullptr;
  return infeasible.front();
}

Json recommended_json(const StudyLog& log, const Confirmed& confirmed) {
  if (confirmed.pick == nullptr) return nullptr;
  Json json = design_json(log, *confirmed.pick->design);
  json["estimates"] = estimates_json(*confirmed.pick);
  json["probability_feasible"] = optional_json(confirmed.pick->probability_feasible());
  json["probability_limits"] = optional_json(confirmed.pick->probability_limits);
  return json;
}

}  // namespace

Recommendation recommend(const std::filesystem::path& study_dir, const study::PickRule& rule) {
  const StudyLog log = read_study_log(study_dir);
  const Choice choice = choose(log, rule);
  const Confirmed confirmed = confirmed_pick(log, choice);
  const LoggedDesign* best = confirmed.pick != nullptr ? confirmed.pick->design : nullptr;
  const LoggedDesign* nearest = nearest_design(log, choice);

  Recommendation out;
  out.feasible = best != nullptr;
  Json& json = out.json;
  json["format"] = "parapet-recommendation/1";
  json["study"] = study_json(log);
  json["rule"] = rule_json(choice, rule);
  json["feasible"] = out.feasible;
  json["recommended"] = recommended_json(log, confirmed);
  json["confirmation"] = confirmation_json(log, confirmed);
  json["least_violating"] = nearest != nullptr ? design_json(log, *nearest) : Json(nullptr);
  if (nearest != nullptr) json["least_violating"]["violation"] = nearest->violation();
  json["front"] = log.n_objectives() > 1 ? candidates_json(log, choice.front) : Json(Json::array());
  json["leaving"] =
      log.n_objectives() > 1 && best != nullptr ? leaving_json(choice, *best) : Json(Json::array());
  json["hypervolume"] = hypervolume_json(log);
  json["improvement"] = best != nullptr ? improvement_json(log, *best) : Json(nullptr);
  json["alternatives"] = alternatives_json(log, best);
  json["effects"] = log.all_numbers() ? effects_json(log) : Json(Json::array());
  if (log.n_objectives() <= 1) mark_ties(json);
  json["sensitivity"] = log.sensitivity;
  json["failed"] = failed_json(log);
  json["caveats"] = caveats_json(log, best, best != nullptr ? variables_json(log, *best) : Json());
  const LoggedDesign* shown = best != nullptr ? best : nearest;
  json["reproduce"] = shown != nullptr ? reproduce_json(log, rule, *shown) : Json(nullptr);
  json["definitions"] = definitions_json(log);
  out.markdown = recommendation_text(json);
  return out;
}

}  // namespace parapet::reports
