/// Eigen counts with signed numbers.
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace parapet::bayesian {

inline Eigen::Index as_index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

}  // namespace parapet::bayesian
