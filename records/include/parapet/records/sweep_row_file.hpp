/// rows/ID.json: one finished row of a sweep.
#pragma once

#include <filesystem>
#include <optional>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/sweep_row.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::records {

/// The row as it was finished before by the same version and physics of the program; empty when it
/// must be run.
/// @throws designs::InputError when the file is of another spec or not a result.
std::optional<SweepRowResult> read_finished_row(const std::filesystem::path& folder,
                                                const designs::SweepRow& row,
                                                const ProgramInfo& program);

/// Writes the series, then the result.
/// @throws FileError
void write_finished_row(const std::filesystem::path& folder, const designs::SweepRow& row,
                        const solver::Result& result, const ProgramInfo& program, int threads);

}  // namespace parapet::records
