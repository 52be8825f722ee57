/// Plane polygons: just what it takes to see that two bodies overlap.
#pragma once

#include <vector>

#include "parapet/solver/vec2.hpp"

namespace parapet::designs {

/// Corners in order, closed by the last side [m].
using Polygon = std::vector<solver::Vec2>;

/// Positive when the corners run counter-clockwise [m2].
double signed_area(const Polygon& polygon);

/// Whether no two sides cross.
bool is_simple(const Polygon& polygon);

/// Whether the interiors meet; touching sides do not count.
bool overlap(const Polygon& a, const Polygon& b);

}  // namespace parapet::designs
