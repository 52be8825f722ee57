/// rows/ID.json: one finished row of a sweep.
#pragma once

#include <filesystem>
#include <optional>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/simulation.hpp"
#include "parapet/records/sweep_row.hpp"

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
                        const Simulation& simulation, const ProgramInfo& program);

/// What a row came to, from its simulation as it may have come from another machine.
SweepRowResult make_sweep_row_result(const designs::SweepRow& row, const Simulation& simulation);

}  // namespace parapet::records
