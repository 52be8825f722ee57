/// The space of designs: canonical form, inactive variables, and what the surrogate sees of them.
#include <gtest/gtest.h>

#include <cmath>

#include "parapet/bayesian/space.hpp"

namespace parapet::bayesian {
namespace {

/// Angle and length exist only with a deflector; the number of plates only with the big one.
Space barrier_space() {
  return Space({{.name = "height", .lower = 0.1, .upper = 0.3},
                {.name = "deflector", .kind = VariableKind::choice, .lower = 0, .upper = 2},
                {.name = "angle",
                 .lower = 0.0,
                 .upper = 75.0,
                 .active_when = Condition{.choice = 1, .options = {1, 2}}},
                {.name = "plates",
                 .kind = VariableKind::integer,
                 .lower = 1,
                 .upper = 4,
                 .active_when = Condition{.choice = 1, .options = {2}}}});
}

TEST(Space, GivesInactiveVariablesNoValue) {
  const Space space = barrier_space();
  const Point without = space.canonical({0.2, 0.0, 30.0, 2.0});
  EXPECT_TRUE(std::isnan(without[2]));
  EXPECT_TRUE(std::isnan(without[3]));
  const Point small = space.canonical({0.2, 1.0, 30.0, 2.0});
  EXPECT_EQ(small[2], 30.0);
  EXPECT_TRUE(std::isnan(small[3]));
}

TEST(Space, RoundsIntegersAndOptionsAndClipsToTheBounds) {
  const Point x = barrier_space().canonical({0.5, 1.7, -3.0, 2.4});
  EXPECT_EQ(x[0], 0.3);
  EXPECT_EQ(x[1], 2.0);
  EXPECT_EQ(x[2], 0.0);
  EXPECT_EQ(x[3], 2.0);
}

TEST(Space, DesignsThatDifferOnlyInInactiveVariablesAreOneInput) {
  const Space space = barrier_space();
  const Point a = space.canonical({0.2, 0.0, 10.0, 1.0});
  const Point b = space.canonical({0.2, 0.0, 70.0, 4.0});
  EXPECT_TRUE(same_design(a, b));
  EXPECT_EQ(space.features(a), space.features(b));
}

TEST(Space, OptionsAreAtTheSameDistanceFromEachOther) {
  const Space space({{.name = "kind", .kind = VariableKind::choice, .lower = 0, .upper = 3}});
  for (double a = 0.0; a < 4.0; a += 1.0) {
    for (double b = 0.0; b < a; b += 1.0) {
      // 1/sqrt 2 in two columns: exactly 1 but for rounding
      EXPECT_NEAR((space.features(Point{a}) - space.features(Point{b})).norm(), 1.0, 1e-15);
    }
  }
}

TEST(Space, EveryIntegerAndOptionHasAnEqualShareOfTheUnitInterval) {
  const Space space({{.name = "n", .kind = VariableKind::integer, .lower = 2, .upper = 5}});
  int count[4] = {};
  for (int k = 0; k < 400; ++k) {
    ++count[static_cast<int>(space.from_unit({(k + 0.5) / 400.0})[0]) - 2];
  }
  for (const int c : count) EXPECT_EQ(c, 100);
  EXPECT_EQ(space.from_unit({1.0})[0], 5.0);
}

TEST(Space, UnitCoordinatesLeadBackToTheSameDesign) {
  const Space space = barrier_space();
  for (const Point& x : {Point{0.25, 2.0, 33.0, 3.0}, Point{0.1, 0.0, 0.0, 1.0}}) {
    const Point canonical = space.canonical(x);
    const Point back = space.from_unit(space.to_unit(canonical));
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (std::isnan(canonical[i])) {
        EXPECT_TRUE(std::isnan(back[i]));
      } else {
        EXPECT_NEAR(back[i], canonical[i], 1e-12);  // one rounding of the share
      }
    }
  }
}

TEST(Space, GroupsTheColumnsOfAChoice) {
  const surrogate::Layout layout = barrier_space().layout(2);
  EXPECT_EQ(layout.group, (std::vector<int>{0, 1, 1, 1, 2, 3}));
  EXPECT_EQ(layout.n_levels, 2);
}

TEST(Space, ListsTheCombinationsOfChoices) {
  const Space space({{.name = "barriers", .kind = VariableKind::choice, .lower = 0, .upper = 1},
                     {.name = "second",
                      .kind = VariableKind::choice,
                      .lower = 0,
                      .upper = 2,
                      .active_when = Condition{.choice = 0, .options = {1}}}});
  // one barrier, or two with three kinds of the second
  EXPECT_EQ(space.choice_combinations().size(), 4U);
}

TEST(Space, RefusesConditionsThatCannotBeJudged) {
  EXPECT_THROW(Space({{.name = "a", .active_when = Condition{.choice = 0, .options = {0}}}}),
               std::invalid_argument);
  EXPECT_THROW(
      Space({{.name = "a"}, {.name = "b", .active_when = Condition{.choice = 0, .options = {0}}}}),
      std::invalid_argument);
  EXPECT_THROW(Space({{.name = "a", .lower = 1.0, .upper = 1.0}}), std::invalid_argument);
  EXPECT_THROW(barrier_space().canonical({0.2}), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::bayesian
