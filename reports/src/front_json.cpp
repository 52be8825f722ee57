#include <algorithm>
#include <cmath>

#include "recommendation_json.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

/// Distance of two points of the front, each objective over its range.
double apart(const FrontRange& range, const ObjectiveValues& a, const ObjectiveValues& b) {
  const ObjectiveValues one = range.normalised(a), other = range.normalised(b);
  double squares = 0.0;
  for (std::size_t j = 0; j < one.size(); ++j) {
    squares += (one[j] - other[j]) * (one[j] - other[j]);
  }
  return std::sqrt(squares);
}

Json step_json(const Candidate& from, const Candidate& to) {
  Json json{{"id", to.design->id}, {"changes", Json::array()}};
  for (std::size_t j = 0; j < from.values.size(); ++j) {
    json["changes"].push_back(*to.design->objectives[j].value - *from.design->objectives[j].value);
  }
  return json;
}

}  // namespace

Json leaving_json(const Choice& choice, const LoggedDesign& from) {
  Json list = Json::array();
  const auto own = std::ranges::find(choice.front, &from, &Candidate::design);
  if (own == choice.front.end()) return list;
  std::vector<ObjectiveValues> values;
  for (const Candidate& candidate : choice.front) values.push_back(candidate.values);
  const FrontRange range = range_of(values);
  for (std::size_t j = 0; j < own->values.size(); ++j) {
    const Candidate *next = nullptr, *end = nullptr;
    for (const Candidate& other : choice.front) {
      if (!(other.values[j] < own->values[j])) continue;
      if (next == nullptr ||
          apart(range, own->values, other.values) < apart(range, own->values, next->values)) {
        next = &other;
      }
      if (end == nullptr || other.values[j] < end->values[j]) end = &other;
    }
    if (next == nullptr) continue;
    Json one{{"objective", j}, {"next", step_json(*own, *next)}, {"best", step_json(*own, *end)}};
    list.push_back(std::move(one));
  }
  return list;
}

Json hypervolume_json(const StudyLog& log) {
  if (!log.pareto.is_object() || log.n_objectives() < 2) return nullptr;
  Json json{{"value", log.pareto.value("hypervolume", Json())},
            {"reference", Json::array()},
            {"history", log.pareto.value("history", Json::array())}};
  for (const Json& objective : log.pareto.value("objectives", Json::array())) {
    json["reference"].push_back(objective.value("reference", Json()));
  }
  return json;
}

}  // namespace parapet::reports
