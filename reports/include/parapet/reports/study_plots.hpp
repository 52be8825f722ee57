/// Pictures of a study's front and of its search.
#pragma once

#include <filesystem>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// Draws front.png (and front-1-3.png ... for more than two objectives) and hypervolume.png into a
/// folder; nothing for one objective. Returns the names of the files.
/// @throws FileError
std::vector<std::string> draw_study_plots(const std::filesystem::path& folder,
                                          const Recommendation& recommendation);

}  // namespace parapet::reports
