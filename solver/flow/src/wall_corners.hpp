// Which faces meet in a corner, and whose grid of wall points fills the solid there.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "parapet/flow/geometry.hpp"

namespace parapet::solver {

// A face that another one meets at one of its ends.
struct MetFace {
  int face;
  bool pocket;  // fluid in an angle of less than 180 degrees
  bool leads;   // its grid fills what lies behind both
};

// [0]: at a, [1]: at b.
using FaceEnds = std::array<std::optional<MetFace>, 2>;

// For every face. Of two that meet the unbounded one leads, then the shorter one.
std::vector<FaceEnds> faces_met(const Solids& solids);

// Every face after those that lead it.
std::vector<int> leading_first(const Solids& solids);

// A convex polygon, counter-clockwise; may be empty.
using Convex = std::vector<Vec2>;

Convex rectangle(const Face& face, double from, double to, double shallow, double deep);

// The part of a polygon to which a direction points from a line.
Convex cut(const Convex& polygon, Vec2 on_line, Vec2 direction);

// A polygon without what lies in another one, as convex pieces.
std::vector<Convex> without(const Convex& polygon, const Convex& other);

// What a wall point stands for.
struct Patch {
  Vec2 center;
  double area;   // [m2]
  double depth;  // of the centre behind the face that the point belongs to [m]
};

// Of several polygons together; the area may be zero.
Patch patch_of(const std::vector<Convex>& polygons, const Face& face);

}  // namespace parapet::solver
