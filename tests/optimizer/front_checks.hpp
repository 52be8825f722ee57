/// What the tests of fronts share: random fronts, and volumes by inclusion and exclusion.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "parapet/acquisition/boxes.hpp"
#include "seeded_draws.hpp"

namespace parapet::acquisition {

using math::dominates;
using math::hypervolume;
using math::non_dominated;
using math::Objectives;

constexpr double infinity = std::numeric_limits<double>::infinity();

inline Objectives vec(std::initializer_list<double> values) {
  return Eigen::Map<const Objectives>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

/// Volume between the points' boxes and the reference: the sum over all subsets of their common
/// volume with alternating signs. 2^n terms, nothing shared with the code under test.
inline double volume_by_inclusion_exclusion(const std::vector<Objectives>& points,
                                            const Objectives& reference) {
  double sum = 0.0;
  for (std::size_t subset = 1; subset < (std::size_t{1} << points.size()); ++subset) {
    Objectives corner = Objectives::Constant(reference.size(), -infinity);
    double sign = -1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (((subset >> i) & 1U) == 0) continue;
      corner = corner.cwiseMax(points[i]);
      sign = -sign;
    }
    sum += sign * (reference - corner).cwiseMax(0.0).prod();
  }
  return sum;
}

/// Points in the unit cube, dominated ones among them. With `levels` > 0 the coordinates are
/// multiples of 1 / levels, so that many are equal.
inline std::vector<Objectives> random_points(SeededDraws& draws, std::size_t n, Eigen::Index m,
                                             int levels = 0) {
  std::vector<Objectives> points;
  for (std::size_t i = 0; i < n; ++i) {
    Objectives p = draws.point(Objectives::Zero(m), Objectives::Ones(m));
    if (levels > 0) p = (p * levels).array().round() / levels;
    points.push_back(p);
  }
  return points;
}

/// Points of the unit sphere's positive part seen from (1, ..., 1): none dominates another.
inline std::vector<Objectives> random_front(SeededDraws& draws, std::size_t n, Eigen::Index m) {
  std::vector<Objectives> points;
  for (std::size_t i = 0; i < n; ++i) {
    Objectives p(m);
    for (Eigen::Index j = 0; j < m; ++j) p[j] = std::abs(draws.normal());
    points.push_back(Objectives::Ones(m) - p.normalized());
  }
  return points;
}

/// The part of a box that y dominates.
inline double dominated_part(const Box& box, const Objectives& y) {
  return (box.upper - box.lower.cwiseMax(y)).cwiseMax(0.0).prod();
}

}  // namespace parapet::acquisition
