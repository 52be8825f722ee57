#include "bed.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::solver {

double bed_below(const Scene& scene, Vec2 place) {
  double bed = 0.0;
  for (const SolidPolygon& solid : scene.solids) {
    const std::size_t n = solid.vertices.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 a = solid.vertices[k], b = solid.vertices[(k + 1) % n];
      if ((a.x > place.x) == (b.x > place.x)) continue;
      const double z = a.z + (place.x - a.x) / (b.x - a.x) * (b.z - a.z);
      if (z <= place.z) bed = std::max(bed, z);
    }
  }
  return bed;
}

double bed_slope(const Scene& scene, double x_from, double x_to) {
  if (scene.solids.empty()) return scene.slope;
  const double top = scene.domain_height;
  const double rise = bed_below(scene, {x_to, top}) - bed_below(scene, {x_from, top});
  return scene.slope - std::atan2(rise, x_to - x_from);
}

}  // namespace parapet::solver
