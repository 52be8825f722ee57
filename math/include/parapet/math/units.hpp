/// Units in keys: the suffix of a key ("height_m", "landing_speed_m_s") says its unit.
#pragma once

#include <string_view>

namespace parapet::math {

/// One unit in its three spellings; all three are empty for a pure number.
struct Unit {
  std::string_view suffix;       ///< as keys end: "_m3_per_m"
  std::string_view plain;        ///< ASCII, for messages: "m3/m"
  std::string_view typographic;  ///< UTF-8, for reports: "m³/m"
};

/// The unit that a key ends in; of several suffixes that fit, the longest ("_m_s", not "_s"). A
/// suffix alone is no key.
Unit unit_of(std::string_view key);

/// The key without the suffix of its unit.
std::string_view without_unit(std::string_view key);

}  // namespace parapet::math
