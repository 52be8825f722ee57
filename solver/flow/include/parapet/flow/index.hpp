/// Particle and slot numbers are 32-bit integers; containers want std::size_t.
#pragma once

#include <cstddef>

namespace parapet::solver {

/// The number as an index: f.x[at(i)].
constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace parapet::solver
