// Eight wall points that see fluid, and the slots of their fluid neighbours.
#pragma once

#include "pair_geometry.hpp"

namespace parapet::solver {

struct WallGroup : Group {
  const std::int32_t *points, *fluid, *fluid_end;
  WallGroup(const RowView& rows, int begin, int end) : Group(begin, end) {
    points = rows.active_wall + begin;
    fluid = rows.wall_point_index + rows.wall_point_begin[begin / lanes];
    fluid_end = rows.wall_point_index + rows.wall_point_begin[begin / lanes + 1];
  }
};

}  // namespace parapet::solver
