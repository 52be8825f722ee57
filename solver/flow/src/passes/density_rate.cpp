// Density rate of Eq. 6 with the delta diffusion of Eq. 7 (Antuono et al. 2010), and what the
// shifting du exchanges between the particles (after Antuono et al. 2021, J. Comput. Phys. 436,
// 110263: delta-ALE-SPH). A particle that moves with u + du leaves mass behind and takes other:
//   dm_i/dt = V_i sum f_ij,  f_ij = (rho_i du_i + rho_j du_j) . grad W V_j,
// opposite and equal for the pair; the mass carries the pair's mean velocity, which keeps the
// momentum and, in the sum over a pair, the kinetic energy. The volume follows the motion,
// dV/dt = V <div(u + du)>.
// What the exchange does to the masses a diffusion levels out (as there, their D^m), pairwise too:
//   dm_i/dt = (2 kappa/dx^2) V_i sum (m_j - m_i) |F| V_j, kappa = 0.05 h u_max.
// The density stays as it is: the volume comes with the mass.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

template <bool periodic>
void rates_of(const FlowArrays& a, const ShiftedRates& out, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0), half = splat(0.5);
  const v8d levelling = splat(-2.0 * c.mass_diffusivity / c.even_volume);
  const v8d diffusivity = splat(c.density_diffusion * c.smoothing_length * c.sound_speed);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    v8d divergence = zero, diffusion = zero, flux = zero, ex = zero, ez = zero, spread = zero;
    v8d levelled = zero;
    const v8d x = group.load(f.x), z = group.load(f.z);
    const v8d ui = group.load(f.u), wi = group.load(f.w), rho_i = group.load(f.density);
    const v8d shift_x = group.load(f.shift_u), shift_z = group.load(f.shift_w);
    const v8d carried_x = rho_i * shift_x, carried_z = rho_i * shift_z;
    const v8d volume = group.load(f.volume), mass = rho_i * volume;
    const v8d grad_x = group.load(f.density_grad_x), grad_z = group.load(f.density_grad_z);
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const auto shift = gather(f.shift, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      const v8d fv = g.f * state.volume;
      const v8d du = motion.u - ui, dw = motion.w - wi, rho_j = state.density;
      divergence += fv * (du * g.rx + dw * g.rz);
      const v8d sx = shift.shift_u, sz = shift.shift_w;
      spread += fv * ((sx - shift_x) * g.rx + (sz - shift_z) * g.rz);
      const v8d pair = fv * ((carried_x + rho_j * sx) * g.rx + (carried_z + rho_j * sz) * g.rz);
      const v8d even = levelling * fv * (rho_j * state.volume - mass);
      flux += pair;
      levelled += even;
      ex += (pair + even) * du;
      ez += (pair + even) * dw;
      // (r_j - r_i) . grad W / r^2 = -F
      const v8d along =
          (grad_x + shift.density_grad_x) * g.rx + (grad_z + shift.density_grad_z) * g.rz;
      diffusion -= (splat(2.0) * (rho_j - rho_i) + along) * fv;
    }
    for (const std::int32_t* k = row.wall; k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      // The wall only stops the flow across it. Along it the point goes with the particle: the
      // tangential part vanishes in the integral, but its sum over discrete points does not and
      // would make the pressure of sheared particles jump as they pass from point to point.
      const auto face = gather(a.wall.face, k);
      const v8d nx = face.normal_x, nz = face.normal_z, behind = place.volume;
      const v8d across = (ui - face.u) * nx + (wi - face.w) * nz;
      divergence -= g.f * behind * across * (nx * g.rx + nz * g.rz);
      spread -= splat(2.0) * g.f * behind * (shift_x * g.rx + shift_z * g.rz);
    }
    const v8d rate = flux - rho_i * (divergence + spread);
    group.store(out.density_rate, rate + diffusivity * diffusion);
    group.store(out.mass_rate, volume * (flux + levelled));
    group.store(out.exchange_x, half * volume * ex);
    group.store(out.exchange_z, half * volume * ez);
  }
}

}  // namespace

void density_rate(const FlowArrays& a, const ShiftedRates& rates, int begin, int end) {
  PARAPET_PASS(rates_of, a, rates, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
