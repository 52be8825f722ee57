// Scheme as_published: the density rate of Eq. 6 with the delta diffusion of Eq. 7 (Antuono et al.
// 2010), and what shifting adds to the momentum, with the density inside the sums (Sun et al.
// 2019):
//   drho_i/dt = -rho_i sum [(u_j + du_j) - (u_i + du_i)] . grad W V_j
//               + sum (rho_j du_j + rho_i du_i) . grad W V_j + delta h c_s D_i
//   rho_i du_i/dt = ... + sum [u_j (rho_j du_j) + u_i (rho_i du_i)] . grad W V_j
//                   - u_i sum (rho_j du_j - rho_i du_i) . grad W V_j
// Masses are constant. The first of the momentum sums is opposite and equal in a pair, the second
// is not: momentum is kept in the limit only. Wall points have the velocity of the wall and are not
// shifted.
#include "../pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA::as_published {
namespace {

template <bool periodic>
void rates_of(const FlowArrays& a, const ShiftedRates& out, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0), two = splat(2.0);
  const v8d diffusivity = splat(c.density_diffusion * c.smoothing_length * c.sound_speed);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    v8d divergence = zero, diffusion = zero, flux = zero, spread = zero, mx = zero, mz = zero;
    const v8d x = group.load(f.x), z = group.load(f.z);
    const v8d u = group.load(f.u), w = group.load(f.w), rho = group.load(f.density);
    const v8d shift_x = group.load(f.shift_u), shift_z = group.load(f.shift_w);
    const v8d total_x = u + shift_x, total_z = w + shift_z;
    const v8d grad_x = group.load(f.density_grad_x), grad_z = group.load(f.density_grad_z);
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const auto shift = gather(f.shift, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      const v8d fv = g.f * state.volume, rho_j = state.density;
      const v8d sx = shift.shift_u, sz = shift.shift_w;
      divergence += fv * ((motion.u + sx - total_x) * g.rx + (motion.w + sz - total_z) * g.rz);
      const v8d there = fv * rho_j * (sx * g.rx + sz * g.rz);
      const v8d here = fv * rho * (shift_x * g.rx + shift_z * g.rz);
      flux += there + here;
      spread += there - here;
      mx += motion.u * there + u * here;
      mz += motion.w * there + w * here;
      // (r_j - r_i) . grad W / r^2 = -F
      const v8d along =
          (grad_x + shift.density_grad_x) * g.rx + (grad_z + shift.density_grad_z) * g.rz;
      diffusion -= (two * (rho_j - rho) + along) * fv;
    }
    for (const std::int32_t* k = row.wall; k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const auto face = gather(a.wall.face, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      const v8d fv = g.f * place.volume;
      divergence += fv * ((face.u - total_x) * g.rx + (face.w - total_z) * g.rz);
      const v8d here = fv * rho * (shift_x * g.rx + shift_z * g.rz);
      flux += here;
      spread -= here;
      mx += u * here;
      mz += w * here;
    }
    const v8d volume = group.load(f.volume);
    group.store(out.density_rate, flux - rho * divergence + diffusivity * diffusion);
    group.store(out.mass_rate, zero);
    group.store(out.exchange_x, volume * (mx - u * spread));
    group.store(out.exchange_z, volume * (mz - w * spread));
  }
}

}  // namespace

void density_rate(const FlowArrays& a, const ShiftedRates& rates, int begin, int end) {
  PARAPET_PASS(rates_of, a, rates, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA::as_published
