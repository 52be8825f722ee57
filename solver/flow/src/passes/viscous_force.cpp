// Viscous part of Eq. 6 in the form that conserves angular momentum (Monaghan and Gingold 1983):
// (1/rho_i) sum 8 eta_ij (u_ij . r_ij)/r_ij^2 grad W V_j, eta_ij = (eta_i + eta_j)/2,
// where 8 = 2(d + 2) makes the sum approximate div(2 eta S). Walls carry the particle's viscosity
// and its velocity continued linearly, as in the strain rate of the gradient pass: the force is
// that of the same slope.
#include "pair_geometry.hpp"
#include "passes.hpp"

namespace parapet::solver::PARAPET_ISA {
namespace {

constexpr double alpha = 8.0;

// With the strain rate of the pair sum (shifting.cpp) the arithmetic mean makes the power of the
// forces the summed dissipation of the particles; the harmonic mean of Eq. 6 belongs to no such
// sum.
PARAPET_INLINE v8d mean(v8d eta_i, v8d eta_j) {
  return splat(0.5) * (eta_i + eta_j);
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
      const auto face = gather(a.wall.face, k);
      const v8d ratio = linear_extension(c, g.rx, g.rz, face, place.depth);
      const v8d approach = ((u - face.u) * g.rx + (w - face.w) * g.rz) * ratio;
      const v8d scale = eta * (g.f * place.volume) * (approach / safe_r2(c, g.r2));
      sx += scale * g.rx;
      sz += scale * g.rz;
    }
    const v8d factor = splat(alpha) / group.load(f.density);
    group.store(ax, group.load(ax) + factor * sx);
    group.store(az, group.load(az) + factor * sz);
  }
}

// The same sum as a symmetric matrix for the implicit step: (M + dt A) u = M u* + wall part.
// A pair's block is s r r^T. What is kept of it is s alone, as a float: the product finds r again
// from the places that it fetches with the vector. Either side of a pair computes the same bits of
// s, and rounds them alike: the matrix stays symmetric, positive definite and momentum-conserving
// to the rounding of doubles, and as free of directions as the exact one. What the float costs is
// 6e-8 of a pair's viscosity.
// A wall's velocity is known, so that its points add to the particle's own block and to the
// right-hand side.
template <bool periodic>
void matrix(const FlowArrays& a, const ViscousView& v, int begin, int end) {
  const FlowConstants& c = a.constants;
  const FluidView& f = a.fluid;
  const v8d zero = splat(0.0), strength = splat(alpha * v.dt);
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
    for (const std::int32_t* k = row.wall; c.no_slip && k != row.end; k += lanes) {
      const auto place = gather(a.wall.place, k);
      const auto face = gather(a.wall.face, k);
      const PairGeometry g = pair_geometry<periodic>(c, x, z, place.x, place.z);
      const v8d weight = strength * eta * (volume * place.volume);
      const v8d ratio = linear_extension(c, g.rx, g.rz, face, place.depth);
      const v8d s = weight * ratio * (-g.f / safe_r2(c, g.r2));
      const v8d drive = s * (face.u * g.rx + face.w * g.rz);
      rx += drive * g.rx;
      rz += drive * g.rz;
      wxx += s * g.rx * g.rx;
      wxz += s * g.rx * g.rz;
      wzz += s * g.rz * g.rz;
    }
    const v8d mass = group.load(f.mass);
    const v8d own_xx = mass + wxx, own_zz = mass + wzz;
    group.store(v.wall_xx, own_xx);
    group.store(v.wall_xz, wxz);
    group.store(v.wall_zz, own_zz);
    group.store(v.diagonal_xx, own_xx + dxx);
    group.store(v.diagonal_xz, wxz + dxz);
    group.store(v.diagonal_zz, own_zz + dzz);
    group.store(v.rhs_x, rx);
    group.store(v.rhs_z, rz);
  }
}

template <bool periodic>
double product(const FlowArrays& a, const ViscousView& v, const MotionRecord* p, double* yx,
               double* yz, int begin, int end) {
  v8d sum = splat(0.0);
  for (int i = begin; i < end; i += lanes) {
    const Group group(i, end);
    const Row row(a.rows, i);
    const auto own = group.load(p);
    v8d sx = splat(0.0), sz = sx;
    const float* kept = v.strength + v.begin[i / lanes];
    for (const std::int32_t* j = row.fluid; j != row.wall; j += lanes, kept += lanes) {
      const auto other = gather(p, j);
      const v8d rx = nearest<periodic>(a.constants, own.x - other.x), rz = own.z - other.z;
      const v8d along = load(kept) * (rx * (own.u - other.u) + rz * (own.w - other.w));
      sx += along * rx;
      sz += along * rz;
    }
    const v8d wxz = group.load(v.wall_xz);
    sx += group.load(v.wall_xx) * own.u + wxz * own.w;
    sz += wxz * own.u + group.load(v.wall_zz) * own.w;
    group.store(yx, sx);
    group.store(yz, sz);
    sum += own.u * sx + own.w * sz;
  }
  return sum_lanes(sum);
}

}  // namespace

void viscous_force(const FlowArrays& a, double* ax, double* az, int begin, int end) {
  PARAPET_PASS(force, a, ax, az, begin, end);
}

void viscous_matrix(const FlowArrays& a, const ViscousView& v, int begin, int end) {
  PARAPET_PASS(matrix, a, v, begin, end);
}

double viscous_product(const FlowArrays& a, const ViscousView& v, const MotionRecord* p, double* yx,
                       double* yz, int begin, int end) {
  return PARAPET_PASS(product, a, v, p, yx, yz, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
