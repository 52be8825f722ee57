#include "confirmation_json.hpp"

#include "design_json.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

const char* verdict_word(study::Verdict verdict) {
  if (verdict == study::Verdict::none) return "none";
  return verdict == study::Verdict::confirmed ? "confirmed" : "refuted";
}

Json run_json(const ConfirmingRun& run) {
  Json objectives = Json::array();
  for (const std::optional<double>& value : run.objectives) {
    objectives.push_back(optional_json(value));
  }
  return {{"id", run.id},
          {"stage", run.stage},
          {"spacing_m", run.spacing},
          {"ok", run.ok},
          {"reason", run.reason},
          {"feasible", run.feasible},
          {"objectives", std::move(objectives)},
          {"violated", run.violated},
          {"worse", run.worse}};
}

}  // namespace

Json to_json(const Confirmation& confirmation) {
  Json runs = Json::array(), spread = Json::array(), refuted = Json::array();
  for (const ConfirmingRun& run : confirmation.runs) runs.push_back(run_json(run));
  for (const Spread& one : confirmation.spread) {
    spread.push_back({{"name", one.name},
                      {"metric", one.metric},
                      {"runs", one.runs},
                      {"least", one.least},
                      {"greatest", one.greatest},
                      {"standard_deviation", one.standard_deviation}});
  }
  for (const RefutedDesign& one : confirmation.refuted) {
    refuted.push_back({{"id", one.id}, {"violated", one.violated}, {"worse", one.worse}});
  }
  return {{"verdict", verdict_word(confirmation.verdict)},
          {"runs", std::move(runs)},
          {"spread", std::move(spread)},
          {"refuted", std::move(refuted)},
          {"constraints_tested", confirmation.constraints_tested},
          {"objectives_tested", confirmation.objectives_tested}};
}

}  // namespace parapet::reports
