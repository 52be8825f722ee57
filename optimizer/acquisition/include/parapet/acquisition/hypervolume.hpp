/// Pareto dominance and hypervolume, all objectives minimised.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace parapet::acquisition {

/// Objectives of one design [n_objectives], minimised.
using Objectives = Eigen::VectorXd;

/// a is nowhere worse than b and somewhere better.
bool dominates(const Objectives& a, const Objectives& b);

/// Indices of the points that no other point dominates, in their order; of equal points the first.
std::vector<std::size_t> non_dominated(const std::vector<Objectives>& points);

/// Volume that the points dominate below the reference point; points that are not better than it in
/// every objective add nothing. Exact for any number of objectives (sweep for two, the WFG
/// algorithm of While, Bradstreet and Barone, IEEE Trans. Evol. Comput. 16 (2012) 86-95, for more);
/// for one it is the distance of the best value to the reference.
/// @throws std::invalid_argument for vectors of different length.
double hypervolume(const std::vector<Objectives>& points, const Objectives& reference);

/// A box lower < y <= upper; lower may be -infinity.
struct Box {
  Objectives lower, upper;
};

/// Disjoint boxes that together are the part of {ideal < y <= reference} that no point dominates:
/// an objective vector that lands there adds hypervolume. `ideal` holds the least values that are
/// possible at all, -infinity where nothing is known. A sweep along the last objective, in which
/// boxes of the others go on until a point changes them: n + 1 boxes at most for two objectives and
/// 2 n + 1 for three, the least that is possible in general (Lacour, Klamroth and Fonseca, Comput.
/// Oper. Res. 79 (2017) 347-360, decompose as finely).
/// @throws std::invalid_argument for vectors of different length.
std::vector<Box> undominated_boxes(const std::vector<Objectives>& points,
                                   const Objectives& reference, const Objectives& ideal);

}  // namespace parapet::acquisition
