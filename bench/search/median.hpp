// Median of a few numbers.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace parapet::bench::search {

// @throws std::invalid_argument for none. Infinite values are allowed.
inline double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("the median of nothing");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  if (values.size() % 2 == 1) return values[half];
  return 0.5 * (values[half - 1] + values[half]);
}

}  // namespace parapet::bench::search
