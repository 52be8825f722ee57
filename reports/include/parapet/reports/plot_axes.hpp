/// Ticks at round numbers and the labels that belong to them.
#pragma once

#include <string>
#include <vector>

namespace parapet::reports {

/// Round numbers along an axis.
struct Ticks {
  double step = 1.0;
  std::vector<double> values;       ///< multiples of the step within the range
  std::vector<std::string> labels;  ///< [values]; all with the same number of decimals
};

/// About `wanted` ticks in lower..upper, at steps of 1, 2 or 5 times a power of ten.
/// @pre lower < upper, both finite; wanted >= 1
Ticks nice_ticks(double lower, double upper, int wanted);

/// The smallest of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below a value >
/// 0.
double round_up(double value);

}  // namespace parapet::reports
