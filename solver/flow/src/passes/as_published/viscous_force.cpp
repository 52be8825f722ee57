// Scheme as_published, viscous part of Eq. 6 with alpha = 8 and the harmonic mean of the
// viscosities, in the form that conserves angular momentum:
// (1/rho_i) sum 8 eta_ij (u_ij . r_ij)/r_ij^2 grad W V_j, eta_ij = 2 eta_i eta_j/(eta_i + eta_j).
// A wall point has the viscosity of the particle and the mirrored velocity of Adami et al. 2012.
#include "../pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA::as_published {
namespace {

constexpr double alpha = 8.0;

// The padding's viscosity is zero, and so may be that of a fluid.
PARAPET_INLINE v8d mean(v8d eta_i, v8d eta_j) {
  constexpr double least = 1e-300;
  return splat(2.0) * eta_i * eta_j / (eta_i + eta_j + splat(least));
}

template <bool periodic>
void force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    v8d sx = splat(0.0), sz = sx;
    const v8d x = group.load(f.x), z = group.load(f.z), eta = group.load(f.pair_viscosity);
    const v8d u = group.load(f.u), w = group.load(f.w);
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      const v8d approach = (u - motion.u) * g.rx + (w - motion.w) * g.rz;
      const v8d scale =
          mean(eta, state.pair_viscosity) * (g.f * state.volume) * (approach / safe_r2(c, g.r2));
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    for (const std::int32_t* k = row.wall; c.no_slip && k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      const v8d approach =
          (u - gather(a.wall.mirrored_u, k)) * g.rx + (w - gather(a.wall.mirrored_w, k)) * g.rz;
      const v8d scale = eta * (g.f * place.volume) * (approach / safe_r2(c, g.r2));
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    const v8d factor = splat(alpha) / group.load(f.density);
    group.store(ax, group.load(ax) + factor * sx);
    group.store(az, group.load(az) + factor * sz);
  }
}

// The same sum as a matrix, as ../viscous_force.cpp has it. In it the particle's own velocity
// stands for the interpolated one at walls; the difference is lagged to the right-hand side:
// -s (u_i - m) = -2 s u_i(new) + s (u_i(old) + m). A steady state is that of the force above.
template <bool periodic>
void matrix(const FlowArrays& a, const ViscousView& v, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0), two = splat(2.0), strength = splat(alpha * v.dt);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    v8d dxx = zero, dxz = zero, dzz = zero;
    const v8d x = group.load(f.x), z = group.load(f.z), eta = group.load(f.pair_viscosity);
    const v8d volume = group.load(f.volume);
    float* kept = v.strength + v.begin[i / lanes];
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes, kept += lanes) {
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, motion.x, motion.z);
      const v8d weight = mean(eta, state.pair_viscosity) * (volume * state.volume);
      store(kept, strength * weight * (-g.f / safe_r2(c, g.r2)));
      const v8d s = load(kept);
      dxx += s * g.rx * g.rx;
      dxz += s * g.rx * g.rz;
      dzz += s * g.rz * g.rz;
    }
    v8d wxx = zero, wxz = zero, wzz = zero, rx = zero, rz = zero;
    const v8d u = group.load(f.u), w = group.load(f.w);
    for (const std::int32_t* k = row.wall; c.no_slip && k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      const v8d s = strength * eta * (volume * place.volume) * (-g.f / safe_r2(c, g.r2));
      const v8d lagged = s * ((u + gather(a.wall.mirrored_u, k)) * g.rx +
                              (w + gather(a.wall.mirrored_w, k)) * g.rz);
      rx += lagged * g.rx;
      rz += lagged * g.rz;
      wxx += s * g.rx * g.rx;
      wxz += s * g.rx * g.rz;
      wzz += s * g.rz * g.rz;
    }
    const v8d mass = group.load(f.mass);
    const v8d own_xx = mass + two * wxx, own_xz = two * wxz, own_zz = mass + two * wzz;
    group.store(v.wall_xx, own_xx);
    group.store(v.wall_xz, own_xz);
    group.store(v.wall_zz, own_zz);
    group.store(v.diagonal_xx, own_xx + dxx);
    group.store(v.diagonal_xz, own_xz + dxz);
    group.store(v.diagonal_zz, own_zz + dzz);
    group.store(v.rhs_x, rx);
    group.store(v.rhs_z, rz);
  }
}

}  // namespace

void viscous_force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  PARAPET_PASS(force, a, ax, az, begin, end);
}

void viscous_matrix(const FlowArrays& a, const ViscousView& v, int begin, int end) {
  PARAPET_PASS(matrix, a, v, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA::as_published
