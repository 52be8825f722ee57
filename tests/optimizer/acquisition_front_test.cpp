/// Dominance, hypervolume and the boxes of the undominated region.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "front_checks.hpp"

namespace parapet::acquisition {
namespace {

TEST(Dominance, NeedsOneObjectiveToBeBetter) {
  EXPECT_TRUE(dominates(vec({1, 2}), vec({1, 3})));
  EXPECT_FALSE(dominates(vec({1, 2}), vec({1, 2})));
  EXPECT_FALSE(dominates(vec({1, 2}), vec({2, 1})));
  EXPECT_FALSE(dominates(vec({1, std::nan("")}), vec({2, 3}))) << "what is no number beats nothing";
  EXPECT_THROW(dominates(vec({1, 2}), vec({1, 2, 3})), std::invalid_argument);
}

TEST(Dominance, OfEqualPointsTheFirstStays) {
  const std::vector<Objectives> points = {vec({3, 3}), vec({1, 2}), vec({2, 1}),
                                          vec({1, 2}), vec({1, 3}), vec({0, 9})};
  EXPECT_EQ(non_dominated(points), (std::vector<std::size_t>{1, 2, 5}));
  EXPECT_TRUE(non_dominated({}).empty());
}

TEST(Dominance, AFrontGrownPointByPointIsThatOfAllPoints) {
  std::mt19937 engine(5);
  for (const Eigen::Index m : {1, 2, 3}) {
    std::vector<Objectives> all, grown;
    const Objectives reference = Objectives::Constant(m, 5.5);
    for (int k = 0; k < 120; ++k) {
      // Few values, so that points repeat and tie.
      Objectives point(m);
      for (double& value : point) value = static_cast<double>(engine() % 6U);
      all.push_back(point);
      const double before = math::hypervolume(grown, reference);
      const bool entered = math::enter_front(grown, all.back());
      const double after = math::hypervolume(grown, reference);
      EXPECT_TRUE(entered || after == before);
      EXPECT_EQ(after, math::hypervolume(all, reference)) << "to the last bit";
    }
    std::vector<Objectives> front;
    for (const std::size_t k : non_dominated(all)) front.push_back(all[k]);
    EXPECT_EQ(grown, front);
  }
}

TEST(Hypervolume, ByHand) {
  EXPECT_EQ(hypervolume({vec({3}), vec({1})}, vec({4})), 3.0) << "one objective: the distance";
  EXPECT_EQ(hypervolume({vec({1, 3}), vec({2, 2}), vec({3, 1})}, vec({4, 4})), 6.0);
  EXPECT_EQ(hypervolume({vec({1, 1, 1})}, vec({2, 3, 4})), 6.0);
  // Two boxes of 2 x 1 x 1 that share a unit cube.
  EXPECT_EQ(hypervolume({vec({0, 1, 1}), vec({1, 0, 1})}, vec({2, 2, 2})), 3.0);
  // Three such, one along each axis: the cube is counted once.
  EXPECT_EQ(hypervolume({vec({0, 1, 1}), vec({1, 0, 1}), vec({1, 1, 0})}, vec({2, 2, 2})), 4.0);
  // The same in four objectives.
  EXPECT_EQ(
      hypervolume({vec({0, 1, 1, 1}), vec({1, 0, 1, 1}), vec({1, 1, 0, 1})}, vec({2, 2, 2, 2})),
      4.0);
}

TEST(Hypervolume, PointsThatAddNothing) {
  const Objectives reference = vec({4, 4});
  EXPECT_EQ(hypervolume({}, reference), 0.0);
  EXPECT_EQ(hypervolume({vec({4, 0}), vec({0, 4}), vec({5, 1})}, reference), 0.0);
  EXPECT_EQ(hypervolume({vec({std::nan(""), 1})}, reference), 0.0);
  EXPECT_EQ(hypervolume({vec({1, 3}), vec({1, 3}), vec({2, 3}), vec({9, 0})}, reference), 3.0);
  EXPECT_THROW(hypervolume({vec({1, 3, 2})}, reference), std::invalid_argument);
  EXPECT_THROW(hypervolume({}, Objectives()), std::invalid_argument);
}

TEST(Hypervolume, AgreesWithInclusionAndExclusion) {
  SeededDraws draws(1);
  for (Eigen::Index m = 1; m <= 4; ++m) {
    for (int trial = 0; trial < 60; ++trial) {
      const auto n = static_cast<std::size_t>(1 + trial % 8);
      const auto points = trial % 3 == 0   ? random_front(draws, n, m)
                          : trial % 3 == 1 ? random_points(draws, n, m)
                                           : random_points(draws, n, m, 4);
      const Objectives reference = Objectives::Constant(m, trial % 2 == 0 ? 1.1 : 0.8);
      // 255 terms of up to 1.5 each with their own rounding.
      EXPECT_NEAR(hypervolume(points, reference), volume_by_inclusion_exclusion(points, reference),
                  1e-13)
          << m << " objectives, trial " << trial;
    }
  }
}

TEST(Hypervolume, DoesNotDependOnTheOrder) {
  SeededDraws draws(2);
  for (Eigen::Index m = 2; m <= 5; ++m) {
    auto points = random_front(draws, 20, m);
    const Objectives reference = Objectives::Constant(m, 1.0);
    const double volume = hypervolume(points, reference);
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(hypervolume(points, reference), volume) << m << " objectives";
  }
}

/// Everything that is asked of a decomposition of {ideal < y <= reference}, ideal finite.
void check_boxes(const std::vector<Objectives>& points, const Objectives& reference,
                 const Objectives& ideal) {
  const auto boxes = undominated_boxes(points, reference, ideal);
  double volume = 0.0;
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    const Box& box = boxes[a];
    ASSERT_TRUE((box.lower.array() < box.upper.array()).all());
    ASSERT_TRUE((box.lower.array() >= ideal.array()).all());
    ASSERT_TRUE((box.upper.array() <= reference.array()).all());
    volume += (box.upper - box.lower).prod();
    for (const Objectives& p : points) {
      EXPECT_FALSE((p.array() < box.upper.array()).all()) << "a part of the box is dominated";
    }
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_TRUE((box.upper.array() <= boxes[b].lower.array()).any() ||
                  (boxes[b].upper.array() <= box.lower.array()).any())
          << "boxes " << a << " and " << b << " overlap";
    }
  }
  // Points below the ideal dominate no more than those on it.
  std::vector<Objectives> clipped = points;
  for (Objectives& p : clipped) p = p.cwiseMax(ideal);
  const double whole = (reference - ideal).prod();
  // A few hundred terms, each below `whole` and good to a few digits of the last place.
  EXPECT_NEAR(volume + hypervolume(clipped, reference), whole, 1e-13 * whole);
}

TEST(UndominatedBoxes, AreDisjointAndWhole) {
  SeededDraws draws(3);
  for (Eigen::Index m = 1; m <= 4; ++m) {
    for (int trial = 0; trial < 40; ++trial) {
      const auto n = static_cast<std::size_t>(trial % 13);
      const auto points = trial % 3 == 0   ? random_front(draws, n, m)
                          : trial % 3 == 1 ? random_points(draws, n, m)
                                           : random_points(draws, n, m, 5);
      SCOPED_TRACE(testing::Message() << m << " objectives, trial " << trial);
      const double reference = trial % 4 == 0 ? 0.7 : 1.2, ideal = trial % 5 == 0 ? 0.3 : -0.5;
      check_boxes(points, Objectives::Constant(m, reference), Objectives::Constant(m, ideal));
    }
  }
}

TEST(UndominatedBoxes, AreFew) {
  // 30 points of which none dominates another and no coordinate repeats: n + 1 and 2 n + 1 boxes.
  SeededDraws draws(4);
  for (int trial = 0; trial < 5; ++trial) {
    for (Eigen::Index m = 2; m <= 3; ++m) {
      const auto points = random_front(draws, 30, m);
      const auto boxes = undominated_boxes(points, Objectives::Constant(m, 1.5),
                                           Objectives::Constant(m, -infinity));
      EXPECT_EQ(boxes.size(), m == 2 ? 31U : 61U);
    }
  }
}

TEST(UndominatedBoxes, APointAddsItsShareOfEachBox) {
  SeededDraws draws(5);
  for (Eigen::Index m = 1; m <= 4; ++m) {
    for (int trial = 0; trial < 40; ++trial) {
      auto points = random_front(draws, static_cast<std::size_t>(trial % 10), m);
      const Objectives reference = Objectives::Constant(m, 1.1);
      const auto boxes = undominated_boxes(points, reference, Objectives::Constant(m, -infinity));
      const Objectives y = draws.point(Objectives::Constant(m, -0.2), Objectives::Constant(m, 1.2));
      double share = 0.0;
      for (const Box& box : boxes) share += dominated_part(box, y);
      const double before = hypervolume(points, reference);
      points.push_back(y);
      EXPECT_NEAR(hypervolume(points, reference) - before, share, 1e-13)
          << m << " objectives, trial " << trial;
    }
  }
}

TEST(UndominatedBoxes, WithoutABetterPointTheyAreTheWholeRegion) {
  const Objectives reference = vec({2, 3}), ideal = vec({-infinity, 0});
  for (const auto& points : {std::vector<Objectives>{}, {vec({2, 1})}, {vec({5, 5})}}) {
    const auto boxes = undominated_boxes(points, reference, ideal);
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_EQ(boxes[0].lower, ideal);
    EXPECT_EQ(boxes[0].upper, reference);
  }
}

TEST(UndominatedBoxes, NoneWhereNothingCanBeGained) {
  EXPECT_TRUE(undominated_boxes({vec({0, 0})}, vec({1, 1}), vec({0, 0})).empty());
  EXPECT_TRUE(undominated_boxes({vec({-1, 0})}, vec({1, 1}), vec({0, 0})).empty());
  EXPECT_TRUE(undominated_boxes({}, vec({1, 1}), vec({0, 1})).empty());
  EXPECT_THROW(undominated_boxes({}, vec({1, 1}), vec({0})), std::invalid_argument);
  EXPECT_THROW(undominated_boxes({vec({0})}, vec({1, 1}), vec({0, 0})), std::invalid_argument);
}

}  // namespace
}  // namespace parapet::acquisition
