/// The region of objective space that no point dominates, as boxes.
#pragma once

#include <vector>

#include "parapet/math/pareto.hpp"

namespace parapet::acquisition {

using math::Objectives;

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
