// Density rate of Eq. 6 with the delta diffusion of Eq. 7 (Antuono et al. 2010) and the shifting
// terms of the continuity and momentum equations (Sun et al. 2019, density inside the sums).
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

struct RateSums {
  v8d divergence;              // sum ((u + du)_j - (u + du)_i) . grad W V_j
  v8d shift_flux;              // sum (rho_j du_j + rho_i du_i) . grad W V_j
  v8d shift_divergence;        // sum (du_j - du_i) . grad W V_j
  v8d momentum_x, momentum_z;  // sum (rho_j u_j (x) du_j + rho_i u_i (x) du_i) . grad W V_j
};

struct Neighbor {
  v8d u, w, shift_u, shift_w, density;
};

PARAPET_INLINE void add(RateSums& sums, const PairGeometry& g, v8d volume, const Neighbor& i,
                        const Neighbor& j) {
  const v8d fv = g.f * volume;
  const v8d gx = fv * g.rx, gz = fv * g.rz;
  sums.divergence +=
      (j.u + j.shift_u - i.u - i.shift_u) * gx + (j.w + j.shift_w - i.w - i.shift_w) * gz;
  const v8d flux_j = j.density * (j.shift_u * gx + j.shift_w * gz);
  const v8d flux_i = i.density * (i.shift_u * gx + i.shift_w * gz);
  sums.shift_flux += flux_j + flux_i;
  sums.shift_divergence += (j.shift_u - i.shift_u) * gx + (j.shift_w - i.shift_w) * gz;
  sums.momentum_x += j.u * flux_j + i.u * flux_i;
  sums.momentum_z += j.w * flux_j + i.w * flux_i;
}

template <bool periodic>
void rate_of(const FlowArrays& a, double* rate, double* shift_ax, double* shift_az, int begin,
             int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0);
  for (int i = begin; i < end; ++i) {
    RateSums sums = {zero, zero, zero, zero, zero};
    v8d diffusion = zero;
    const Neighbor own = {splat(f.u[i]), splat(f.w[i]), splat(f.shift_u[i]), splat(f.shift_w[i]),
                          splat(f.density[i])};
    const v8d grad_x = splat(f.density_grad_x[i]), grad_z = splat(f.density_grad_z[i]);
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const PairGeometry g = pair_geometry<periodic>(c, f.x, f.z, f.x[i], f.z[i], j);
      const v8d volume = gather(f.volume, j);
      const Neighbor other = {gather(f.u, j), gather(f.w, j), gather(f.shift_u, j),
                              gather(f.shift_w, j), gather(f.density, j)};
      add(sums, g, volume, own, other);
      // (r_j - r_i) . grad W / r^2 = -F
      const v8d along = (grad_x + gather(f.density_grad_x, j)) * g.rx +
                        (grad_z + gather(f.density_grad_z, j)) * g.rz;
      diffusion -= (splat(2.0) * (other.density - own.density) + along) * (g.f * volume);
    }
    for (int s = a.rows.wall_begin[i]; s < a.rows.end[i]; s += lanes) {
      const std::int32_t* k = a.rows.index + s;
      const PairGeometry g = pair_geometry<periodic>(c, a.wall.x, a.wall.z, f.x[i], f.z[i], k);
      // The wall only stops the flow across it. Along it the point goes with the particle: the
      // tangential part vanishes in the integral, but its sum over discrete points does not and
      // would make the pressure of sheared particles jump as they pass from point to point.
      const v8d nx = gather(a.wall.normal_x, k), nz = gather(a.wall.normal_z, k);
      const v8d across = (own.u - gather(a.wall.u, k)) * nx + (own.w - gather(a.wall.w, k)) * nz;
      const v8d shift_across = own.shift_u * nx + own.shift_w * nz;
      const Neighbor wall = {own.u - across * nx, own.w - across * nz,
                             own.shift_u - shift_across * nx, own.shift_w - shift_across * nz,
                             own.density};
      add(sums, g, gather(a.wall.volume, k), own, wall);
    }
    const double rho = f.density[i];
    rate[i] = -rho * sum_lanes(sums.divergence) + sum_lanes(sums.shift_flux) +
              c.density_diffusion * c.smoothing_length * c.sound_speed * sum_lanes(diffusion);
    const double shift_divergence = rho * sum_lanes(sums.shift_divergence);
    shift_ax[i] = (sum_lanes(sums.momentum_x) - f.u[i] * shift_divergence) / rho;
    shift_az[i] = (sum_lanes(sums.momentum_z) - f.w[i] * shift_divergence) / rho;
  }
}

}  // namespace

void density_rate(const FlowArrays& a, double* rate, double* shift_ax, double* shift_az, int begin,
                  int end) {
  PARAPET_PASS(rate_of, a, rate, shift_ax, shift_az, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
