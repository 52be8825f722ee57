/// Wall (dummy) points of every face, laid out in the face's own frame.
#pragma once

#include <span>
#include <vector>

#include "parapet/flow/flow_arrays.hpp"
#include "parapet/flow/geometry.hpp"

namespace parapet::solver {

/// One wall point; its quantities are the lines of PARAPET_WALL_FIELDS in particle_fields.hpp.
struct WallPoint {
#define PARAPET_MEMBER(name, ...) double name;
  PARAPET_WALL_FIELDS(PARAPET_MEMBER)
#undef PARAPET_MEMBER
};

/// All wall points. A point belongs to one face and is seen only by fluid whose line of sight
/// enters the solid through that face. Thin plates therefore carry a set for either side, each as
/// deep as the kernel needs, and neither side ever feels the other.
///
/// Arrays (`x`, `z`, `volume` and so on, as in WallPoint) are [n + 1]: the last entry is the ghost
/// that pads neighbour rows.
struct WallPoints {
#define PARAPET_ARRAY(name, ...) std::vector<double> name;
#define PARAPET_RECORDS(name, Type, ...) std::vector<Type> name;
  PARAPET_WALL_FIELDS(PARAPET_ARRAY)
  /// Packed for the passes, see WallView.
  struct Records {
    PARAPET_WALL_RECORDS(PARAPET_RECORDS)
  } records;
#undef PARAPET_ARRAY
#undef PARAPET_RECORDS
  std::vector<double> pressure;                ///< of the fluid that a point sees [Pa]
  std::vector<double> mirrored_u, mirrored_w;  ///< see WallView [m/s]
  std::vector<int> owner;                      ///< [n] the face that a point belongs to

  WallPoints() : WallPoints(std::span<const WallPoint>{}, {}) {}
  /// Points and the face of each; both of the same length.
  WallPoints(std::span<const WallPoint> points, std::vector<int> owners);
  /// Number of points, without the ghost.
  std::size_t size() const {
    return owner.size();
  }
  /// For the passes, until the next change of the arrays.
  WallView view();
};

/// Rows of points every `spacing` along each face, `reach` deep (rounded up to whole layers) [m].
/// The last point of a row stands for the fraction of a spacing that is left, so that the layout
/// varies continuously with the face's length.
WallPoints lay_out_walls(const Solids& solids, double spacing, double reach);

}  // namespace parapet::solver
