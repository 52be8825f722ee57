/// Finds the design of the largest expected gain.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "candidates.hpp"

namespace parapet::bayesian {

/// log of the gain [m] at designs.
using LogGain = std::function<Eigen::VectorXd(const std::vector<Point>& xs)>;

struct Candidate {
  Point x;
  double log_gain = 0.0;
};

struct MaximizeInput {
  LogGain screen;              ///< cheap, for the many
  LogGain gain;                ///< exact, for the few
  std::vector<Point> centers;  ///< designs to look around: the front and what is promising
  std::function<bool(const Point& x)> repeated;  ///< already evaluated, or nearly
  double effort = 1.0;                           ///< share of the usual number of candidates
};

/// Screens designs spread over the space and around the centers, then climbs from the best few with
/// steps that shrink. Repeated designs are passed over. Empty when all designs are repeated.
struct Maximum {
  Candidate best;
  std::vector<Point> pool;  ///< other good designs, no neighbours of each other: for the next asks
};
std::optional<Maximum> maximize_gain(const MaximizeInput& input, const Space& space,
                                     Candidates& candidates);

}  // namespace parapet::bayesian
