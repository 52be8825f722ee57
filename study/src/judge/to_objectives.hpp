#pragma once

#include <vector>

#include "parapet/math/pareto.hpp"

namespace parapet::study {

inline math::Objectives to_objectives(const std::vector<double>& values) {
  return Eigen::Map<const math::Objectives>(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
}

}  // namespace parapet::study
