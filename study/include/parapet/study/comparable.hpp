/// Which designs of a study can be compared, and how far a design misses its constraints.
#pragma once

#include <optional>
#include <vector>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/study/loaded_study.hpp"

namespace parapet::study {

/// The particle spacing that counts: the finest of the spec at which a simulation ended well, else
/// the finest of these [m].
double counted_spacing(const LoadedStudy& study);

/// The designs that ended well with a value of every objective at that spacing, in the log's order.
/// They point into the study.
std::vector<const records::EvaluationRecord*> comparable_designs(const LoadedStudy& study);

/// Those of them that meet every constraint, best objective_scalar first; or the others, least
/// violation first. Equal ones stay in the log's order.
std::vector<const records::EvaluationRecord*> ranked_designs(const LoadedStudy& study,
                                                             bool feasible);

/// Sum over the constraints of the distance outside the limit, each over its scale; 1 for each that
/// asks for a value which is not there.
double violation(const designs::StudySpec& study, const records::EvaluationRecord& record);

/// The limit that a constraint's margin is measured from.
std::optional<double> nearer_limit(const records::ConstraintRecord& constraint);

}  // namespace parapet::study
