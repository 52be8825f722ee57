/// The nearest known word for a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parapet::designs {

/// The last token of a JSON pointer that is a key, not an index: it carries the unit.
std::string last_key(const std::string& pointer);

/// The candidate that was most likely meant, or "" when none is near. A forgotten or foreign unit
/// (height, height_mm for height_m) counts as near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean "..."?", or "" when no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace parapet::designs
