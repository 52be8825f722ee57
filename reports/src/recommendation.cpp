#include "parapet/reports/recommendation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "parapet/solver/result.hpp"
#include "recommendation_caveats.hpp"
#include "recommendation_parts.hpp"
#include "study_log.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

constexpr double active_share = 0.02;    // a margin below this share of the limit is "active"
constexpr double at_bound_share = 0.01;  // of a variable's range
constexpr double distinct_share = 0.05;  // of some variable's range, between alternatives
constexpr std::size_t most_alternatives = 5;

Json optional_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json percent(const std::optional<double>& part, const std::optional<double>& whole) {
  if (!part || !whole || *whole == 0.0) return nullptr;
  return 100.0 * *part / std::abs(*whole);
}

Json constraint_json(const LoggedConstraint& constraint) {
  const std::optional<double> margin = constraint.margin();
  const std::optional<double> limit = constraint.nearer_limit();
  const double size = limit && *limit != 0.0 ? std::abs(*limit) : 1.0;
  Json json{{"name", constraint.name}};
  if (!constraint.of.empty()) json[constraint.on_metric ? "metric" : "expression"] = constraint.of;
  json["value"] = optional_json(constraint.value);
  json["lower"] = optional_json(constraint.lower);
  json["upper"] = optional_json(constraint.upper);
  json["satisfied"] = constraint.satisfied;
  json["margin"] = optional_json(margin);
  json["margin_percent"] = percent(margin, limit);
  json["active"] = constraint.satisfied && margin && *margin <= active_share * size;
  return json;
}

Json objectives_json(const LoggedDesign& design) {
  Json list = Json::array();
  for (const LoggedObjective& objective : design.objectives) {
    list.push_back({{"metric", objective.metric},
                    {"goal", objective.goal},
                    {"weight", objective.weight},
                    {"value", optional_json(objective.value)},
                    {"absent", objective.absent}});
  }
  return list;
}

Json variables_json(const StudyLog& log, const LoggedDesign& design) {
  Json list = Json::array();
  for (const LoggedVariable& variable : log.variables) {
    const auto found = design.design.find(variable.name);
    if (found == design.design.end()) continue;  // does not exist under the options taken
    const double value = found->second;
    const double near = at_bound_share * (variable.upper - variable.lower);
    const char* bound = variable.choice                  ? nullptr
                        : value - variable.lower <= near ? "lower"
                        : variable.upper - value <= near ? "upper"
                                                         : nullptr;
    list.push_back({{"name", variable.name},
                    {"value", value},
                    {"lower", variable.lower},
                    {"upper", variable.upper},
                    {"at_bound", bound != nullptr ? Json(bound) : Json(nullptr)}});
  }
  return list;
}

Json design_json(const StudyLog& log, const LoggedDesign& design) {
  Json json{{"id", design.id}, {"stage", design.stage}};
  json["design"] = Json::object();
  for (const LoggedVariable& variable : log.variables) {
    const auto found = design.design.find(variable.name);
    json["design"][variable.name] =
        found == design.design.end() ? Json(nullptr) : Json(found->second);
  }
  json["variables"] = variables_json(log, design);
  json["spacing_m"] = optional_json(design.spacing);
  json["objective_scalar"] = optional_json(design.objective_scalar);
  json["objectives"] = objectives_json(design);
  json["constraints"] = Json::array();
  for (const LoggedConstraint& constraint : design.constraints) {
    json["constraints"].push_back(constraint_json(constraint));
  }
  json["metrics"] = Json::object();
  json["metrics_absent"] = Json::object();
  for (const solver::Metric& metric : design.metrics) {
    json["metrics"][metric.key] = optional_json(metric.value);
    if (!metric.value) json["metrics_absent"][metric.key] = metric.absent_reason;
  }
  return json;
}

/// Usable designs from best to worst: the feasible by objective, or the others by violation.
std::vector<const LoggedDesign*> ranked(const StudyLog& log, bool feasible) {
  std::vector<const LoggedDesign*> list;
  for (const LoggedDesign& design : log.designs) {
    if (design.ok && design.feasible == feasible && design.objective_scalar) {
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
    const auto in_a = a.design.find(variable.name), in_b = b.design.find(variable.name);
    const bool absent_in_a = in_a == a.design.end(), absent_in_b = in_b == b.design.end();
    if (absent_in_a || absent_in_b) return absent_in_a != absent_in_b;
    const double apart = std::abs(in_a->second - in_b->second);
    return apart >= distinct_share * (variable.upper - variable.lower) && apart > 0.0;
  });
}

Json alternatives_json(const StudyLog& log, const std::vector<const LoggedDesign*>& feasible) {
  std::vector<const LoggedDesign*> chosen;
  Json list = Json::array();
  for (const LoggedDesign* design : feasible) {
    const bool apart = std::ranges::all_of(
        chosen, [&](const LoggedDesign* other) { return distinct(log, *design, *other); });
    if (!apart) continue;
    chosen.push_back(design);
    if (chosen.size() > 1) list.push_back(design_json(log, *design));  // the first is recommended
    if (list.size() == most_alternatives) break;
  }
  return list;
}

/// Alternatives whose single objective differs from the best by less than twice the scatter about
/// a fit that predicts.
void mark_ties(Json& json) {
  double scatter = 0.0;
  const Json& fits = json["effects"];
  if (!fits.empty() && fits[0]["r2_left_out"].is_number() && fits[0]["r2_left_out"] >= rough_r2) {
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
        {{"metric", objective.metric},
         {"goal", objective.goal},
         {"start", optional_json(from)},
         {"best", optional_json(objective.value)},
         {"change", optional_json(change)},
         {"change_percent", percent(change, from)},
         {"better", change ? Json(more ? *change > 0.0 : *change < 0.0) : Json(nullptr)}});
  }
  return json;
}

Json failed_json(const StudyLog& log) {
  Json list = Json::array();
  for (const LoggedDesign& design : log.designs) {
    if (design.ok) continue;
    list.push_back({{"id", design.id}, {"design", design.design}, {"reason", design.reason}});
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

Json reproduce_json(const StudyLog& log, const LoggedDesign& design) {
  const Json values = design_json(log, design)["design"];
  std::string evaluate = fmt::format("parapet evaluate SPEC.json --design '{}'", values.dump());
  if (design.spacing) evaluate += fmt::format(" --spacing-mm {:g}", 1000.0 * *design.spacing);
  return {{"evaluate", evaluate},
          {"optimize", "parapet optimize SPEC.json"},
          {"spec",
           "SPEC.json is the study's spec; study.json holds it with every default under "
           "/spec"},
          {"spec_hash", log.spec_hash},
          {"provenance", log.provenance}};
}

Json study_json(const StudyLog& log) {
  int ok = 0, feasible = 0;
  for (const LoggedDesign& design : log.designs) {
    ok += design.ok ? 1 : 0;
    feasible += design.feasible ? 1 : 0;
  }
  const auto name = log.spec.find("name");
  return {{"name", name != log.spec.end() && name->is_string() ? *name : Json("study")},
          {"folder", log.folder},
          {"evaluations", log.designs.size()},
          {"ok", ok},
          {"failed", static_cast<int>(log.designs.size()) - ok},
          {"feasible", feasible},
          {"log_complete", !log.incomplete_last_line}};
}

}  // namespace

Recommendation recommend(const std::filesystem::path& study_dir) {
  const StudyLog log = read_study_log(study_dir);
  const std::vector<const LoggedDesign*> feasible = ranked(log, true);
  const std::vector<const LoggedDesign*> infeasible = ranked(log, false);
  const LoggedDesign* best = feasible.empty() ? nullptr : feasible.front();
  const LoggedDesign* nearest =
      best == nullptr && !infeasible.empty() ? infeasible.front() : nullptr;

  Recommendation out;
  out.feasible = best != nullptr;
  Json& json = out.json;
  json["format"] = "parapet-recommendation/1";
  json["study"] = study_json(log);
  json["feasible"] = out.feasible;
  json["recommended"] = best != nullptr ? design_json(log, *best) : Json(nullptr);
  json["least_violating"] = nearest != nullptr ? design_json(log, *nearest) : Json(nullptr);
  if (nearest != nullptr) json["least_violating"]["violation"] = nearest->violation();
  json["improvement"] = best != nullptr ? improvement_json(log, *best) : Json(nullptr);
  json["alternatives"] = alternatives_json(log, feasible);
  json["effects"] = effects_json(log);
  mark_ties(json);
  json["failed"] = failed_json(log);
  json["caveats"] = caveats_json(log, best, best != nullptr ? variables_json(log, *best) : Json());
  const LoggedDesign* shown = best != nullptr ? best : nearest;
  json["reproduce"] = shown != nullptr ? reproduce_json(log, *shown) : Json(nullptr);
  json["definitions"] = definitions_json(log);
  out.markdown = recommendation_text(json);
  return out;
}

}  // namespace parapet::reports
