/// The undisturbed flow of an event as approach.json.
#pragma once

#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::records {

/// The content of approach.json, format "parapet-approach/1".
/// @param spec the case whose barriers the flow would meet
/// @param open without them
/// @param with_barriers the run of `spec` itself, given that flow; nullptr: not simulated
/// @param provenance of provenance_json, with the hash of `spec`
designs::Json approach_file_json(const designs::CaseSpec& spec, const solver::UndisturbedRun& open,
                                 const solver::Result* with_barriers,
                                 const designs::Json& provenance);

/// The profile in such a file.
/// @throws nlohmann::json::exception
solver::ApproachProfile profile_from_json(const designs::Json& file);

}  // namespace parapet::records
