// The event of a case without its barriers: simulated, and written.
#pragma once

#include <filesystem>

#include "parapet/designs/case_spec.hpp"
#include "session.hpp"

namespace parapet::cli {

/// @throws designs::InputError for a case without barriers
void require_barrier(const designs::CaseSpec& spec, const std::string& file);

/// Simulates it on up to `jobs` threads, gauged as far as the last barrier's foot.
solver::UndisturbedRun run_undisturbed(const Session& session, const designs::CaseSpec& spec,
                                       int jobs);

/// Writes approach.json into the folder and returns its content.
/// @param with_barriers the run of the case itself
/// @throws records::FileError
designs::Json write_approach(const Session& session, const designs::CaseSpec& spec,
                             const solver::UndisturbedRun& open,
                             const solver::Result* with_barriers,
                             const std::filesystem::path& folder);

}  // namespace parapet::cli
