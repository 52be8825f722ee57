// Sums behind the renormalised gradients (Eq. 8), the shifting velocity (Eq. 9) and the strain
// rate (Eq. 13), all in one visit of the pairs.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

struct Moments {
  v8d bxx, bxz, bzz;   // B
  v8d sx, sz;          // Eq. 9
  v8d ux, uz, wx, wz;  // velocity gradient
  v8d pp, pq, qq;      // fourth moments
  v8d approach2;
};

// One vector of neighbours: gradient fv * r, velocity difference (du, dw) = u_j - u_i. `count`: how
// many particles a neighbour stands for in Eq. 9.
PARAPET_INLINE void add(const FlowConstants& c, Moments& m, const PairGeometry& g, v8d volume,
                        v8d count, v8d du, v8d dw) {
  const v8d fv = g.f * volume;
  const v8d gx = fv * g.rx;
  const v8d gz = fv * g.rz;
  m.bxx -= gx * g.rx;
  m.bxz -= gx * g.rz;
  m.bzz -= gz * g.rz;
  const v8d ratio = kernel_w(c.kernel, g.q, g.t) * splat(1.0 / c.kernel.w_at_spacing);
  const v8d ratio2 = ratio * ratio;
  const v8d weight = splat(1.0) + splat(0.2) * (ratio2 * ratio2);  // R = 0.2, n = 4
  // Without V_j: particles are to be evenly spaced whatever mass they have come to carry.
  const v8d even = count * weight * g.f;
  m.sx += even * g.rx;
  m.sz += even * g.rz;
  m.ux += du * gx;
  m.uz += du * gz;
  m.wx += dw * gx;
  m.wz += dw * gz;
}

PARAPET_INLINE void add_fourth_moments(const FlowConstants& c, Moments& m, const PairGeometry& g,
                                       v8d volume, v8d du, v8d dw) {
  const v8d weight = -g.f * volume / safe_r2(c, g.r2);
  const v8d p = g.rx * g.rx - g.rz * g.rz;
  const v8d q = splat(2.0) * g.rx * g.rz;
  m.pp += weight * (p * p);
  m.pq += weight * (p * q);
  m.qq += weight * (q * q);
  const v8d approach = du * g.rx + dw * g.rz;
  m.approach2 += weight * (approach * approach);
}

template <bool periodic>
void sums_of(const FlowArrays& a, const GradientSums& out, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0), even_volume = splat(c.even_volume);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Group sums(i - begin, end - begin);  // where they stand in the range
    const Row row(a.rows, i);
    Moments m = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    v8d rho_x = zero, rho_z = zero;
    const v8d x = group.load(f.x), z = group.load(f.z);
    const v8d ui = group.load(f.u), wi = group.load(f.w), rho_i = group.load(f.density);
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      const v8d volume = state.volume, du = motion.u - ui, dw = motion.w - wi;
      add(c, m, g, volume, splat(1.0), du, dw);
      add_fourth_moments(c, m, g, volume, du, dw);
      const v8d drho = (state.density - rho_i) * (g.f * volume);
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
      // No-slip: the strain rate beside the wall is that of the slope between wall and particle.
      // Free slip shows no difference.
      v8d du = zero, dw = zero;
      if (c.no_slip) {
        const auto face = gather(a.wall.face, k);
        const v8d ratio = linear_extension(c, g.rx, g.rz, face, place.depth);
        du = (face.u - ui) * ratio;
        dw = (face.w - wi) * ratio;
      }
      const v8d volume = place.volume;
      add(c, m, g, volume, volume * splat(1.0 / c.even_volume), du, dw);
      if (c.no_slip) add_fourth_moments(c, m, g, volume, du, dw);
    }
    sums.store(out.bxx, m.bxx);
    sums.store(out.bxz, m.bxz);
    sums.store(out.bzz, m.bzz);
    sums.store(out.shift_x, even_volume * m.sx);
    sums.store(out.shift_z, even_volume * m.sz);
    sums.store(out.ux, m.ux);
    sums.store(out.uz, m.uz);
    sums.store(out.wx, m.wx);
    sums.store(out.wz, m.wz);
    sums.store(out.approach2, m.approach2);
    sums.store(out.moment_pp, m.pp);
    sums.store(out.moment_pq, m.pq);
    sums.store(out.moment_qq, m.qq);
  }
}

}  // namespace

void gradient_sums(const FlowArrays& a, const GradientSums& sums, int begin, int end) {
  PARAPET_PASS(sums_of, a, sums, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
