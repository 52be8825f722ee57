/// Shapes of arguments.
#pragma once

#include <stdexcept>
#include <string>

#include "parapet/acquisition/hypervolume.hpp"

namespace parapet::acquisition {

/// @throws std::invalid_argument unless v has n elements.
inline void check_objectives(const char* what, const Objectives& v, Eigen::Index n) {
  if (v.size() == n) return;
  throw std::invalid_argument(std::string(what) + " has " + std::to_string(v.size()) +
                              " objectives instead of " + std::to_string(n));
}

}  // namespace parapet::acquisition
