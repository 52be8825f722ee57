/// Hashes that tell whether two inputs ask for the same thing, whatever their names.
#pragma once

#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::records {

/// Hash of everything in a case that decides its result: not its name, description or frames.
std::string case_hash(const designs::CaseSpec& spec);

/// The same of a resolved case as JSON.
std::string case_hash(designs::Json resolved);

/// Hash of everything in a study that decides what is evaluated and how it is judged: not its name
/// or description, nor when it ends (max_evaluations, max_time_s and the like), so that a study can
/// be continued with a larger budget; except where max_evaluations decides which designs are asked
/// for (is_laid_out_for_budget).
std::string study_hash(const designs::StudySpec& study);

}  // namespace parapet::records
