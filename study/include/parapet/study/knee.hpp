/// The knee of a front: where giving up a little of one objective no longer gains much of another.
#pragma once

#include <cstddef>
#include <vector>

namespace parapet::study {

/// The least and the greatest value of each objective on a front [n_objectives].
struct FrontRange {
  std::vector<double> ideal, nadir;

  /// 0 at the ideal and 1 at the nadir; 0 where the front has no range.
  std::vector<double> normalised(const std::vector<double>& point) const;
};

/// @param front [n][n_objectives], n >= 1, to be minimised
FrontRange range_of(const std::vector<std::vector<double>>& front);

/// How far each point of a front bulges from the plane through its ends.
struct Knee {
  std::vector<double> distance;   ///< [n], in normalised units; more is better
  std::vector<std::size_t> ends;  ///< [n_objectives] the point best in each objective
  /// False: the ends span no plane that faces the ideal (one point is best in two objectives).
  /// Then `distance` is 1 less the greatest normalised objective: how far the worst one is from its
  /// worst value.
  bool through_ends = false;
};

/// The distance of Das (Struct. Optim. 18 (1999) 107-115) from the convex hull of the individual
/// minima, positive towards the ideal, each objective over its range on the front. With two
/// objectives it is (1 - x - y) / sqrt 2.
/// @param front [n][n_objectives], n >= 1, non-dominated, to be minimised
Knee knee_of(const std::vector<std::vector<double>>& front);

/// A front has a knee where one of its designs is at least so far from the plane through its ends,
/// in normalised units. A straight front has 0, a quarter of a circle 0.29 of 0.71 at most.
constexpr double least_bulge = 0.1;

/// The largest distance, where it is one from a plane through the ends; else 0.
double bulge_of(const Knee& knee);

/// The largest normalised objective of each design [n]: the design with the least is the balanced
/// one, which a straight front has too.
std::vector<double> largest_objectives(const std::vector<std::vector<double>>& front);

/// What `parapet recommend` takes of a front where it is told nothing: the knee, or the balanced
/// design where there is none.
std::size_t default_pick(const std::vector<std::vector<double>>& front);

}  // namespace parapet::study
