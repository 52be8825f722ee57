// Wall points: in the plate's own frame, complete behind every face, continuous in its length.
#include "parapet/flow/wall_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "parapet/flow/kernel.hpp"

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
  // 4 mm plate at 10 mm spacing: 30 mm behind each long face all the same
  const WallPoints points = lay_out_walls(plate(0.1, 0.004), 0.01, 0.0266);
  double first_face = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    first_face += points.owner[k] == 0 ? points.volume[k] : 0.0;
  }
  EXPECT_NEAR(first_face, 0.03 * 0.1, 1e-12);
}

// A bed with a barrier on it, at a place that does not fit the bed's points.
Solids barrier_on_bed(double thickness, double lean, bool deflector) {
  Scene scene;
  scene.slope = 0.0;
  Barrier barrier;
  barrier.foot_x = 0.2037;
  barrier.thickness = thickness;
  barrier.stem_lean = lean;
  if (deflector) barrier.deflector = Deflector{0.6, 0.065};
  Solids solids;
  solids.bodies.push_back({});
  solids.faces.push_back(make_face({-0.1, 0.0}, {0.5, 0.0}, 0, -1));
  add_outline(solids, barrier_outline(scene, barrier), 0, true);
  return solids;
}

// Sum of the kernel and h times its gradient over the wall points that a place sees.
struct Sums {
  double w = 0.0;
  Vec2 gradient;
};

Sums seen_from(Vec2 p, const Solids& solids, const WallPoints& points, double dx) {
  const double h = 1.33 * dx;
  const Kernel kernel = make_kernel(h, dx);
  std::vector<int> all(solids.faces.size());
  std::iota(all.begin(), all.end(), 0);
  Sums sums;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 r = p - Vec2{points.x[k], points.z[k]};
    const double t = 1.0 - 0.5 * norm(r) / h;
    if (t <= 0.0) continue;
    if (first_crossed(solids.faces, all, p, p - r) != points.owner[k]) continue;
    sums.w += kernel.alpha * t * t * t * t * (5.0 - 4.0 * t) * points.volume[k];
    sums.gradient = sums.gradient - (h * kernel.f_scale * t * t * t * points.volume[k]) * r;
  }
  return sums;
}

// How far the sums differ from the integrals over the solid: from those with fine points.
struct Difference {
  double w = 0.0, gradient = 0.0;
  void add(Vec2 p, const Solids& solids, const WallPoints& points, const WallPoints& fine,
           double dx) {
    const Sums coarse = seen_from(p, solids, points, dx);
    const Sums exact = seen_from(p, solids, fine, dx);
    w = std::max(w, std::abs(coarse.w - exact.w));
    gradient = std::max(gradient, norm(coarse.gradient - exact.gradient));
  }
};

TEST(WallLayout, BothFacesOfACornerTogetherFillTheSolidOnce) {
  // From 0.4 spacings above a plain wall on, the sums are 2.1 % of the kernel's integral off, and
  // 2.9 % in the gradient. Around the corners of these barriers it is up to 1.9 times as much: two
  // grids meet there. When each face had a grid of its own, cut off where its points go out of
  // sight, the gradient was off by 2.9 to 6.7 times as much in all but the thickest.
  const double dx = 0.01, reach = 2.66 * dx, lowest = 0.4 * dx;
  Solids plain = barrier_on_bed(0.015, 0.0, false);
  plain.faces.resize(1);
  Difference at_wall;
  const WallPoints wall = lay_out_walls(plain, dx, reach);
  const WallPoints fine_wall = lay_out_walls(plain, dx / 8.0, reach);
  for (double x = 0.0; x < 1.0; x += 0.1) {
    for (double z = 0.4; z < 2.7; z += 0.1) {
      at_wall.add(dx * Vec2{x, z}, plain, wall, fine_wall, dx);
    }
  }
  for (const double thickness : {0.005, 0.0125, 0.015, 0.02, 0.04}) {
    for (const double lean : {0.0, 0.45}) {
      for (const bool deflector : {false, true}) {
        const Solids solids = barrier_on_bed(thickness, lean, deflector);
        const WallPoints points = lay_out_walls(solids, dx, reach);
        const WallPoints fine = lay_out_walls(solids, dx / 8.0, reach);
        const std::vector<Vec2>& outline = solids.bodies[1].outline;
        Difference at_corners;
        int tried = 0;
        for (const Vec2 corner : outline) {
          for (double x = -2.0; x <= 2.0; x += 0.4) {
            for (double z = -2.0; z <= 2.0; z += 0.4) {
              const Vec2 p = corner + dx * Vec2{x, z};
              double above = p.z;
              for (const Face& face : solids.faces) {
                above = std::min(above, distance_to_segment(face.a, face.b, p));
              }
              if (above < lowest || inside_polygon(outline, p)) continue;
              at_corners.add(p, solids, points, fine, dx);
              ++tried;
            }
          }
        }
        EXPECT_LE(at_corners.w, 2.1 * at_wall.w) << thickness << " " << lean << " " << deflector;
        EXPECT_LE(at_corners.gradient, 2.1 * at_wall.gradient)
            << thickness << " " << lean << " " << deflector;
        EXPECT_GT(tried, 100);
      }
    }
  }
}

TEST(WallLayout, WhatStandsOnTheBedMovesNoneOfItsPoints) {
  // the undisturbed flow of a study is shared by designs with barriers in different places
  const double dx = 0.01;
  Solids bare = barrier_on_bed(0.015, 0.0, false);
  const WallPoints with = lay_out_walls(bare, dx, 2.66 * dx);
  bare.faces.resize(1);
  bare.bodies.resize(1);
  const WallPoints without = lay_out_walls(bare, dx, 2.66 * dx);
  ASSERT_GT(with.size(), without.size());
  for (std::size_t k = 0; k < without.size(); ++k) {
    EXPECT_EQ(with.owner[k], 0);
    EXPECT_EQ(with.x[k], without.x[k]);
    EXPECT_EQ(with.z[k], without.z[k]);
    EXPECT_EQ(with.volume[k], without.volume[k]);
  }
}

}  // namespace
}  // namespace parapet::solver
