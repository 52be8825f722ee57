// Pressure part of Eq. 6: -(1/rho_i) sum (p_j + p_i) grad W V_j. Where the tensile-instability
// control acts (Sun et al. 2018: p_i < 0 inside the fluid) p_i changes sign.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {

template <bool periodic>
static void force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  for (int i = begin; i < end; ++i) {
    v8d sx = splat(0.0), sz = sx;
    const v8d own = splat(f.tic[i] * f.pressure[i]);
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], motion.x, motion.z);
      const v8d scale = (state.pressure + own) * (g.f * state.volume);
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    // a wall does not pull: surface particles under tension see it with no pressure of their own
    const double own_value = f.tic[i] * f.pressure[i];
    const v8d at_wall = splat(own_value > 0.0 ? own_value : 0.0);
    for (int s = a.rows.wall_begin[i]; s < a.rows.end[i]; s += lanes) {
      const std::int32_t* k = a.rows.index + s;
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], place.x, place.z);
      const v8d pressure = gather(a.wall.state, k).pressure;
      const v8d scale = (pressure + at_wall) * (g.f * place.volume);
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    const double factor = -1.0 / f.density[i];
    ax[i] = factor * sum_lanes(sx);
    az[i] = factor * sum_lanes(sz);
  }
}

void pressure_force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  PARAPET_PASS(force, a, ax, az, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
