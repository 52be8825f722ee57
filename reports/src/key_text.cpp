#include "key_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "parapet/math/units.hpp"

namespace parapet::reports {

std::string key_words(const std::string& key) {
  std::string words(math::without_unit(key));
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string bracketed_unit(const std::string& key) {
  const std::string_view unit = math::unit_of(key).typographic;
  return unit.empty() ? std::string() : fmt::format(" [{}]", unit);
}

std::string key_label(const std::string& key) {
  return key_words(key) + bracketed_unit(key);
}

std::string number_text(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "-";
  const double size = std::abs(*value);
  if (size >= 1000.0 && size < 1e7) return fmt::format("{:.0f}", *value);
  return fmt::format("{:.4g}", *value);
}

std::string with_unit(const std::optional<double>& value, const std::string& key) {
  const std::string_view unit = math::unit_of(key).typographic;
  const std::string number = number_text(value);
  if (unit.empty() || number == "-") return number;
  return fmt::format("{}{}{}", number, unit == "°" ? "" : " ", unit);
}

}  // namespace parapet::reports
