#include "parapet/study/front.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "parapet/math/pareto.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/scoring.hpp"
#include "to_objectives.hpp"

namespace parapet::study {
namespace {

using math::Objectives;
using records::EvaluationRecord;

bool counts(const designs::StudySpec& study, const EvaluationRecord& record) {
  return record.ok && record.feasible && record.spacing == designs::finest_spacing(study) &&
         record.objectives.size() == study.objectives.size() &&
         minimized_objectives(record).size() == study.objectives.size();
}

double sign(const designs::Objective& objective) {
  return objective.goal == designs::Goal::maximize ? -1.0 : 1.0;
}

/// To be minimised, like the points.
Objectives reference_point(const designs::StudySpec& study, const std::vector<Objectives>& points,
                           const std::vector<double>& given) {
  constexpr double beyond = 0.1;
  Objectives result = points.front();
  for (Eigen::Index j = 0; j < result.size(); ++j) {
    const designs::Objective& objective = study.objectives[static_cast<std::size_t>(j)];
    if (objective.reference) {
      result[j] = sign(objective) * *objective.reference;
      continue;
    }
    if (given.size() == study.objectives.size()) {
      result[j] = sign(objective) * given[static_cast<std::size_t>(j)];
      continue;
    }
    double worst = points.front()[j], best = worst;
    for (const Objectives& point : points) {
      worst = std::max(worst, point[j]);
      best = std::min(best, point[j]);
    }
    // Equal values leave no range: then a tenth of the value itself.
    const double range = worst > best ? worst - best : std::max(std::abs(worst), 1e-6);
    result[j] = worst + beyond * range;
  }
  return result;
}

/// Feasible designs by id, so that nothing depends on which simulation ended first.
std::map<std::string, const EvaluationRecord*> feasible_by_id(
    const designs::StudySpec& study, const std::vector<EvaluationRecord>& records) {
  std::map<std::string, const EvaluationRecord*> result;
  for (const EvaluationRecord& record : records) {
    if (counts(study, record)) result.emplace(record.id, &record);
  }
  return result;
}

std::vector<FrontEntry> make_history(const designs::StudySpec& study,
                                     const std::vector<EvaluationRecord>& records,
                                     const Objectives& reference) {
  std::vector<FrontEntry> history;
  std::vector<Objectives> front;
  FrontEntry entry;
  for (const EvaluationRecord& record : records) {
    ++entry.evaluations;
    entry.cpu_time += record.cpu_time;
    if (counts(study, record)) {
      const Objectives y = to_objectives(minimized_objectives(record));
      if (math::enter_front(front, y)) entry.hypervolume = math::hypervolume(front, reference);
    }
    history.push_back(entry);
  }
  return history;
}

}  // namespace

Front make_front(const designs::StudySpec& study, const std::vector<EvaluationRecord>& records,
                 const std::vector<double>& reference, bool with_history) {
  Front result;
  std::vector<Objectives> points;
  std::vector<const EvaluationRecord*> feasible;
  for (const auto& [id, record] : feasible_by_id(study, records)) {
    points.push_back(to_objectives(minimized_objectives(*record)));
    feasible.push_back(record);
  }
  if (points.empty()) return result;
  const Objectives at = reference_point(study, points, reference);
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    result.reference.push_back(sign(study.objectives[j]) * at[static_cast<Eigen::Index>(j)]);
  }
  std::vector<Objectives> front;
  for (const std::size_t k : math::non_dominated(points)) {
    result.designs.push_back(*feasible[k]);
    front.push_back(points[k]);
  }
  result.hypervolume = math::hypervolume(front, at);
  if (with_history) result.history = make_history(study, records, at);
  return result;
}

}  // namespace parapet::study
