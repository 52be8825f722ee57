/// A design that somebody else's optimiser asked for, as a record.
#pragma once

#include "parapet/records/study_folder.hpp"
#include "parapet/study/design_run.hpp"

namespace parapet::study {

/// The record of a design that was simulated, outside any log: id "0001", stage "external".
records::EvaluationRecord external_record(const DesignRun& run,
                                          const records::ProgramInfo& program);

/// Writes it into a study's log under the next free id.
/// @param with_report whether evaluations/ID.json and the files of the scenarios are written too
/// @return what stands in the log: the record that was there already when another process was
///         faster
/// @throws records::FileError
records::EvaluationRecord log_external(records::StudyFolder& folder,
                                       const designs::StudySpec& study, const DesignRun& run,
                                       const records::ProgramInfo& program, bool with_report);

}  // namespace parapet::study
