#pragma once

#include <limits>

namespace parapet::acquisition {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace parapet::acquisition
