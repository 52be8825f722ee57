/// Which walls are near a place: cells along the walls, laid out once.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "parapet/flow/geometry.hpp"
#include "parapet/flow/wall_layout.hpp"

namespace parapet::solver {

/// Square cells that hold wall points or are near a face. Memory grows with the length of the walls
/// and not with the area that they enclose.
class WallCells {
 public:
  /// @param size of a cell [m]
  WallCells(const Solids& solids, const WallPoints& walls, double size);

  int column(double x) const;  ///< below 0 or above the last one outside
  int row(double z) const;     ///< likewise
  /// The wall points in the cells [z_from, z_to] of a column, from the lowest cell up.
  std::span<const std::int32_t> points(int column, int z_from, int z_to) const;
  /// Faces near a place: a superset of those within one cell.
  const std::vector<int>& faces_near(Vec2 p) const;
  /// Whether a particle from here may reach a wall before it has moved half a cell.
  bool may_be_reached_from(Vec2 p) const;

 private:
  struct Place {
    int ix, iz;
    auto operator<=>(const Place&) const = default;
  };
  struct Near {
    Place place;
    bool in_reach;  // within one cell, and not only within one and a half
  };

  std::vector<std::vector<Near>> cells_near(const Solids& solids) const;
  void lay_out(const std::vector<Place>& points, const std::vector<std::vector<Near>>& near);
  std::int32_t first_cell(int ix, int iz) const;  // the first of the column from row iz on
  std::int32_t cell(int ix, int iz) const;        // -1 where there is none

  double x0_ = 0.0, z0_ = 0.0, size_;
  double columns_ = 0.0, rows_ = 0.0;       // whole numbers
  std::vector<std::int32_t> column_start_;  // [columns + 1] first cell of each column
  std::vector<std::int32_t> row_of_;        // [cells] ascending in each column
  std::vector<std::int32_t> start_;         // [cells + 1] into sorted_
  std::vector<std::int32_t> sorted_;        // [points] by cell
  std::vector<char> near_wall_;             // [cells]
  std::vector<std::vector<int>> faces_;     // [cells]
  std::vector<int> no_faces_;
};

}  // namespace parapet::solver
