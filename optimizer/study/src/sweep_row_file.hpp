/// rows/ID.json: one finished row of a sweep.
#pragma once

#include <filesystem>
#include <optional>

#include "parapet/designs/study_spec.hpp"
#include "parapet/reports/provenance.hpp"
#include "parapet/reports/sweep_table.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::study {

/// The row as it was finished before by the same version of the program; empty when it must be run.
/// @throws designs::InputError when the file is of another spec or not a result.
std::optional<reports::SweepRowResult> read_finished_row(const std::filesystem::path& folder,
                                                         const designs::SweepRow& row,
                                                         const reports::ProgramInfo& program);

/// Writes the series, then the result.
/// @throws reports::FileError
void write_finished_row(const std::filesystem::path& folder, const designs::SweepRow& row,
                        const solver::Result& result, const reports::ProgramInfo& program,
                        int threads);

}  // namespace parapet::study
