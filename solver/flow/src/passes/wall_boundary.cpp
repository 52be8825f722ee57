// Generalised wall boundary (Adami, Hu and Adams 2012): wall points take the pressure of the fluid
// that they see, with the weight of the column between (their Eq. 27), and know the fluid's
// interpolated velocity, which no-slip mirrors (their Eq. 22-23).
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {

template <bool periodic>
static void extrapolate(const FlowArrays& a, int begin, int end) {
  const FlowConstants& c = a.constants;
  for (int s = begin; s < end; ++s) {
    const int k = a.rows.active_wall[s];
    v8d w_sum = splat(0.0), p_sum = w_sum, hx = w_sum, hz = w_sum, us = w_sum, ws = w_sum;
    for (int slot = a.rows.wall_point_begin[s]; slot < a.rows.wall_point_end[s]; slot += lanes) {
      const std::int32_t* index = a.rows.wall_point_index + slot;
      const auto motion = gather(a.fluid.motion, index);
      const auto state = gather(a.fluid.state, index);
      const PairGeometry g =
          pair_geometry<periodic>(c, a.wall.x[k], a.wall.z[k], motion.x, motion.z);
      const v8d w = kernel_w(c.kernel, g.q, g.t);
      const v8d rho_w = state.density * w;
      w_sum += w;
      p_sum += state.pressure * w;
      hx += rho_w * g.rx;
      hz += rho_w * g.rz;
      us += motion.u * w;
      ws += motion.w * w;
    }
    const double total = sum_lanes(w_sum);
    const double inverse = total > 0.0 ? 1.0 / total : 0.0;
    const double head = c.gravity_x * sum_lanes(hx) + c.gravity_z * sum_lanes(hz);
    const double p = (sum_lanes(p_sum) + head) * inverse;
    a.wall.state[k] = {.pressure = p > 0.0 ? p : 0.0,  // a wall does not pull
                       .fluid_u = sum_lanes(us) * inverse,
                       .fluid_w = sum_lanes(ws) * inverse,
                       .unused = 0.0};
  }
}

void extrapolate_walls(const FlowArrays& a, int begin, int end) {
  PARAPET_PASS(extrapolate, a, begin, end);
}

// Newton's third law for the pair forces of pressure_force and viscous_force, gathered at the wall.
template <bool periodic>
static void load(const FlowArrays& a, double* fx, double* fz, int begin, int end) {
  const FlowConstants& c = a.constants;
  for (int s = begin; s < end; ++s) {
    const int k = a.rows.active_wall[s];
    const WallState& state = a.wall.state[k];
    const double wall_u = 2.0 * a.wall.u[k] - state.fluid_u;
    const double wall_w = 2.0 * a.wall.w[k] - state.fluid_w;
    v8d sx = splat(0.0), sz = sx;
    for (int slot = a.rows.wall_point_begin[s]; slot < a.rows.wall_point_end[s]; slot += lanes) {
      const std::int32_t* index = a.rows.wall_point_index + slot;
      const PairGeometry g =
          pair_geometry<periodic>(c, a.fluid.x, a.fluid.z, a.wall.x[k], a.wall.z[k], index);
      const v8d fv = g.f * gather(a.fluid.volume, index) * splat(a.wall.volume[k]);
      v8d scale = fv * (splat(state.pressure) + positive_part(gather(a.fluid.tic, index) *
                                                              gather(a.fluid.pressure, index)));
      if (c.no_slip) {
        const v8d approach = (gather(a.fluid.u, index) - splat(wall_u)) * g.rx +
                             (gather(a.fluid.w, index) - splat(wall_w)) * g.rz;
        scale +=
            splat(8.0) * gather(a.fluid.pair_viscosity, index) * fv * (approach / safe_r2(c, g.r2));
      }
      // g.rx points from the fluid to the wall here
      sx -= scale * g.rx;
      sz -= scale * g.rz;
    }
    fx[s] = sum_lanes(sx);
    fz[s] = sum_lanes(sz);
  }
}

void wall_load(const FlowArrays& a, double* fx, double* fz, int begin, int end) {
  PARAPET_PASS(load, a, fx, fz, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
