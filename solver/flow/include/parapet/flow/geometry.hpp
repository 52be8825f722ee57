/// Solid surfaces as directed faces, and which of them a segment meets first.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// A straight piece of surface from a to b. Its normal n points into the fluid.
struct Face {
  Vec2 a, b;             ///< [m]
  Vec2 tangent, normal;  ///< unit vectors
  double length = 0.0;   ///< [m]
  int body = 0;          ///< index of the solid it belongs to
  int barrier = -1;      ///< load cell that feels it, or -1; in a channel the barrier's index
  Vec2 velocity;         ///< of the wall [m/s]
  /// The wall goes on behind a neighbouring face (the fluid's corner is less than 180 deg).
  bool reaches_past_a = true, reaches_past_b = true;
  /// Wall points are laid out over [points_from, points_to] of [0, length] [m].
  double points_from = 0.0, points_to = 0.0;
};

/// A solid body: the polygon that its faces enclose, clockwise so that normals point outwards.
/// Empty for an unbounded wall.
struct Body {
  std::vector<Vec2> outline;  ///< [n_corners] [m]
};

/// All solids of a flow.
struct Solids {
  std::vector<Face> faces;
  std::vector<Body> bodies;
};

/// A face with its derived members; the normal is the left-hand side of a -> b.
Face make_face(Vec2 a, Vec2 b, int body, int barrier);

/// Adds a clockwise outline. At corners where the fluid's angle is less than 180 degrees the wall
/// goes on behind the neighbouring face. A body that stands on the bed has no face along its last
/// edge, and its outer faces go on into the bed.
void add_outline(Solids& solids, const std::vector<Vec2>& outline, int barrier, bool on_bed);

/// Parameter in [0, 1] at which p -> q passes through the face from its fluid side, or none.
std::optional<double> crossing(const Face& face, Vec2 p, Vec2 q);

/// Index into faces of the first of the candidates that p -> q passes through from its fluid side;
/// -1 for none.
int first_crossed(std::span<const Face> faces, std::span<const int> candidates, Vec2 p, Vec2 q);

/// Whether a solid stands between two places in the fluid. A corner of a body hides nothing close
/// behind it: where the line enters through one face, leaves through the next one of the outline
/// and is never farther than `corner` [m] from the corner that they share, the places see each
/// other. Else the support of a particle beside a corner has a hole there, with neither fluid nor
/// wall. The same for p and q exchanged, to the bit.
bool hidden(std::span<const Face> faces, std::span<const int> candidates, Vec2 p, Vec2 q,
            double corner);

/// Whether p lies inside a closed polygon, whichever way round.
bool inside_polygon(const std::vector<Vec2>& outline, Vec2 p);

/// From p to the nearest point between a and b [m].
double distance_to_segment(Vec2 a, Vec2 b, Vec2 p);

}  // namespace parapet::solver
