// Viscous part of Eq. 6 in the form that conserves angular momentum (Monaghan and Gingold 1983):
// (1/rho_i) sum 8 eta_ij (u_ij . r_ij)/r_ij^2 grad W V_j, eta_ij = (eta_i + eta_j)/2,
// where 8 = 2(d + 2) makes the sum approximate div(2 eta S). Walls carry the particle's viscosity.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

constexpr double alpha = 8.0;

// With the strain rate of the pair sum (shifting.cpp) the arithmetic mean makes the forces the
// derivative of the summed dissipation; the harmonic mean of Eq. 6 belongs to no such sum.
PARAPET_INLINE v8d mean(v8d eta_i, v8d eta_j) {
  return splat(0.5) * (eta_i + eta_j);
}

template <bool periodic>
void force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  for (int i = begin; i < end; ++i) {
    v8d sx = splat(0.0), sz = sx;
    const v8d ui = splat(f.u[i]), wi = splat(f.w[i]), eta_i = splat(f.pair_viscosity[i]);
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], motion.x, motion.z);
      const v8d approach = (ui - motion.u) * g.rx + (wi - motion.w) * g.rz;
      const v8d scale =
          mean(eta_i, state.pair_viscosity) * (g.f * state.volume) * (approach / safe_r2(c, g.r2));
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    for (int s = a.rows.wall_begin[i]; c.no_slip && s < a.rows.end[i]; s += lanes) {
      const std::int32_t* k = a.rows.index + s;
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], place.x, place.z);
      const auto face = gather(a.wall.face, k);
      const auto state = gather(a.wall.state, k);
      const v8d wall_u = splat(2.0) * face.u - state.fluid_u;
      const v8d wall_w = splat(2.0) * face.w - state.fluid_w;
      const v8d approach = (ui - wall_u) * g.rx + (wi - wall_w) * g.rz;
      const v8d scale = eta_i * (g.f * place.volume) * (approach / safe_r2(c, g.r2));
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    const double factor = alpha / f.density[i];
    ax[i] += factor * sum_lanes(sx);
    az[i] += factor * sum_lanes(sz);
  }
}

// The same sum as a symmetric matrix for the implicit step: (M + dt A) u = M u* + wall part.
// At walls the own velocity stands for the mirrored one inside the matrix and the difference to
// Adami's interpolated velocity is lagged to the right-hand side, so that the matrix stays
// symmetric positive definite while a steady state is exactly that of viscous_force.
template <bool periodic>
void matrix(const FlowArrays& a, const ViscousView& v, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  for (int i = begin; i < end; ++i) {
    const v8d zero = splat(0.0);
    v8d dxx = zero, dxz = zero, dzz = zero;
    const v8d eta_i = splat(f.pair_viscosity[i]);
    const double strength = alpha * v.dt * f.volume[i];
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const auto motion = gather(f.motion, j);
      const auto state = gather(f.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], motion.x, motion.z);
      const v8d weight =
          splat(strength) * mean(eta_i, state.pair_viscosity) * (-g.f * state.volume);
      const v8d b = sqrt_lanes(weight / safe_r2(c, g.r2));
      const v8d bx = b * g.rx, bz = b * g.rz;
      store(v.bx + s, bx);
      store(v.bz + s, bz);
      dxx += bx * bx;
      dxz += bx * bz;
      dzz += bz * bz;
    }
    v8d wxx = zero, wxz = zero, wzz = zero, rx = zero, rz = zero;
    for (int s = a.rows.wall_begin[i]; c.no_slip && s < a.rows.end[i]; s += lanes) {
      const std::int32_t* k = a.rows.index + s;
      const auto place = gather(a.wall.place, k);
      const PairGeometry g = pair_geometry<periodic>(c, f.x[i], f.z[i], place.x, place.z);
      const v8d weight = splat(strength) * eta_i * (-g.f * place.volume) / safe_r2(c, g.r2);
      const auto face = gather(a.wall.face, k);
      const auto state = gather(a.wall.state, k);
      const v8d mirror_u = splat(2.0) * face.u - state.fluid_u;
      const v8d mirror_w = splat(2.0) * face.w - state.fluid_w;
      // -w (u_i - mirror) = -w 2 u_i(new) + w (u_i(old) + mirror)
      const v8d lagged =
          weight * ((splat(f.u[i]) + mirror_u) * g.rx + (splat(f.w[i]) + mirror_w) * g.rz);
      rx += lagged * g.rx;
      rz += lagged * g.rz;
      wxx += weight * g.rx * g.rx;
      wxz += weight * g.rx * g.rz;
      wzz += weight * g.rz * g.rz;
    }
    v.wall_xx[i] = v.mass[i] + 2.0 * sum_lanes(wxx);
    v.wall_xz[i] = 2.0 * sum_lanes(wxz);
    v.wall_zz[i] = v.mass[i] + 2.0 * sum_lanes(wzz);
    v.diagonal_xx[i] = v.wall_xx[i] + sum_lanes(dxx);
    v.diagonal_xz[i] = v.wall_xz[i] + sum_lanes(dxz);
    v.diagonal_zz[i] = v.wall_zz[i] + sum_lanes(dzz);
    v.rhs_x[i] = sum_lanes(rx);
    v.rhs_z[i] = sum_lanes(rz);
  }
}

}  // namespace

void viscous_force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  PARAPET_PASS(force, a, ax, az, begin, end);
}

void viscous_matrix(const FlowArrays& a, const ViscousView& v, int begin, int end) {
  PARAPET_PASS(matrix, a, v, begin, end);
}

double viscous_product(const FlowArrays& a, const ViscousView& v, const Pair* p, Pair* y, int begin,
                       int end) {
  double product = 0.0;
  for (int i = begin; i < end; ++i) {
    v8d sx = splat(0.0), sz = sx;
    const v8d xi = splat(p[i].x), zi = splat(p[i].z);
    for (int s = a.rows.begin[i]; s < a.rows.wall_begin[i]; s += lanes) {
      const std::int32_t* j = a.rows.index + s;
      const v8d bx = load(v.bx + s), bz = load(v.bz + s);
      const TwoLanes p_j = gather_two(p, j);
      const v8d along = bx * (xi - p_j.x) + bz * (zi - p_j.z);
      sx += along * bx;
      sz += along * bz;
    }
    y[i].x = v.wall_xx[i] * p[i].x + v.wall_xz[i] * p[i].z + sum_lanes(sx);
    y[i].z = v.wall_xz[i] * p[i].x + v.wall_zz[i] * p[i].z + sum_lanes(sz);
    product += p[i].x * y[i].x + p[i].z * y[i].z;
  }
  return product;
}

}  // namespace parapet::solver::PARAPET_ISA
