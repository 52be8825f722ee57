/// What a search would recommend, from designs known at any level, and what is left to confirm.
#pragma once

#include <vector>

#include "models.hpp"
#include "parapet/bayesian/search.hpp"

namespace parapet::bayesian {

/// The front as the surrogates see it: designs told at any level that meet the limits with at least
/// even odds, by the median of their objectives at the finest level; none dominates another. Where
/// no design has even odds, the one with the best.
struct EstimatedFront {
  std::vector<std::size_t> told;  ///< [n] index into what was told, one of each design
  std::vector<std::vector<double>> objectives;  ///< [n][n_objectives], minimised
};
EstimatedFront estimated_front(const Problem& problem, const Models& models,
                               const std::vector<Told>& told, double tolerance);

/// The designs of the front: what `recommend` picks of it (empty: the least of the largest
/// normalised objective), then the others, nearest to it first in normalised objectives.
std::vector<Point> by_nearness_to_recommended(const EstimatedFront& front,
                                              const std::vector<Told>& told,
                                              const Recommend& recommend);

}  // namespace parapet::bayesian
