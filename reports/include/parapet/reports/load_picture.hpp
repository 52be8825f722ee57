/// The pressures of the design load over the height of stems and the length of deflectors.
#pragma once

#include <filesystem>
#include <string>

#include "parapet/solver/result.hpp"

namespace parapet::reports {

/// Whether there is anything to draw.
bool acts_on_barriers(const solver::Result& result);

/// Draws a curve for each part of a barrier, pressure to the right, distance from the stem's foot
/// or the deflector's crest upwards.
/// @param path ends in .png or .svg  @pre acts_on_barriers
/// @throws FileError when the file cannot be written.
void draw_load_profiles(const std::filesystem::path& path, const std::string& name,
                        const solver::Result& result);

}  // namespace parapet::reports
