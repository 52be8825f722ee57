/// Recordings at the end of a study or a sweep, with progress and messages.
#pragma once

#include <filesystem>
#include <vector>

#include "parapet/study/record_flows.hpp"
#include "session.hpp"

namespace parapet::cli {

/// Records the flows into the folder, which it locks, and enters them into its checksums.
/// @return false when it was interrupted
bool record_and_say(const Session& session, const std::filesystem::path& folder,
                    std::vector<study::FlowToRecord> flows, int jobs, bool only_these = true);

}  // namespace parapet::cli
