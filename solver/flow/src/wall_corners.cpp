#include "wall_corners.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

bool unbounded(const Solids& solids, const Face& face) {
  return solids.bodies[at(face.body)].outline.empty();
}

bool same(Vec2 a, Vec2 b) {
  return norm(a - b) < 1e-9;
}

bool lies_on(const Face& face, Vec2 p) {
  const double along = dot(p - face.a, face.tangent);
  return std::abs(dot(p - face.a, face.normal)) < 1e-9 && along > -1e-9 &&
         along < face.length + 1e-9;
}

// An end of a face on an unbounded wall stands on it, in whatever corner of its own outline.
std::optional<MetFace> met_at(const Solids& solids, std::size_t f, bool at_b) {
  const Face& face = solids.faces[f];
  const Vec2 end = at_b ? face.b : face.a;
  std::optional<MetFace> met;
  for (std::size_t g = 0; g < solids.faces.size(); ++g) {
    const Face& other = solids.faces[g];
    if (g == f || other.points_from != 0.0 || other.points_to != other.length) continue;
    if (unbounded(solids, other)) {
      if (!lies_on(other, end)) continue;
      const bool leads = !unbounded(solids, face) || g < f;
      return MetFace{static_cast<int>(g), true, leads};
    }
    if (met || other.body != face.body || !same(end, at_b ? other.a : other.b)) continue;
    const double turn =
        at_b ? cross(face.tangent, other.tangent) : cross(other.tangent, face.tangent);
    const bool leads = other.length != face.length ? other.length < face.length : g < f;
    met = MetFace{static_cast<int>(g), turn > 0.0, leads};
  }
  return met;
}

}  // namespace

std::vector<FaceEnds> faces_met(const Solids& solids) {
  std::vector<FaceEnds> met(solids.faces.size());
  for (std::size_t f = 0; f < met.size(); ++f) {
    const Face& face = solids.faces[f];
    if (face.points_from != 0.0 || face.points_to != face.length) continue;
    met[f] = {met_at(solids, f, false), met_at(solids, f, true)};
  }
  return met;
}

std::vector<int> leading_first(const Solids& solids) {
  std::vector<int> order(solids.faces.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rank = [&](int f) {
    const Face& face = solids.faces[at(f)];
    return std::pair{!unbounded(solids, face), unbounded(solids, face) ? 0.0 : face.length};
  };
  std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return rank(f) < rank(g); });
  return order;
}

Convex rectangle(const Face& face, double from, double to, double shallow, double deep) {
  const auto corner = [&](double along, double depth) {
    return face.a + along * face.tangent - depth * face.normal;
  };
  return {corner(from, deep), corner(to, deep), corner(to, shallow), corner(from, shallow)};
}

Convex cut(const Convex& polygon, Vec2 on_line, Vec2 direction) {
  Convex kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    const double from = dot(a - on_line, direction), to = dot(b - on_line, direction);
    if (from >= 0.0) kept.push_back(a);
    if ((from >= 0.0) != (to >= 0.0)) kept.push_back(a + (from / (from - to)) * (b - a));
  }
  return kept;
}

std::vector<Convex> without(const Convex& polygon, const Convex& other) {
  std::vector<Convex> pieces;
  Convex rest = polygon;
  for (std::size_t k = 0; k < other.size() && !rest.empty(); ++k) {
    const Vec2 a = other[k], along = other[(k + 1) % other.size()] - a;
    const Vec2 inwards{-along.z, along.x};
    Convex outside = cut(rest, a, -1.0 * inwards);
    if (!outside.empty()) pieces.push_back(std::move(outside));
    rest = cut(rest, a, inwards);
  }
  return pieces;
}

Patch patch_of(const std::vector<Convex>& polygons, const Face& face) {
  Patch patch{{}, 0.0, 0.0};
  Vec2 moment, origin;
  for (const Convex& polygon : polygons) {
    if (polygon.empty()) continue;
    if (patch.area == 0.0) origin = polygon[0];
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      const Vec2 a = polygon[0] - origin, b = polygon[k] - origin, c = polygon[k + 1] - origin;
      const double triangle = 0.5 * cross(b - a, c - a);
      patch.area += triangle;
      moment = moment + (triangle / 3.0) * (a + b + c);
    }
  }
  if (patch.area <= 0.0) return patch;
  patch.center = origin + (1.0 / patch.area) * moment;
  patch.depth = dot(face.a - patch.center, face.normal);
  return patch;
}

}  // namespace parapet::solver
