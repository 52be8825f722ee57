#include "parapet/study/comparable.hpp"

#include <algorithm>

namespace parapet::study {
namespace {

using records::ConstraintRecord;
using records::EvaluationRecord;

double scale_of(const designs::StudySpec& study, const ConstraintRecord& constraint) {
  const auto found =
      std::ranges::find(study.constraints, constraint.name, &designs::Constraint::name);
  return found == study.constraints.end() ? 1.0 : found->scale;
}

}  // namespace

double counted_spacing(const LoadedStudy& study) {
  for (const designs::FidelityLevel& level : study.spec.fidelity) {  // finest first
    const bool used = std::ranges::any_of(study.designs, [&](const EvaluationRecord& record) {
      return record.ok && record.spacing == level.spacing;
    });
    if (used) return level.spacing;
  }
  return designs::finest_spacing(study.spec);
}

std::vector<const EvaluationRecord*> comparable_designs(const LoadedStudy& study) {
  const double spacing = counted_spacing(study);
  std::vector<const EvaluationRecord*> list;
  for (const EvaluationRecord& record : study.designs) {
    if (record.ok && record.objective_scalar && record.spacing == spacing) list.push_back(&record);
  }
  return list;
}

std::vector<const EvaluationRecord*> ranked_designs(const LoadedStudy& study, bool feasible) {
  std::vector<const EvaluationRecord*> list = comparable_designs(study);
  std::erase_if(list, [&](const EvaluationRecord* one) { return one->feasible != feasible; });
  std::ranges::stable_sort(list, [&](const EvaluationRecord* a, const EvaluationRecord* b) {
    if (!feasible) {
      const double misses_a = violation(study.spec, *a), misses_b = violation(study.spec, *b);
      if (misses_a != misses_b) return misses_a < misses_b;
    }
    return *a->objective_scalar < *b->objective_scalar;
  });
  return list;
}

double violation(const designs::StudySpec& study, const EvaluationRecord& record) {
  double sum = 0.0;
  for (const ConstraintRecord& constraint : record.constraints) {
    if (constraint.satisfied) continue;
    sum +=
        constraint.margin ? std::max(0.0, -*constraint.margin) / scale_of(study, constraint) : 1.0;
  }
  return sum;
}

std::optional<double> nearer_limit(const ConstraintRecord& constraint) {
  const auto &value = constraint.value, &lower = constraint.lower, &upper = constraint.upper;
  if (lower && upper && value) return *value - *lower < *upper - *value ? lower : upper;
  return lower ? lower : upper;
}

}  // namespace parapet::study
