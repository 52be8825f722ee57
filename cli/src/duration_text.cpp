#include "duration_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parapet::cli {

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  const long whole = std::lround(std::max(0.0, seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace parapet::cli
