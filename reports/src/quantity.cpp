#include "quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace parapet::reports {
namespace {

// Longer suffixes first: "_m_s" ends in "_s" too.
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> units{{
    {"_n_m_per_m", "N m/m"},
    {"_nm_per_m", "N m/m"},
    {"_m3_per_m", "m³/m"},
    {"_n_per_m", "N/m"},
    {"_j_per_m", "J/m"},
    {"_kg_per_m", "kg/m"},
    {"_kg_m3", "kg/m³"},
    {"_pa_s", "Pa s"},
    {"_m2_s", "m²/s"},
    {"_m_s2", "m/s²"},
    {"_m_s", "m/s"},
    {"_1_s", "1/s"},
    {"_per_s", "1/s"},
    {"_percent", "%"},
    {"_deg", "°"},
    {"_rad", "rad"},
    {"_mm", "mm"},
    {"_pa", "Pa"},
    {"_m2", "m²"},
    {"_m3", "m³"},
    {"_m", "m"},
    {"_s", "s"},
}};

}  // namespace

Quantity quantity(const std::string& key) {
  Quantity result{key, "-"};
  for (const auto& [suffix, unit] : units) {
    if (key.size() > suffix.size() && key.ends_with(suffix)) {
      result = {key.substr(0, key.size() - suffix.size()), std::string(unit)};
      break;
    }
  }
  std::ranges::replace(result.words, '_', ' ');
  return result;
}

std::string bracketed(const std::string& key) {
  const Quantity parts = quantity(key);
  return parts.unit == "-" ? std::string() : fmt::format(" [{}]", parts.unit);
}

std::string quantity_label(const std::string& key) {
  return quantity(key).words + bracketed(key);
}

std::string number_text(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "-";
  const double size = std::abs(*value);
  if (size >= 1000.0 && size < 1e7) return fmt::format("{:.0f}", *value);
  return fmt::format("{:.4g}", *value);
}

std::string with_unit(const std::optional<double>& value, const std::string& key) {
  const std::string unit = quantity(key).unit;
  const std::string number = number_text(value);
  if (unit == "-" || number == "-") return number;
  return fmt::format("{}{}{}", number, unit == "°" ? "" : " ", unit);
}

}  // namespace parapet::reports
