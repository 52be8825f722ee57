/// From a study's log to advice: which arrangement to build, how sure, and what else would do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/study/pick_rule.hpp"

namespace parapet::reports {

struct Recommendation {
  bool feasible = false;  ///< false: no design meets every constraint, so nothing is recommended
  designs::Json json;     ///< format "parapet-recommendation/1"
  std::string markdown;   ///< the same for a reader
};

/// Reads study.json and evaluations.jsonl of a study folder, and where they are there pareto.json
/// (the surrogate's estimates), confirmations.jsonl and sensitivity.json; nothing is simulated or
/// written. Of the designs that the rule ranks, the first is recommended that no confirmation has
/// refuted.
/// A last line that is not complete (the study was killed, or is still running) is passed over.
/// @throws designs::InputError when a file is missing or damaged, nothing was evaluated yet, or the
///         rule does not fit the study's objectives.
Recommendation recommend(const std::filesystem::path& study_dir, const study::PickRule& rule = {});

/// The designs that meet every constraint as observed, best first: on the Pareto set for several
/// objectives. Those that the surrogate thinks more likely not to meet them come last.
/// @throws designs::InputError for a damaged study or a rule that does not fit its objectives
std::vector<study::Pick> ranked_picks(const std::filesystem::path& study_dir,
                                      const study::PickRule& rule = {});

/// Draws front.png (and front-1-3.png ... for more than two objectives) and hypervolume.png into
/// the study's folder; nothing for one objective. Returns the names of the files.
/// @throws FileError
std::vector<std::string> draw_study_plots(const std::filesystem::path& study_dir,
                                          const designs::Json& recommendation);

}  // namespace parapet::reports
