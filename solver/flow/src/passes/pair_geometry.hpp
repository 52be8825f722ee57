// Geometry of eight pairs at once: each particle of a group and its neighbour in one slot.
#pragma once

#include "parapet/flow/flow_arrays.hpp"
#include "simd.hpp"

namespace parapet::solver {

// The slots of a group of particles, eight indices each: [fluid, wall) hold fluid neighbours,
// [wall, end) wall points.
struct Row {
  const std::int32_t *fluid, *wall, *end;
  Row(const RowView& rows, int first_particle) {
    const int g = first_particle / lanes;
    fluid = rows.index + rows.begin[g];
    wall = rows.index + rows.wall_begin[g];
    end = rows.index + rows.end[g];
  }
};

struct PairGeometry {
  v8d rx, rz;  // r_ij = r_i - r_j [m]
  v8d r2;      // [m2]
  v8d q;       // r/h
  v8d t;       // 1 - q/2, zero beyond the support
  v8d f;       // F = W'/r [1/m4], never positive
};

// To the nearest image; the ghost is left where it is, far outside either way.
template <bool periodic>
PARAPET_INLINE v8d nearest(const FlowConstants& c, v8d rx) {
  if constexpr (periodic) {
    const v8d length = splat(c.periodic_length);
    const v8d half = splat(0.5 * c.periodic_length);
    const v8m above = rx > half;
    const v8m below = rx < -half;
    rx -= (v8d)((v8m)length & above);
    rx += (v8d)((v8m)length & below);
  }
  return rx;
}

template <bool periodic>
PARAPET_INLINE PairGeometry pair_geometry(const FlowConstants& c, v8d xi, v8d zi, v8d xj, v8d zj) {
  PairGeometry g;
  g.rx = nearest<periodic>(c, xi - xj);
  g.rz = zi - zj;
  g.r2 = g.rx * g.rx + g.rz * g.rz;
  g.q = sqrt_lanes(g.r2) * splat(c.kernel.inverse_h);
  g.t = kernel_falloff(g.q);
  g.f = kernel_f(c.kernel, g.t);
  return g;
}

// Keeps r_ij/r^2 finite for padded slots and coincident points [m2]; (1e-6 h)^2.
PARAPET_INLINE v8d safe_r2(const FlowConstants& c, v8d r2) {
  return r2 + splat(1e-12 * c.smoothing_length * c.smoothing_length);
}

// Without slip, the velocity of the fluid relative to the wall goes on linearly below the surface
// (Morris et al. 1997): velocity difference between a particle and a wall point over that between
// particle and surface. r leads from the point to the particle.
PARAPET_INLINE v8d linear_extension(const FlowConstants& c, v8d rx, v8d rz,
                                    const Lanes<FaceRecord>& face, v8d depth) {
  const v8d lowest = splat(0.2 * c.smoothing_length);
  const v8d height = rx * face.normal_x + rz * face.normal_z - depth;  // above the surface
  const v8d above = lowest + positive_part(height - lowest);
  return (above + depth) / above;
}

// Calls the periodic or the plain version of a pass.
#define PARAPET_PASS(name, ...) \
  (a.constants.periodic_length > 0.0 ? name<true>(__VA_ARGS__) : name<false>(__VA_ARGS__))

}  // namespace parapet::solver
