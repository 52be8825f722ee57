// Scheme as_published, pressure part of Eq. 6: -(1/rho_i) sum (p_j + p_i) grad W V_j over fluid and
// walls alike, with the tensile-instability control of delta-plus-SPH (Sun et al. 2018).
#include "../pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA::as_published {
namespace {

template <bool periodic>
void force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    const v8d x = group.load(f.x), z = group.load(f.z);
    const v8d own = group.load(f.tic) * group.load(f.pressure);
    v8d sx = splat(0.0), sz = sx;
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      const v8d scale = (state.pressure + own) * (g.f * state.volume);
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    for (const std::int32_t* k = row.wall; k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      const v8d scale = (gather(a.wall.pressure, k) + own) * (g.f * place.volume);
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    const v8d factor = splat(-1.0) / group.load(f.density);
    group.store(ax, factor * sx);
    group.store(az, factor * sz);
  }
}

}  // namespace

void pressure_force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  PARAPET_PASS(force, a, ax, az, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA::as_published
