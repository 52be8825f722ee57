// Wall points: in the plate's own frame, complete behind every face, continuous in its length.
#include "parapet/flow/wall_layout.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace parapet::solver {
namespace {

double total(const WallPoints& points) {
  return std::accumulate(points.volume.begin(), points.volume.end(), 0.0);
}

Solids plate(double length, double thickness) {
  Solids solids;
  add_outline(solids, {{0.0, 0.0}, {0.0, length}, {thickness, length}, {thickness, 0.0}}, 0, false);
  return solids;
}

TEST(WallLayout, VolumeGrowsContinuouslyWithThePlate) {
  // Growing a plate by 1 % of a spacing may not change the layout by more than a few per cent of
  // one particle: nothing jumps from lattice to lattice.
  const double dx = 0.005;
  double before = total(lay_out_walls(plate(0.1, 0.03), dx, 2.66 * dx));
  for (double length = 0.1; length < 0.12; length += 0.01 * dx) {
    const double now = total(lay_out_walls(plate(length, 0.03), dx, 2.66 * dx));
    EXPECT_NEAR(now, before, 0.15 * dx * dx) << "length " << length;
    before = now;
  }
}

TEST(WallLayout, TurningAPlateTurnsItsPoints) {
  // the layout is rigid: distances between points do not depend on the plate's direction
  const double dx = 0.005, angle = 0.6;
  const auto turn = [&](Vec2 v) {
    return Vec2{v.x * std::cos(angle) - v.z * std::sin(angle),
                v.x * std::sin(angle) + v.z * std::cos(angle)};
  };
  Solids straight = plate(0.0973, 0.015), turned;
  std::vector<Vec2> outline;
  for (const Vec2 v : straight.bodies[0].outline) outline.push_back(turn(v));
  add_outline(turned, outline, 0, false);
  const WallPoints a = lay_out_walls(straight, dx, 2.66 * dx);
  const WallPoints b = lay_out_walls(turned, dx, 2.66 * dx);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vec2 expected = turn({a.x[k], a.z[k]});
    EXPECT_NEAR(b.x[k], expected.x, 1e-12);
    EXPECT_NEAR(b.z[k], expected.z, 1e-12);
  }
}

TEST(WallLayout, ThinPlatesCarryFullDepthForEitherSide) {
  // 4 mm plate at 10 mm spacing: three layers behind each long face all the same
  const WallPoints points = lay_out_walls(plate(0.1, 0.004), 0.01, 0.0266);
  int first_face = 0;
  for (const int owner : points.owner) first_face += owner == 0;
  EXPECT_EQ(first_face, 3 * 10);
}

}  // namespace
}  // namespace parapet::solver
