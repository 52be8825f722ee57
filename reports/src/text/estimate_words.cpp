#include "estimate_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "key_text.hpp"
#include "parapet/math/units.hpp"

namespace parapet::reports {
namespace {

/// Places behind the point that show two digits of an uncertainty.
int places_of(double uncertainty) {
  if (!(uncertainty > 0.0)) return 0;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(uncertainty))), 0, 12);
}

std::string with_key(const std::string& text, const std::string& key) {
  const std::string_view unit = key.empty() ? "" : math::unit_of(key).typographic;
  if (unit.empty()) return text;
  return fmt::format("{}{}{}", text, unit == "°" ? "" : " ", unit);
}

}  // namespace

std::string estimate_words(const study::Expectation& expectation, const std::string& key) {
  if (!expectation.estimate) return expectation.absent > 0 ? "none in any run" : "-";
  const study::RepeatEstimate& estimate = *expectation.estimate;
  const auto lower = estimate.lower_95(), upper = estimate.upper_95();
  if (!lower || !upper) {
    return with_key(number_text(estimate.mean), key) + " (one run: its uncertainty is not known)";
  }
  const double below = estimate.mean - *lower, above = *upper - estimate.mean;
  const double wide = std::max(below, above);
  if (expectation.exact || !(wide > 0.0)) return with_key(number_text(estimate.mean), key);
  const int places = places_of(wide);
  const auto number = [&](double value) {
    const bool at_end = value == estimate.least || value == estimate.greatest;
    return at_end ? number_text(value) : fmt::format("{:.{}f}", value, places);
  };
  if (std::abs(below - above) <= 0.05 * wide) {
    return with_key(fmt::format("{} ± {}", number(estimate.mean), number(wide)), key);
  }
  return with_key(
      fmt::format("{} ({} to {})", number(estimate.mean), number(*lower), number(*upper)), key);
}

std::string probability_words(const std::optional<double>& probability) {
  if (!probability) return "not known";
  if (*probability > 0.999) return "more than 99.9 %";
  if (*probability < 0.001) return "less than 0.1 %";
  return fmt::format("{:.{}f} %", 100.0 * *probability, *probability > 0.99 ? 1 : 0);
}

}  // namespace parapet::reports
