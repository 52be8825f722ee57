#include "parapet/reports/recommendation_json.hpp"

#include "confirmation_json.hpp"
#include "design_json.hpp"
#include "front_json.hpp"
#include "page_one_json.hpp"
#include "study_json.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

Json to_json(const RuleFacts& rule) {
  Json limits = Json::array();
  for (const study::ObjectiveLimit& limit : rule.limits) {
    limits.push_back({{"objective", limit.objective},
                      {"lower", optional_json(limit.lower)},
                      {"upper", optional_json(limit.upper)}});
  }
  Json ties = Json::array();
  for (const TiedDesign& one : rule.ties) {
    ties.push_back({{"id", one.id},
                    {"share", one.share},
                    {"margin", optional_json(one.margin)},
                    {"probability_feasible", optional_json(one.probability_feasible)}});
  }
  return {{"name", study::to_string(rule.kind)},
          {"limits", std::move(limits)},
          {"words", rule.words},
          {"all_doubtful", rule.all_doubtful},
          {"allows_none", rule.allows_none},
          {"share", optional_json(rule.share)},
          {"draws", rule.draws},
          {"bulge", optional_json(rule.bulge)},
          {"no_knee", rule.no_knee},
          {"knee_share", optional_json(rule.knee_share)},
          {"first_by_rule", rule.first_by_rule},
          {"ties", std::move(ties)}};
}

Json to_json(const RecommendedDesign& recommended) {
  Json json = reports::to_json(recommended.design);
  json.update({{"estimates", estimates_json(recommended.estimates)},
               {"probability_feasible", optional_json(recommended.probability_feasible)},
               {"probability_limits", optional_json(recommended.probability_limits)},
               {"repeat_spacing_m", recommended.repeat_spacing},
               {"margin_in_uncertainties", optional_json(recommended.margin)},
               {"repeat", repeat_json(recommended.repeat)}});
  return json;
}

Json to_json(const LeastViolatingDesign& least) {
  Json json = reports::to_json(least.design);
  json.emplace("violation", least.violation);
  return json;
}

Json to_json(const ObjectiveChange& change) {
  return {{"name", change.name},
          {"metric", change.of},
          {"goal", goal_word(change.goal)},
          {"start", optional_json(change.start)},
          {"best", optional_json(change.best)},
          {"change", optional_json(change.change)},
          {"change_percent", optional_json(change.change_percent)},
          {"better", change.better ? Json(*change.better) : Json(nullptr)}};
}

Json to_json(const Improvement& improvement) {
  Json objectives = Json::array();
  for (const ObjectiveChange& change : improvement.objectives)
    objectives.push_back(to_json(change));
  return {{"start_id", improvement.start_id},
          {"start_feasible", improvement.start_feasible},
          {"same_design", improvement.same_design},
          {"start_design", reports::to_json(improvement.start_design)},
          {"objective_scalar_start", optional_json(improvement.scalar_start)},
          {"objective_scalar_best", optional_json(improvement.scalar_best)},
          {"objectives", std::move(objectives)}};
}

Json to_json(const Alternative& alternative) {
  Json json = reports::to_json(alternative.design);
  if (alternative.within_scatter) json.emplace("within_scatter", *alternative.within_scatter);
  return json;
}

Json to_json(const MetricResponse& fit) {
  Json variables = Json::object();
  for (const VariableResponse& one : fit.variables) {
    variables[one.variable] = {{"tried_from", one.tried_from},
                               {"tried_to", one.tried_to},
                               {"change", optional_json(one.change)},
                               {"standard_error", optional_json(one.standard_error)},
                               {"standardised_effect", optional_json(one.standardised)},
                               {"bend", optional_json(one.bend)},
                               {"clear", one.clear},
                               {"correlation", optional_json(one.correlation)},
                               {"says", one.says}};
  }
  return {{"metric", fit.metric},
          {"points", fit.points},
          {"model", fit.model},
          {"r2", optional_json(fit.r2)},
          {"r2_left_out", optional_json(fit.r2_left_out)},
          {"scatter", optional_json(fit.scatter)},
          {"verdict", fit.verdict},
          {"variables", std::move(variables)}};
}

Json to_json(const FailedDesign& failed) {
  return {
      {"id", failed.id}, {"design", reports::to_json(failed.design)}, {"reason", failed.reason}};
}

Json to_json(const Reproduction& reproduction) {
  return {{"evaluate", reproduction.evaluate},   {"optimize", reproduction.optimize},
          {"recommend", reproduction.recommend}, {"spec", reproduction.spec},
          {"spec_hash", reproduction.spec_hash}, {"provenance", reproduction.provenance}};
}

template <typename Part>
Json optional_part(const std::optional<Part>& part) {
  return part ? to_json(*part) : Json(nullptr);
}

template <typename Part>
Json list_json(const std::vector<Part>& parts) {
  Json list = Json::array();
  for (const Part& part : parts) list.push_back(to_json(part));
  return list;
}

}  // namespace

Json recommendation_json(const Recommendation& recommendation) {
  Json definitions = Json::object();
  for (const auto& [key, definition] : recommendation.definitions) definitions[key] = definition;
  return {{"format", "parapet-recommendation/1"},
          {"study", reports::to_json(recommendation.study)},
          {"page_one", reports::to_json(page_one(recommendation))},
          {"rule", to_json(recommendation.rule)},
          {"feasible", recommendation.recommended.has_value()},
          {"recommended", optional_part(recommendation.recommended)},
          {"confirmation", optional_part(recommendation.confirmation)},
          {"least_violating", optional_part(recommendation.least_violating)},
          {"front", list_json(recommendation.front)},
          {"leaving", list_json(recommendation.leaving)},
          {"hypervolume", optional_part(recommendation.progress)},
          {"improvement", optional_part(recommendation.improvement)},
          {"alternatives", list_json(recommendation.alternatives)},
          {"effects", list_json(recommendation.effects)},
          {"sensitivity", optional_part(recommendation.sensitivity)},
          {"failed", list_json(recommendation.failed)},
          {"caveats", recommendation.caveats},
          {"reproduce", optional_part(recommendation.reproduce)},
          {"definitions", std::move(definitions)}};
}

}  // namespace parapet::reports
