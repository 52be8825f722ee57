// Where stems and deflectors point, and what a segment meets first.
#include "parapet/flow/geometry.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace parapet::solver {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Vec2 to_world(const Scene& scene, Vec2 v) {
  const double a = scene.slope;
  return {v.x * std::cos(a) + v.z * std::sin(a), -v.x * std::sin(a) + v.z * std::cos(a)};
}

TEST(Barriers, StemsStandVerticalInTheWorldByDefault) {
  const Scene scene;
  const Vec2 stem = to_world(scene, stem_direction(scene, Barrier{}));
  EXPECT_NEAR(stem.x, 0.0, 1e-12);
  EXPECT_NEAR(stem.z, 1.0, 1e-12);
}

TEST(Barriers, LeanOfMinusSlopeIsNormalToTheBed) {
  const Scene scene;
  Barrier barrier;
  barrier.stem_lean = -scene.slope;
  const Vec2 stem = stem_direction(scene, barrier);
  EXPECT_NEAR(stem.x, 0.0, 1e-12);
  EXPECT_NEAR(stem.z, 1.0, 1e-12);
}

TEST(Barriers, DeflectorAngleIsMeasuredFromTheWorldsHorizontal) {
  const Scene scene;
  const Vec2 flat = to_world(scene, deflector_direction(scene, {0.0, 0.065}));
  EXPECT_NEAR(flat.x, -1.0, 1e-12);  // points upstream
  EXPECT_NEAR(flat.z, 0.0, 1e-12);
  const Vec2 raised = to_world(scene, deflector_direction(scene, {30.0 * degree, 0.065}));
  EXPECT_NEAR(raised.z, 0.5, 1e-12);  // a positive angle lifts the tip
}

TEST(Barriers, OutlineKeepsHeightLengthAndThickness) {
  Scene scene;
  for (const double angle : {-20.0, 0.0, 45.0, 60.0, 90.0}) {
    Barrier barrier;
    barrier.deflector = Deflector{angle * degree, 0.065};
    const auto outline = barrier_outline(scene, barrier);
    ASSERT_EQ(outline.size(), 6u);
    EXPECT_NEAR(norm(outline[1] - outline[0]), barrier.height, 1e-12);
    EXPECT_NEAR(norm(outline[2] - outline[1]), 0.065, 1e-12);
    EXPECT_NEAR(norm(outline[3] - outline[2]), barrier.thickness, 1e-12);
    // the joint lies at the thickness from both inner faces
    const Vec2 stem = stem_direction(scene, barrier);
    const Vec2 plate = deflector_direction(scene, *barrier.deflector);
    EXPECT_NEAR(std::abs(cross(stem, outline[4] - outline[1])), barrier.thickness, 1e-12) << angle;
    EXPECT_NEAR(std::abs(cross(plate, outline[4] - outline[1])), barrier.thickness, 1e-12) << angle;
    EXPECT_NEAR(outline[5].z, 0.0, 1e-12);
  }
}

// Clockwise outlines around (0, 0), their upper corner; looked at from left to right.
std::vector<Vec2> wedge(double half_angle) {
  return {{-std::tan(half_angle), -1.0}, {0.0, 0.0}, {std::tan(half_angle), -1.0}};
}

TEST(Hidden, ACornerHidesNothingCloseBehindIt) {
  Solids solids;
  add_outline(solids, wedge(45.0 * degree), -1, false);
  const std::vector<int> all{0, 1, 2};
  const auto across = [&](double depth, double corner) {
    const Vec2 p{-0.5, -depth}, q{0.5, -depth};  // 1.41 depth from the corner along either face
    const bool one = hidden(solids.faces, all, p, q, corner);
    EXPECT_EQ(one, hidden(solids.faces, all, q, p, corner));
    return one;
  };
  EXPECT_FALSE(across(-0.01, 0.1));
  EXPECT_FALSE(across(0.07, 0.1));
  EXPECT_TRUE(across(0.072, 0.1));
  EXPECT_TRUE(across(0.001, 0.0));
  // of a place behind the face and one inside the fluid nothing is seen
  EXPECT_TRUE(hidden(solids.faces, all, {-0.5, -0.05}, {0.0, -0.05}, 0.1));
}

TEST(Hidden, AThinWedgeIsSeenAroundAtItsTipOnly) {
  Solids solids;
  add_outline(solids, wedge(1.0 * degree), -1, false);
  const std::vector<int> all{0, 1, 2};
  EXPECT_FALSE(hidden(solids.faces, all, {-0.05, -0.09}, {0.05, -0.09}, 0.1));
  EXPECT_TRUE(hidden(solids.faces, all, {-0.05, -0.11}, {0.05, -0.11}, 0.1));
}

TEST(Hidden, APlateIsSeenAroundByNobodyHoweverThin) {
  for (const double thickness : {2e-9, 1e-4, 0.05}) {
    Solids solids;
    add_outline(solids, {{0.0, -1.0}, {0.0, 0.0}, {thickness, 0.0}, {thickness, -1.0}}, -1, true);
    ASSERT_EQ(solids.faces.size(), 3u);
    const std::vector<int> all{0, 1, 2};
    // through front and back, which share no corner
    EXPECT_TRUE(hidden(solids.faces, all, {-0.05, -0.01}, {thickness + 0.05, -0.01}, 0.1));
    // through front and top, which do
    EXPECT_FALSE(hidden(solids.faces, all, {-0.01, -0.01}, {0.5 * thickness, 0.01}, 0.1));
  }
}

TEST(Hidden, TwoBodiesThatTouchHideAsOne) {
  Solids solids;
  add_outline(solids, {{-1.0, -1.0}, {-1.0, 0.0}, {0.0, 0.0}, {0.0, -1.0}}, -1, true);
  add_outline(solids, {{0.0, -1.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, -1.0}}, -1, true);
  std::vector<int> all;
  for (int f = 0; f < static_cast<int>(solids.faces.size()); ++f) all.push_back(f);
  EXPECT_TRUE(hidden(solids.faces, all, {-1.01, -0.01}, {1.01, -0.01}, 0.1));
  EXPECT_FALSE(hidden(solids.faces, all, {-1.01, -0.01}, {-0.98, 0.02}, 0.1));
}

TEST(Faces, NormalsOfABarrierPointIntoTheFluid) {
  const Scene scene;
  Solids solids;
  add_outline(solids, barrier_outline(scene, Barrier{}), 0, true);
  ASSERT_EQ(solids.faces.size(), 3u);  // upstream, crest, downstream; none along the bed
  EXPECT_LT(solids.faces[0].normal.x, 0.0);
  EXPECT_GT(solids.faces[1].normal.z, 0.0);
  EXPECT_GT(solids.faces[2].normal.x, 0.0);
}

TEST(Faces, APathIsStoppedByTheFirstFaceFromItsFluidSide) {
  Solids solids;
  add_outline(solids, {{0.0, 0.0}, {0.0, 0.1}, {0.01, 0.1}, {0.01, 0.0}}, 0, true);
  const std::vector<int> all{0, 1, 2};
  EXPECT_EQ(first_crossed(solids.faces, all, {-0.01, 0.05}, {0.02, 0.05}), 0);
  EXPECT_EQ(first_crossed(solids.faces, all, {0.02, 0.05}, {-0.01, 0.05}), 2);
  EXPECT_EQ(first_crossed(solids.faces, all, {0.005, 0.12}, {0.005, 0.05}), 1);
  EXPECT_EQ(first_crossed(solids.faces, all, {-0.01, 0.15}, {0.02, 0.15}), -1);
  EXPECT_EQ(first_crossed(solids.faces, all, {0.005, 0.05}, {-0.02, 0.05}), -1);  // from inside
}

TEST(Faces, InsideAndOutsideOfAnOutline) {
  const Scene scene;
  Barrier barrier;
  barrier.deflector = Deflector{0.3, 0.065};
  const auto outline = barrier_outline(scene, barrier);
  EXPECT_TRUE(inside_polygon(outline, outline[0] + Vec2{0.005, 0.002}));
  EXPECT_FALSE(inside_polygon(outline, outline[0] - Vec2{0.005, -0.002}));
}

}  // namespace
}  // namespace parapet::solver
