// Nothing gets through a solid, however thin, pointed, crossed or doubled, and however far the
// fluid's support reaches beyond it: the path of every particle in every step meets no face from
// its fluid side. Fluid stands higher on one side, leans on the solid and spills over it, so that
// the corners are tried as well.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "parapet/flow/flow.hpp"
#include "parapet/flow/walls.hpp"

namespace parapet::solver {
namespace {

using Outlines = std::vector<std::vector<Vec2>>;

constexpr double middle = 0.2, height = 0.08;  // of the solids in a tank 0.4 m long [m]

// A plate from one place to another, clockwise.
std::vector<Vec2> plate(Vec2 from, Vec2 to, double thickness) {
  const Vec2 along = (1.0 / norm(to - from)) * (to - from);
  const Vec2 across = (0.5 * thickness) * Vec2{along.z, -along.x};  // to the right
  return {from - across, to - across, to + across, from + across};
}

struct Shape {
  const char* name;
  Outlines outlines;
};

std::vector<Shape> shapes() {
  const Vec2 foot{middle, -0.01}, top{middle, height};  // from below the bed: no gap there
  const Vec2 right{0.0001 + 1e-7, 0.0};                 // leaves 0.1 um between plates of 0.1 mm
  const double lean = height * std::tan(std::numbers::pi / 180.0);
  return {
      {"plate of 2 nm", {plate(foot, top, 2e-9)}},
      {"plate of 1 mm", {plate(foot, top, 1e-3)}},
      {"plate of 15 mm", {plate(foot, top, 0.015)}},
      {"wedge of 2 degrees", {{{middle - lean, 0.0}, top, {middle + lean, 0.0}}}},
      {"crossing plates",
       {plate({middle - 0.04, -0.01}, {middle + 0.04, height}, 1e-3),
        plate({middle + 0.04, -0.01}, {middle - 0.04, height}, 1e-3)}},
      {"doubled plate", {plate(foot, top, 0.01), plate(foot, top, 0.006)}},
      {"gap of 0.1 um", {plate(foot, top, 1e-4), plate(foot + right, top + right, 1e-4)}},
  };
}

FlowSetup tank(const Shape& shape, double spacing, bool water) {
  FlowSetup setup;
  setup.numerics.spacing = spacing;
  setup.numerics.sound_speed = 20.0;
  setup.gravity = {0.0, -9.81};
  if (water)
    setup.material = {
        .density = 1000.0, .yield_stress = 0.0, .consistency = 1e-3, .flow_index = 1.0};
  add_wall(setup, {0.0, 0.0}, {0.4, 0.0});
  add_wall(setup, {0.4, 0.0}, {0.4, 0.5});
  add_wall(setup, {0.0, 0.5}, {0.0, 0.0});
  for (const auto& outline : shape.outlines) add_outline(setup.solids, outline, -1, false);
  const auto fill = [&](double from, double to, double depth) {
    for (const InitialParticle& p :
         lattice_block(from, 0.0, to - from, depth, spacing, setup.material.density)) {
      bool clear = true;
      for (const Face& face : setup.solids.faces) {
        clear = clear && distance_to_segment(face.a, face.b, {p.x, p.z}) > 0.3 * spacing;
      }
      for (const Body& body : setup.solids.bodies) {
        clear = clear && (body.outline.empty() || !inside_polygon(body.outline, {p.x, p.z}));
      }
      if (clear) setup.particles.push_back(p);
    }
  };
  fill(0.0, middle, 0.16);
  fill(middle, 0.4, 0.06);
  return setup;
}

class TightWalls : public ::testing::TestWithParam<double> {};

TEST_P(TightWalls, NoPathLeadsThroughASolid) {
  for (const Shape& shape : shapes()) {
    for (const bool water : {false, true}) {
      SCOPED_TRACE(std::string(shape.name) + (water ? ", water" : ", debris"));
      Flow flow(tank(shape, GetParam(), water));
      const Flow& now = flow;
      const std::vector<Face>& faces = flow.setup().solids.faces;
      std::vector<int> all(faces.size());
      std::iota(all.begin(), all.end(), 0);
      std::vector<Vec2> before(static_cast<std::size_t>(now.fluid().n));
      const auto look = [&](const auto& at) {
        const Fluid& f = now.fluid();
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
          at(before[static_cast<std::size_t>(f.id[i])], Vec2{f.x[i], f.z[i]});
        }
      };
      look([](Vec2& kept, Vec2 place) { kept = place; });
      int spilled = 0;
      while (flow.time() < 0.25) {
        ASSERT_FALSE(flow.step(0.25 - flow.time()));
        look([&](Vec2& kept, Vec2 place) {
          if (first_crossed(faces, all, kept, place) >= 0) {
            ADD_FAILURE() << "from " << kept.x << ", " << kept.z << " to " << place.x << ", "
                          << place.z << " m";
          }
          spilled += kept.x < middle && place.x >= middle ? 1 : 0;
          kept = place;
        });
        ASSERT_FALSE(HasFailure());
      }
      EXPECT_EQ(flow.particles_inside_walls(), 0);
      EXPECT_GT(spilled, 0) << "the corners were not tried";
    }
  }
}

// 40 mm: the support of 106 mm is larger than the solids.
INSTANTIATE_TEST_SUITE_P(Spacings, TightWalls, ::testing::Values(0.04, 0.02, 0.01));

}  // namespace
}  // namespace parapet::solver
