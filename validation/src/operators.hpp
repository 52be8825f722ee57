// Particles to try the sums of the scheme on, and what the parts of that case share.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "case.hpp"
#include "flow.hpp"

namespace parapet::validation {

constexpr double operator_side = 1.0;  // period along x, and height of what is looked at [m]
constexpr double operator_wave = 2.0 * std::numbers::pi / operator_side;

// Particles with periodic ends over a height of `operator_side` and a margin that keeps the
// surfaces out of reach of what is looked at. Settled: between free-slip walls at the ends of the
// margin; otherwise a square lattice.
solver::FlowSetup operator_block(int across, double smoothing, bool settled);

// Neighbours, pressures and gradients of the present state.
void evaluate(solver::Flow& flow);

inline bool looked_at(const solver::Fluid& f, std::size_t i) {
  return f.z[i] >= 0.0 && f.z[i] < operator_side;
}

// Visits the neighbours j of i within the support, brute force over a band sorted along z.
class Pairs {
 public:
  explicit Pairs(const solver::Flow& flow)
      : f_(flow.fluid()), h_(flow.smoothing_length()), order_(static_cast<std::size_t>(f_.n)) {
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = k;
    std::sort(order_.begin(), order_.end(), [&](auto a, auto b) { return f_.z[a] < f_.z[b]; });
  }
  template <class Body>  // body(i, j, r_ij, r)
  void for_each(const Body& body) const {
    for (std::size_t a = 0; a < order_.size(); ++a) {
      const std::size_t i = order_[a];
      for (std::size_t b = a + 1; b < order_.size(); ++b) {
        const std::size_t j = order_[b];
        const double rz = f_.z[i] - f_.z[j];
        if (-rz >= 2.0 * h_) break;
        double rx = f_.x[i] - f_.x[j];
        rx -= operator_side * std::round(rx / operator_side);
        const double r = std::hypot(rx, rz);
        if (r >= 2.0 * h_) continue;
        body(i, j, solver::Vec2{rx, rz}, r);
        body(j, i, solver::Vec2{-rx, -rz}, r);
      }
    }
  }

 private:
  const solver::Fluid& f_;
  double h_;
  std::vector<std::size_t> order_;
};

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
