#include "parapet/flow/geometry.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/solver/numerics.hpp"

namespace parapet::solver {

Vec2 stem_direction(const Scene& scene, const Barrier& barrier) {
  const double angle = scene.slope + barrier.stem_lean;
  return {-std::sin(angle), std::cos(angle)};
}

Vec2 deflector_direction(const Scene& scene, const Deflector& deflector) {
  const double angle = deflector.angle - scene.slope;
  return {-std::cos(angle), std::sin(angle)};
}

std::vector<Vec2> barrier_outline(const Scene& scene, const Barrier& barrier) {
  const Vec2 stem = stem_direction(scene, barrier);
  const Vec2 downstream{stem.z, -stem.x};  // normal of the stem
  const double t = barrier.thickness;
  const Vec2 foot{barrier.foot_x, 0.0};
  const Vec2 crest = foot + barrier.height * stem;
  // the downstream face meets the bed where its height is zero
  const Vec2 offset = t * downstream;
  const Vec2 back_foot = foot + offset - (offset.z / stem.z) * stem;
  if (!barrier.deflector) return {foot, crest, crest + offset, back_foot};
  const Vec2 plate = deflector_direction(scene, *barrier.deflector);
  const Vec2 upper{plate.z, -plate.x};  // normal of the plate's upper face
  const Vec2 tip = crest + barrier.deflector->length * plate;
  // mitre: both outer faces keep the thickness
  const Vec2 joint = crest + (t / (1.0 + dot(downstream, upper))) * (downstream + upper);
  return {foot, crest, tip, tip + t * upper, joint, back_foot};
}

double drop_to_gauge(const Scene& scene) {
  const double gauge = scene.barriers.empty() ? scene.monitor_x : scene.barriers.front().foot_x;
  const double slide = std::max(0.0, gauge * std::sin(scene.slope));
  return slide + scene.reservoir_height * std::cos(scene.slope);
}

double usual_sound_speed(const Scene& scene) {
  constexpr double of_free_fall = 0.971;
  return sound_over_flow * of_free_fall * std::sqrt(2.0 * scene.gravity * drop_to_gauge(scene));
}

Face make_face(Vec2 a, Vec2 b, int body, int barrier) {
  Face face;
  face.a = a;
  face.b = b;
  face.length = norm(b - a);
  face.tangent = (1.0 / face.length) * (b - a);
  face.normal = {-face.tangent.z, face.tangent.x};
  face.body = body;
  face.barrier = barrier;
  face.points_to = face.length;
  return face;
}

void add_outline(Solids& solids, const std::vector<Vec2>& outline, int barrier, bool on_bed) {
  const int body = static_cast<int>(solids.bodies.size());
  const std::size_t n = outline.size();
  solids.bodies.push_back({outline});
  const std::size_t first = solids.faces.size();
  const std::size_t edges = on_bed ? n - 1 : n;
  for (std::size_t k = 0; k < edges; ++k) {
    const Vec2 a = outline[k], b = outline[(k + 1) % n];
    if (norm(b - a) > 1e-9) solids.faces.push_back(make_face(a, b, body, barrier));
  }
  const std::size_t count = solids.faces.size() - first;
  for (std::size_t k = 0; k < count; ++k) {
    Face& face = solids.faces[first + k];
    if (on_bed && k + 1 == count) break;  // the ends keep their default: on into the bed
    Face& next = solids.faces[first + (k + 1) % count];
    // clockwise outline: a left turn is a corner in which fluid sits between the two faces
    const bool pocket = cross(face.tangent, next.tangent) > 0.0;
    face.reaches_past_b = next.reaches_past_a = pocket;
  }
}

std::optional<double> crossing(const Face& face, Vec2 p, Vec2 q) {
  const double from = dot(p - face.a, face.normal);
  const double to = dot(q - face.a, face.normal);
  if (!(from > 0.0 && to <= 0.0)) return std::nullopt;
  const double t = from / (from - to);
  const double s = dot(p + t * (q - p) - face.a, face.tangent);
  constexpr double slack = 1e-9;  // [m] so that nothing slips between two faces at a corner
  if (s < -slack || s > face.length + slack) return std::nullopt;
  return t;
}

int first_crossed(std::span<const Face> faces, std::span<const int> candidates, Vec2 p, Vec2 q) {
  int first = -1;
  double earliest = 2.0;
  for (const int index : candidates) {
    const auto t = crossing(faces[static_cast<std::size_t>(index)], p, q);
    // a path through a corner meets two faces at once: the first in the list counts, for every copy
    if (t && *t < earliest - 1e-12) {
      earliest = *t;
      first = index;
    }
  }
  return first;
}

bool hidden(std::span<const Face> faces, std::span<const int> candidates, Vec2 p, Vec2 q,
            double corner) {
  const Face *entered = nullptr, *left = nullptr;
  Vec2 in, out;  // where
  for (const int index : candidates) {
    const Face& face = faces[static_cast<std::size_t>(index)];
    const bool p_outside = dot(p - face.a, face.normal) > 0.0;
    const bool q_outside = dot(q - face.a, face.normal) > 0.0;
    if (p_outside == q_outside) continue;  // most pairs
    const auto t = p_outside ? crossing(face, p, q) : crossing(face, q, p);
    if (!t) continue;
    if (corner <= 0.0 || (p_outside ? entered : left) != nullptr) return true;
    if (p_outside) {
      entered = &face;
      in = p + *t * (q - p);
    } else {
      left = &face;
      out = q + *t * (p - q);
    }
  }
  if (!entered && !left) return false;
  if (!entered || !left || entered->body != left->body) return true;
  const auto same = [](Vec2 a, Vec2 b) { return a.x == b.x && a.z == b.z; };
  const bool at_end = same(entered->b, left->a);
  if (!at_end && !same(entered->a, left->b)) return true;
  const Vec2 shared = at_end ? entered->b : entered->a;
  return norm(in - shared) > corner || norm(out - shared) > corner;
}

bool inside_polygon(const std::vector<Vec2>& outline, Vec2 p) {
  bool inside = false;
  for (std::size_t k = 0, previous = outline.size() - 1; k < outline.size(); previous = k++) {
    const Vec2 a = outline[k], b = outline[previous];
    if ((a.z > p.z) != (b.z > p.z) && p.x < (b.x - a.x) * (p.z - a.z) / (b.z - a.z) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

double distance_to_segment(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 ab = b - a;
  const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
  return norm(p - (a + t * ab));
}

}  // namespace parapet::solver
