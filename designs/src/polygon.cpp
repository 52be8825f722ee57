#include "polygon.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::designs {
namespace {

using solver::Vec2;

constexpr double touching = 1e-9;  // [m]: nearer than this is contact, not overlap

Vec2 next(const Polygon& polygon, std::size_t i) {
  return polygon[(i + 1) % polygon.size()];
}

/// Whether two sides cross at a point inside both.
bool cross_properly(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  const double ab = touching * norm(b - a), cd = touching * norm(d - c);
  const auto opposite = [](double p, double q, double eps) {
    return (p > eps && q < -eps) || (p < -eps && q > eps);
  };
  return opposite(c_side, d_side, ab) && opposite(a_side, b_side, cd);
}

double distance_to_side(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double length2 = dot(ab, ab);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + t * ab));
}

bool strictly_inside(Vec2 p, const Polygon& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = next(polygon, i);
    if (distance_to_side(p, a, b) < touching) return false;
    if ((a.z > p.z) != (b.z > p.z) && p.x < a.x + (p.z - a.z) / (b.z - a.z) * (b.x - a.x)) {
      inside = !inside;
    }
  }
  return inside;
}

/// Corners and middles of sides: two equal plates, one shifted along the other, cross nowhere.
bool has_point_inside(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (strictly_inside(a[i], b) || strictly_inside(0.5 * (a[i] + next(a, i)), b)) return true;
  }
  return false;
}

}  // namespace

double signed_area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], next(polygon, i));
  return 0.5 * twice;
}

bool is_simple(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = i + 1; j < polygon.size(); ++j) {
      if (cross_properly(polygon[i], next(polygon, i), polygon[j], next(polygon, j))) return false;
    }
  }
  return true;
}

bool overlap(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (cross_properly(a[i], next(a, i), b[j], next(b, j))) return true;
    }
  }
  return has_point_inside(a, b) || has_point_inside(b, a);
}

}  // namespace parapet::designs
