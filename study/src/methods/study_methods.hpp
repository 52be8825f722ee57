/// The ways to search, each with the same outcome.
#pragma once

#include "output_writer.hpp"
#include "parapet/study/study_context.hpp"
#include "parapet/study/study_run.hpp"

namespace parapet::study {

/// Searches as the study's method says. What is returned is complete but for what the log tells.
/// @throws what stopped it, if that was a failure: records::FileError
StudySummary search_study(const StudyContext& context, OutputWriter& writer);

}  // namespace parapet::study
