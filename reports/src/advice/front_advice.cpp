#include "front_advice.hpp"

#include <algorithm>
#include <cmath>

#include "design_advice.hpp"

namespace parapet::reports {
namespace {

using study::Candidate;

/// Distance of two points of the front, each objective over its range.
double apart(const study::FrontRange& range, const Candidate& a, const Candidate& b) {
  const std::vector<double> one = range.normalised(a.values), other = range.normalised(b.values);
  double squares = 0.0;
  for (std::size_t j = 0; j < one.size(); ++j) {
    squares += (one[j] - other[j]) * (one[j] - other[j]);
  }
  return std::sqrt(squares);
}

FrontStep step(const Candidate& from, const Candidate& to) {
  FrontStep result{.id = to.design->id, .changes = {}};
  for (std::size_t j = 0; j < from.values.size(); ++j) {
    result.changes.push_back(*to.design->objectives[j].value - *from.design->objectives[j].value);
  }
  return result;
}

}  // namespace

std::vector<FrontDesign> front_designs(const designs::StudySpec& study,
                                       const study::Choice& choice) {
  std::vector<FrontDesign> list;
  for (const Candidate& candidate : choice.front) {
    list.push_back({.id = candidate.design->id,
                    .design = written_design(study, candidate.design->design),
                    .objectives = estimates_of(study, candidate),
                    .probability_feasible = candidate.probability_feasible(),
                    .probability_limits = candidate.probability_limits,
                    .within_limits = candidate.within_limits,
                    .score = candidate.score,
                    .share = candidate.share});
  }
  return list;
}

std::vector<WayOut> ways_out(const study::Choice& choice, const records::EvaluationRecord& from) {
  const auto own = std::ranges::find(choice.front, &from, &Candidate::design);
  if (own == choice.front.end()) return {};
  std::vector<std::vector<double>> values;
  for (const Candidate& candidate : choice.front) values.push_back(candidate.values);
  const study::FrontRange range = study::range_of(values);
  std::vector<WayOut> list;
  for (std::size_t j = 0; j < own->values.size(); ++j) {
    const Candidate *next = nullptr, *end = nullptr;
    for (const Candidate& other : choice.front) {
      if (!(other.values[j] < own->values[j])) continue;
      if (next == nullptr || apart(range, *own, other) < apart(range, *own, *next)) next = &other;
      if (end == nullptr || other.values[j] < end->values[j]) end = &other;
    }
    if (next == nullptr) continue;
    list.push_back({.objective = j, .next = step(*own, *next), .best = step(*own, *end)});
  }
  return list;
}

std::optional<Progress> search_progress(const study::LoadedStudy& study) {
  if (!study.front || study.spec.objectives.size() < 2) return std::nullopt;
  return Progress{.hypervolume = study.front->hypervolume,
                  .reference = study.front->reference,
                  .history = study.front->history};
}

}  // namespace parapet::reports
