#include "front_json.hpp"

#include "design_json.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

Json step_json(const FrontStep& step) {
  return {{"id", step.id}, {"changes", step.changes}};
}

}  // namespace

Json to_json(const FrontDesign& design) {
  return {{"id", design.id},
          {"design", to_json(design.design)},
          {"objectives", estimates_json(design.objectives)},
          {"probability_feasible", optional_json(design.probability_feasible)},
          {"probability_limits", optional_json(design.probability_limits)},
          {"within_limits", design.within_limits},
          {"score", design.score},
          {"share", optional_json(design.share)}};
}

Json to_json(const WayOut& way) {
  return {
      {"objective", way.objective}, {"next", step_json(way.next)}, {"best", step_json(way.best)}};
}

Json to_json(const Progress& progress) {
  Json reference = Json::array(), history = Json::array();
  for (const std::optional<double>& value : progress.reference) {
    reference.push_back(optional_json(value));
  }
  for (const study::FrontEntry& entry : progress.history) {
    history.push_back({{"evaluations", entry.evaluations},
                       {"cpu_time_s", entry.cpu_time},
                       {"hypervolume", entry.hypervolume}});
  }
  return {{"value", optional_json(progress.hypervolume)},
          {"reference", std::move(reference)},
          {"history", std::move(history)}};
}

}  // namespace parapet::reports
