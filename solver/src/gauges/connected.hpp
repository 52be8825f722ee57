// Which particles hang together.
#pragma once

#include <span>
#include <vector>

#include "parapet/flow/fluid.hpp"
#include "parapet/flow/index.hpp"
#include "parapet/solver/vec2.hpp"

namespace parapet::solver {

// The heaviest body among particles at these places: two of them hang together when they are no
// farther apart than `reach` [m], and so does whatever is linked through others.
// @return indices of its particles, rising; empty when there are none
std::vector<std::size_t> main_body(std::span<const Vec2> places, std::span<const double> masses,
                                   double reach);

// Some of the particles.
struct Part {
  std::vector<Vec2> places;
  std::vector<double> masses;  // [kg/m]
};

// Those whose places are wanted.
template <typename Wanted>
Part part_of(const Fluid& f, Wanted wanted) {
  Part part;
  for (std::size_t i = 0; i < at(f.n); ++i) {
    const Vec2 p{f.x[i], f.z[i]};
    if (!wanted(p)) continue;
    part.places.push_back(p);
    part.masses.push_back(f.mass[i]);
  }
  return part;
}

}  // namespace parapet::solver
