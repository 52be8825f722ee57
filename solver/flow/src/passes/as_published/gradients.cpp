// Scheme as_published: the tensor of Eq. 8 and 10, the density's gradient sum (Eq. 8), the shifting
// sum with the neighbours' volumes (Eq. 9) and the velocity gradient of Eq. 4 and 13. Walls without
// slip have their mirrored velocity. What the corrected scheme alone needs is not written.
#include "../pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA::as_published {
namespace {

struct Sums {
  v8d bxx, bxz, bzz;   // B
  v8d sx, sz;          // Eq. 9
  v8d ux, uz, wx, wz;  // velocity gradient
};

PARAPET_INLINE void add(const FlowConstants& c, Sums& m, const PairGeometry& g, v8d volume, v8d du,
                        v8d dw) {
  const v8d fv = g.f * volume, gx = fv * g.rx, gz = fv * g.rz;
  m.bxx -= gx * g.rx;
  m.bxz -= gx * g.rz;
  m.bzz -= gz * g.rz;
  const v8d ratio = kernel_w(c.kernel, g.q, g.t) * splat(1.0 / c.kernel.w_at_spacing);
  const v8d ratio2 = ratio * ratio;
  const v8d weight = splat(1.0) + splat(0.2) * (ratio2 * ratio2);  // R = 0.2, n = 4
  m.sx += weight * gx;
  m.sz += weight * gz;
  m.ux += du * gx;
  m.uz += du * gz;
  m.wx += dw * gx;
  m.wz += dw * gz;
}

template <bool periodic>
void sums_of(const FlowArrays& a, const GradientSums& out, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Group sums(i - begin, end - begin);  // where they stand in the range
    const Row row(a.rows, i);
    Sums m = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
    v8d rho_x = zero, rho_z = zero;
    const v8d x = group.load(f.x), z = group.load(f.z);
    const v8d u = group.load(f.u), w = group.load(f.w), rho = group.load(f.density);
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      add(c, m, g, state.volume, motion.u - u, motion.w - w);
      const v8d drho = (state.density - rho) * (g.f * state.volume);
      rho_x += drho * g.rx;
      rho_z += drho * g.rz;
    }
    sums.store(out.fluid_bxx, m.bxx);
    sums.store(out.fluid_bxz, m.bxz);
    sums.store(out.fluid_bzz, m.bzz);
    sums.store(out.density_x, rho_x);
    sums.store(out.density_z, rho_z);
    for (const std::int32_t* k = row.wall; k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      const v8d du = c.no_slip ? gather(a.wall.mirrored_u, k) - u : zero;
      const v8d dw = c.no_slip ? gather(a.wall.mirrored_w, k) - w : zero;
      add(c, m, g, place.volume, du, dw);
    }
    sums.store(out.bxx, m.bxx);
    sums.store(out.bxz, m.bxz);
    sums.store(out.bzz, m.bzz);
    sums.store(out.shift_x, m.sx);
    sums.store(out.shift_z, m.sz);
    sums.store(out.ux, m.ux);
    sums.store(out.uz, m.uz);
    sums.store(out.wx, m.wx);
    sums.store(out.wz, m.wz);
  }
}

}  // namespace

void gradient_sums(const FlowArrays& a, const GradientSums& sums, int begin, int end) {
  PARAPET_PASS(sums_of, a, sums, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA::as_published
