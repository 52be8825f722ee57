/// Plane vectors in channel axes: x runs down the channel bed, z is normal to it [m].
#pragma once

#include <cmath>

namespace parapet::solver {

/// A point or a direction.
struct Vec2 {
  double x = 0.0;
  double z = 0.0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.z + b.z}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.z - b.z}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.z}; }
  friend constexpr Vec2 operator*(Vec2 a, double s) { return {s * a.x, s * a.z}; }
  friend constexpr bool operator==(Vec2 a, Vec2 b) = default;
};

/// The scalar product.
constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.z * b.z;
}

/// The out-of-plane component of a x b; positive when b lies counter-clockwise of a.
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.z - a.z * b.x;
}

/// The length.
inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}

}  // namespace parapet::solver
