/// Visits pairs of particles without the neighbour rows: slow, and independent of what it checks.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "parapet/flow/flow.hpp"

namespace parapet::solver {

/// Calls body(i, j, r_ij, r) for all ordered pairs of particles less than 2h apart, r_ij = r_i -
/// r_j and r its length [m]; in a periodic flow r_ij leads to the nearest image. By brute force
/// over a band sorted along z.
template <class Body>
void for_each_pair(const Flow& flow, const Body& body) {
  const Fluid& f = flow.fluid();
  const double reach = 2.0 * flow.smoothing_length(), period = flow.setup().periodic_length;
  std::vector<std::size_t> order(static_cast<std::size_t>(f.n));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return f.z[a] < f.z[b]; });
  for (std::size_t a = 0; a < order.size(); ++a) {
    const std::size_t i = order[a];
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const std::size_t j = order[b];
      const double rz = f.z[i] - f.z[j];
      if (-rz >= reach) break;
      double rx = f.x[i] - f.x[j];
      if (period > 0.0) rx -= period * std::round(rx / period);
      const double r = std::hypot(rx, rz);
      if (r >= reach) continue;
      body(i, j, Vec2{rx, rz}, r);
      body(j, i, Vec2{-rx, -rz}, r);
    }
  }
}

}  // namespace parapet::solver
