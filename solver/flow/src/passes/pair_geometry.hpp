// Geometry of eight pairs at once: particle i against eight slots of its neighbour row.
#pragma once

#include "parapet/flow/flow_arrays.hpp"
#include "simd.hpp"

namespace parapet::solver {

struct PairGeometry {
  v8d rx, rz;  // r_ij = r_i - r_j [m]
  v8d r2;      // [m2]
  v8d q;       // r/h
  v8d t;       // 1 - q/2, zero beyond the support
  v8d f;       // F = W'/r [1/m4], never positive
};

template <bool periodic>
PARAPET_INLINE PairGeometry pair_geometry(const FlowConstants& c, double xi, double zi, v8d xj,
                                          v8d zj) {
  PairGeometry g;
  g.rx = splat(xi) - xj;
  g.rz = splat(zi) - zj;
  if constexpr (periodic) {
    // nearest image; the ghost is left where it is, far outside either way
    const v8d length = splat(c.periodic_length);
    const v8d half = splat(0.5 * c.periodic_length);
    const v8m above = g.rx > half;
    const v8m below = g.rx < -half;
    g.rx -= (v8d)((v8m)length & above);
    g.rx += (v8d)((v8m)length & below);
  }
  g.r2 = g.rx * g.rx + g.rz * g.rz;
  g.q = sqrt_lanes(g.r2) * splat(c.kernel.inverse_h);
  g.t = kernel_falloff(g.q);
  g.f = kernel_f(c.kernel, g.t);
  return g;
}

template <bool periodic>
PARAPET_INLINE PairGeometry pair_geometry(const FlowConstants& c, const double* x, const double* z,
                                          double xi, double zi, const std::int32_t* index) {
  return pair_geometry<periodic>(c, xi, zi, gather(x, index), gather(z, index));
}

// Keeps r_ij/r^2 finite for padded slots and coincident points [m2]; (1e-6 h)^2.
PARAPET_INLINE v8d safe_r2(const FlowConstants& c, v8d r2) {
  return r2 + splat(1e-12 * c.smoothing_length * c.smoothing_length);
}

// Calls the periodic or the plain version of a pass.
#define PARAPET_PASS(name, ...) \
  (a.constants.periodic_length > 0.0 ? name<true>(__VA_ARGS__) : name<false>(__VA_ARGS__))

}  // namespace parapet::solver
