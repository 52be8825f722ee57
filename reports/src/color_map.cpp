#include "parapet/reports/color_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace parapet::reports {
namespace {

// Twenty equidistant colours of the scale; between them linear interpolation cannot be told apart.
constexpr std::array<std::uint32_t, 20> viridis_table{
    0x440154, 0x481568, 0x482677, 0x453781, 0x3F4788, 0x39558C, 0x32648E,
    0x2D718E, 0x287D8E, 0x238A8D, 0x1F968B, 0x20A386, 0x29AF7F, 0x3CBC75,
    0x56C667, 0x74D055, 0x94D840, 0xB8DE29, 0xDCE318, 0xFDE725};

constexpr std::array<std::uint32_t, 7> okabe_ito{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                                 0xE69F00, 0x56B4E9, 0x333333};

constexpr Color from_hex(std::uint32_t hex) {
  return {static_cast<double>((hex >> 16) & 0xFFU) / 255.0,
          static_cast<double>((hex >> 8) & 0xFFU) / 255.0, static_cast<double>(hex & 0xFFU) / 255.0,
          1.0};
}

}  // namespace

Color viridis(double share) {
  constexpr double last = static_cast<double>(viridis_table.size() - 1);
  const double place = std::clamp(share, 0.0, 1.0) * last;
  const auto k = static_cast<std::size_t>(std::min(std::floor(place), last - 1.0));
  const double t = place - static_cast<double>(k);
  const Color a = from_hex(viridis_table[k]);
  const Color b = from_hex(viridis_table[k + 1]);
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue), 1.0};
}

Color palette_color(int index) {
  const int n = static_cast<int>(okabe_ito.size());
  return from_hex(okabe_ito[static_cast<std::size_t>(((index % n) + n) % n)]);
}

}  // namespace parapet::reports
