// Density rate of Eq. 6 with the delta diffusion of Eq. 7 (Antuono et al. 2010). What the shifting
// changes is added particle by particle (shifting.hpp).
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

template <bool periodic>
void rate_of(const FlowArrays& a, double* rate, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0);
  for (int i = begin; i < end; ++i) {
    v8d divergence = zero, diffusion = zero;
    const v8d ui = splat(f.u[i]), wi = splat(f.w[i]), rho_i = splat(f.density[i]);
    const v8d grad_x = splat(f.density_grad_x[i]), grad_z = splat(f.density_grad_z[i]);
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const PairGeometry g = pair_geometry<periodic>(c, f.x, f.z, f.x[i], f.z[i], j);
      const v8d fv = g.f * gather(f.volume, j);
      divergence += fv * ((gather(f.u, j) - ui) * g.rx + (gather(f.w, j) - wi) * g.rz);
      // (r_j - r_i) . grad W / r^2 = -F
      const v8d along = (grad_x + gather(f.density_grad_x, j)) * g.rx +
                        (grad_z + gather(f.density_grad_z, j)) * g.rz;
      diffusion -= (splat(2.0) * (gather(f.density, j) - rho_i) + along) * fv;
    }
    for (int s = a.rows.wall_begin[i]; s < a.rows.end[i]; s += lanes) {
      const std::int32_t* k = a.rows.index + s;
      const PairGeometry g = pair_geometry<periodic>(c, a.wall.x, a.wall.z, f.x[i], f.z[i], k);
      // The wall only stops the flow across it. Along it the point goes with the particle: the
      // tangential part vanishes in the integral, but its sum over discrete points does not and
      // would make the pressure of sheared particles jump as they pass from point to point.
      const v8d nx = gather(a.wall.normal_x, k), nz = gather(a.wall.normal_z, k);
      const v8d across = (ui - gather(a.wall.u, k)) * nx + (wi - gather(a.wall.w, k)) * nz;
      divergence -= g.f * gather(a.wall.volume, k) * across * (nx * g.rx + nz * g.rz);
    }
    rate[i] = -f.density[i] * sum_lanes(divergence) +
              c.density_diffusion * c.smoothing_length * c.sound_speed * sum_lanes(diffusion);
  }
}

}  // namespace

void density_rate(const FlowArrays& a, double* rate, int begin, int end) {
  PARAPET_PASS(rate_of, a, rate, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
