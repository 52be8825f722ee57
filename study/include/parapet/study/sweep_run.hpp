/// A whole sweep: its rows side by side, each kept as soon as it is finished.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/records/sweep_row.hpp"
#include "parapet/study/hooks.hpp"
#include "parapet/study/local_service.hpp"

namespace parapet::study {

/// Where a sweep runs, and which rows.
struct SweepRunOptions {
  std::filesystem::path folder;
  int jobs = 1;
  std::vector<std::string> only;  ///< ids of the rows to run; empty for all
  records::ProgramInfo program;
  Hooks hooks;  ///< on_evaluated is not called
  /// A row is finished and on disk; `kept`: it was before, and was not run again.
  std::function<void(const records::SweepRowResult& row, bool kept)> on_row;
  ServiceFactory service = local_service();  ///< who simulates
};

/// What a sweep came to.
struct SweepOutcome {
  std::vector<records::SweepRowResult> rows;  ///< of those asked for, the finished ones, in order
  bool interrupted = false;
};

/// Name of the file with all rows: the sweep's, as a file name.
std::string sweep_table_file(const designs::SweepSpec& sweep);

/// Runs the rows, longest first, and writes rows/ID.json, rows/ID.csv (the series) and, with all
/// rows finished so far, sweep_table_file; checksums.sha256 last. Rows that this version of the
/// program finished before are kept.
/// @throws designs::InputError for an unknown id, a folder that is being written to or that holds
///         rows of another spec, or anything that is not a sweep's (nothing is changed then);
///         records::FileError.
SweepOutcome run_sweep(const designs::SweepSpec& sweep, const SweepRunOptions& options);

}  // namespace parapet::study
