#include "sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "parapet/designs/error.hpp"

namespace parapet::reports {
namespace {

constexpr std::size_t first_column = 14, columns_each = 26, most_barriers = 3;

/// Writes over a line of spaces; none of the texts meets another.
void put(std::string& line, std::size_t column, const std::string& text) {
  if (line.size() < column) line.resize(column, ' ');
  line = line.substr(0, column) + text;
}

std::string millimetres(double metres) {
  return fmt::format("{:.0f} mm", 1000.0 * metres);
}

}  // namespace

std::vector<std::string> sketch_of(const designs::StudySpec& study, const designs::Design& design) {
  try {
    const solver::Scene scene = designs::design_case(study, design).scene;
    if (scene.barriers.empty() || scene.barriers.size() > most_barriers) return {};
    std::string plate, stem = "  flow -->", bed, feet;
    for (std::size_t k = 0; k < scene.barriers.size(); ++k) {
      const solver::Barrier& barrier = scene.barriers[k];
      const std::size_t column = first_column + k * columns_each;
      if (barrier.deflector) {
        put(plate, column - 1, "\\ plate " + millimetres(barrier.deflector->length));
      }
      put(stem, column, "| stem " + millimetres(barrier.height));
      put(feet, column, fmt::format("{:.3g} m", barrier.foot_x));
    }
    bed.assign(first_column + scene.barriers.size() * columns_each, '=');
    bed += fmt::format(" bed falls {:.3g} deg", scene.slope * 180.0 / std::numbers::pi);
    return {plate, stem, bed, feet};
  } catch (const designs::InputError&) {
    return {};
  }
}

}  // namespace parapet::reports
