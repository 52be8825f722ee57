#include "parapet/math/units.hpp"

#include <array>
#include <cstddef>

namespace parapet::math {
namespace {

constexpr std::array units{
    Unit{"_n_m_per_m", "N m/m", "N m/m"},
    Unit{"_n_s_per_m", "N s/m", "N s/m"},
    Unit{"_nm_per_m", "N m/m", "N m/m"},
    Unit{"_m3_per_m", "m3/m", "m³/m"},
    Unit{"_kg_per_m", "kg/m", "kg/m"},
    Unit{"_j_per_m", "J/m", "J/m"},
    Unit{"_n_per_m", "N/m", "N/m"},
    Unit{"_percent", "%", "%"},
    Unit{"_kg_m3", "kg/m3", "kg/m³"},
    Unit{"_pa_sn", "Pa s^N", "Pa s^N"},
    Unit{"_per_s", "1/s", "1/s"},
    Unit{"_pa_s", "Pa s", "Pa s"},
    Unit{"_m2_s", "m2/s", "m²/s"},
    Unit{"_m_s2", "m/s2", "m/s²"},
    Unit{"_m_s", "m/s", "m/s"},
    Unit{"_1_s", "1/s", "1/s"},
    Unit{"_deg", "deg", "°"},
    Unit{"_rad", "rad", "rad"},
    Unit{"_mm", "mm", "mm"},
    Unit{"_pa", "Pa", "Pa"},
    Unit{"_m2", "m2", "m²"},
    Unit{"_m3", "m3", "m³"},
    Unit{"_m", "m", "m"},
    Unit{"_s", "s", "s"},
};

constexpr bool longest_first() {
  for (std::size_t i = 1; i < units.size(); ++i) {
    if (units[i - 1].suffix.size() < units[i].suffix.size()) return false;
  }
  return true;
}
static_assert(longest_first(), "the first suffix that fits must be the longest");

}  // namespace

Unit unit_of(std::string_view key) {
  for (const Unit& unit : units) {
    if (key.size() > unit.suffix.size() && key.ends_with(unit.suffix)) return unit;
  }
  return {};
}

std::string_view without_unit(std::string_view key) {
  return key.substr(0, key.size() - unit_of(key).suffix.size());
}

}  // namespace parapet::math
