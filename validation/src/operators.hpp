// Particles to try the sums of the scheme on, and what the parts of that case share.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "case.hpp"
#include "parapet/flow/flow.hpp"

namespace parapet::validation {

constexpr double operator_side = 1.0;  // period along x, and height of what is looked at [m]
constexpr double operator_wave = 2.0 * std::numbers::pi / operator_side;

// Particles with periodic ends over a height of `operator_side` and a margin that keeps the
// surfaces out of reach of what is looked at. Settled: between free-slip walls at the ends of the
// margin; otherwise a square lattice.
solver::FlowSetup operator_block(int across, double smoothing, bool settled);

inline bool looked_at(const solver::Fluid& f, std::size_t i) {
  return f.z[i] >= 0.0 && f.z[i] < operator_side;
}

// sqrt(mean square) over the particles looked at.
template <class Value>
double rms(const solver::Fluid& f, const Value& value) {
  double square = 0.0, count = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    if (!looked_at(f, i)) continue;
    square += std::pow(value(i), 2);
    count += 1.0;
  }
  return std::sqrt(square / count);
}

// The viscous force against div(2 eta S); viscous_operator.cpp.
void add_viscous_operator(CaseRun& run, const std::vector<int>& across);

}  // namespace parapet::validation
