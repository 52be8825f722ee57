/// From a study's log to advice: which arrangement to build, how sure, and what else would do.
#pragma once

#include <filesystem>
#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::reports {

struct Recommendation {
  bool feasible = false;  ///< false: no design meets every constraint, so nothing is recommended
  designs::Json json;     ///< format "parapet-recommendation/1"
  std::string markdown;   ///< the same for a reader
};

/// Reads study.json and evaluations.jsonl of a study folder; nothing is simulated or written.
/// A last line that is not complete (the study was killed, or is still running) is passed over.
/// @throws designs::InputError when a file is missing or damaged, or nothing was evaluated yet.
Recommendation recommend(const std::filesystem::path& study_dir);

}  // namespace parapet::reports
