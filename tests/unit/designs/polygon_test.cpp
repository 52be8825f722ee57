#include "polygon.hpp"

#include <gtest/gtest.h>

namespace parapet::designs {
namespace {

Polygon square(double x, double z, double side) {
  return {{x, z}, {x + side, z}, {x + side, z + side}, {x, z + side}};
}

TEST(Polygon, AreaCountsTheWayRound) {
  EXPECT_DOUBLE_EQ(signed_area(square(1, 2, 3)), 9.0);
  EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {0, 1}, {1, 0}}), -0.5);
}

TEST(Polygon, CrossingSidesAreSeen) {
  EXPECT_TRUE(is_simple(square(0, 0, 1)));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
}

TEST(Polygon, Overlap) {
  const Polygon a = square(0, 0, 1);
  EXPECT_TRUE(overlap(a, square(0.5, 0.5, 1)));    // sides cross
  EXPECT_TRUE(overlap(a, square(0.2, 0.2, 0.1)));  // one inside the other, either way
  EXPECT_TRUE(overlap(square(0.2, 0.2, 0.1), a));
  EXPECT_TRUE(overlap(a, square(0.25, 0, 1)));  // shifted along itself: no sides cross
  EXPECT_FALSE(overlap(a, square(1, 0, 1)));    // touching
  EXPECT_FALSE(overlap(a, square(3, 0, 1)));
}

}  // namespace
}  // namespace parapet::designs
