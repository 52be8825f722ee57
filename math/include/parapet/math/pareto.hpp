/// Pareto dominance and hypervolume, all objectives minimised.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace parapet::math {

/// Objectives of one design [n_objectives], minimised.
using Objectives = Eigen::VectorXd;

/// a is nowhere worse than b and somewhere better.
bool dominates(const Objectives& a, const Objectives& b);

/// Indices of the points that no other point dominates, in their order; of equal points the first.
std::vector<std::size_t> non_dominated(const std::vector<Objectives>& points);

/// Puts a point into a front unless a point there is as good in everything; takes out those that it
/// dominates.
/// @return whether it entered
/// @throws std::invalid_argument for vectors of different length.
bool enter_front(std::vector<Objectives>& front, const Objectives& point);

/// Volume that the points dominate below the reference point; points that are not better than it in
/// every objective add nothing. Exact for any number of objectives (sweep for two, the WFG
/// algorithm of While, Bradstreet and Barone, IEEE Trans. Evol. Comput. 16 (2012) 86-95, for more);
/// for one it is the distance of the best value to the reference.
/// @throws std::invalid_argument for vectors of different length.
double hypervolume(const std::vector<Objectives>& points, const Objectives& reference);

/// @throws std::invalid_argument, naming `what`, unless v has n elements.
void check_objectives(const char* what, const Objectives& v, Eigen::Index n);

}  // namespace parapet::math
