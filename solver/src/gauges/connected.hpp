// Which particles hang together.
#pragma once

#include <span>
#include <vector>

#include "parapet/solver/vec2.hpp"

namespace parapet::solver {

// The heaviest body among particles at these places: two of them hang together when they are no
// farther apart than `reach` [m], and so does whatever is linked through others.
// @return indices of its particles, rising; empty when there are none
std::vector<std::size_t> main_body(std::span<const Vec2> places, std::span<const double> masses,
                                   double reach);

}  // namespace parapet::solver
