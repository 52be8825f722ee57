#include "parapet/flow/walls.hpp"

namespace parapet::solver {

void add_wall(FlowSetup& setup, Vec2 a, Vec2 b) {
  const int body = static_cast<int>(setup.solids.bodies.size());
  setup.solids.bodies.push_back({});
  setup.solids.faces.push_back(make_face(a, b, body, -1));
}

void add_periodic_wall(FlowSetup& setup, double length, double z, bool upwards, Vec2 velocity) {
  const double margin = 20.0 * setup.numerics.spacing;
  const Vec2 left{-margin, z}, right{length + margin, z};
  add_wall(setup, upwards ? left : right, upwards ? right : left);
  Face& face = setup.solids.faces.back();
  face.points_from = margin;
  face.points_to = margin + length;
  face.velocity = velocity;
}

void measure_all_walls(FlowSetup& setup) {
  setup.n_barriers = 1;
  for (Face& face : setup.solids.faces) face.barrier = 0;
}

}  // namespace parapet::solver
