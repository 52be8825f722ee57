#include "parapet/study/knee.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace parapet::study {
namespace {

using Points = std::vector<std::vector<double>>;

TEST(Knee, KneeOfAQuarterCircleIsItsMiddle) {
  // (1 - cos t, 1 - sin t) bulges towards the ideal by (cos t + sin t - 1) / sqrt 2 from the line
  // through its ends: sqrt 2 - 1 over sqrt 2 at 45 degrees. The second objective's unit is another.
  Points points;
  for (int k = 0; k <= 6; ++k) {
    const double t = k * std::acos(0.0) / 6.0;
    points.push_back({1.0 - std::cos(t), 500.0 - 100.0 * std::sin(t)});
  }
  const Knee knee = knee_of(points);
  EXPECT_TRUE(knee.through_ends);
  EXPECT_EQ(knee.ends, (std::vector<std::size_t>{0, 6}));
  for (int k = 0; k <= 6; ++k) {
    const double t = k * std::acos(0.0) / 6.0;
    EXPECT_NEAR(knee.distance[static_cast<std::size_t>(k)],
                (std::cos(t) + std::sin(t) - 1.0) / std::sqrt(2.0), 1e-12)
        << "rounding only";
  }
}

TEST(Knee, PlaneGoesThroughTheEndsOfThreeObjectives) {
  // Ends at the unit vectors and one point inside: (1 - 0.6) / sqrt 3 from x + y + z = 1.
  const Points points{{0, 1, 1}, {1, 0, 1}, {1, 1, 0}, {0.2, 0.2, 0.2}};
  const Knee knee = knee_of(points);
  EXPECT_TRUE(knee.through_ends);
  // The ends lie on x + y + z = 2.
  EXPECT_NEAR(knee.distance[3], (2.0 - 0.6) / std::sqrt(3.0), 1e-12);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(knee.distance[k], 0.0, 1e-12);
}

TEST(Knee, EndsThatSpanNoPlaneAreSaid) {
  // One design is best in two of three objectives.
  const Points points{{0, 0, 1}, {1, 1, 0}, {0.5, 0.5, 0.2}};
  const Knee knee = knee_of(points);
  EXPECT_FALSE(knee.through_ends);
  EXPECT_NEAR(knee.distance[0], 0.0, 1e-12) << "an end is at its worst somewhere";
  EXPECT_NEAR(knee.distance[2], 1.0 - 0.5, 1e-12) << "its worst objective is half way";
}

TEST(Knee, AStraightFrontHasNoneAndABentOneHas) {
  // On the line but for 0.02: the balanced design is taken, in the middle.
  const Points straight{{0, 1}, {0.2, 0.78}, {0.52, 0.5}, {0.8, 0.18}, {1, 0}};
  EXPECT_LT(bulge_of(knee_of(straight)), least_bulge);
  EXPECT_EQ(largest_objectives(straight), (std::vector<double>{1, 0.78, 0.52, 0.8, 1}));
  EXPECT_EQ(default_pick(straight), 2U);
  // The same with one design far towards the ideal, not in the middle.
  const Points bent{{0, 1}, {0.1, 0.3}, {0.52, 0.28}, {0.8, 0.18}, {1, 0}};
  EXPECT_NEAR(bulge_of(knee_of(bent)), (1.0 - 0.1 - 0.3) / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(default_pick(bent), 1U);
  // Two designs are both ends: nothing lies between them.
  EXPECT_EQ(bulge_of(knee_of({{0, 1}, {1, 0}})), 0.0);
}

TEST(Knee, OnePointIsItsOwnKnee) {
  const Knee knee = knee_of({{2.0, 5.0}});
  EXPECT_TRUE(std::isfinite(knee.distance[0]));
  EXPECT_EQ(knee.ends, (std::vector<std::size_t>{0, 0}));
}

}  // namespace
}  // namespace parapet::study
