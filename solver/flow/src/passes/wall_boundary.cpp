// Generalised wall boundary (Adami, Hu and Adams 2012): wall points take the pressure of the fluid
// that they see, with the weight of the column between (their Eq. 27). What shears the fluid is the
// linear extension of pair_geometry.hpp.
#include "passes.hpp"
#include "wall_group.hpp"

namespace parapet::solver::PARAPET_ISA {

template <bool periodic>
static void extrapolate(const FlowArrays& a, int begin, int end) {
  const FlowConstants& c = a.constants;
  const v8d zero = splat(0.0), one = splat(1.0);
  for (int s = begin; s < end; s += lanes) {
    const WallGroup group(a.rows, s, end);
    const auto place = gather(a.wall.place, group.points);
    v8d w_sum = zero, p_sum = zero, hx = zero, hz = zero;
    for (const std::int32_t* j = group.fluid; j != group.fluid_end; j += lanes) {
      const auto motion = gather(a.fluid.motion, j);
      const auto state = gather(a.fluid.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, place.x, place.z, motion.x, motion.z);
      const v8d w = kernel_w(c.kernel, g.q, g.t);
      const v8d rho_w = state.density * w;
      w_sum += w;
      p_sum += state.pressure * w;
      hx += rho_w * g.rx;
      hz += rho_w * g.rz;
    }
    const v8d inverse = w_sum > zero ? one / w_sum : zero;
    const v8d head = splat(c.gravity_x) * hx + splat(c.gravity_z) * hz;
    const v8d p = positive_part((p_sum + head) * inverse);  // a wall does not pull
    for (int l = 0; l < group.count; ++l) a.wall.pressure[group.points[l]] = p[l];
  }
}

void extrapolate_walls(const FlowArrays& a, int begin, int end) {
  PARAPET_PASS(extrapolate, a, begin, end);
}

// Newton's third law for the pair forces of pressure_force and viscous_force, gathered at the wall.
template <bool periodic>
static void load(const FlowArrays& a, double* fx, double* fz, int begin, int end) {
  const FlowConstants& c = a.constants;
  for (int s = begin; s < end; s += lanes) {
    const WallGroup group(a.rows, s, end);
    const auto place = gather(a.wall.place, group.points);
    const auto face = gather(a.wall.face, group.points);
    const v8d pressure = gather(a.wall.pressure, group.points);
    v8d sx = splat(0.0), sz = sx;
    for (const std::int32_t* j = group.fluid; j != group.fluid_end; j += lanes) {
      const auto motion = gather(a.fluid.motion, j);
      const auto fluid = gather(a.fluid.state, j);
      const PairGeometry g = pair_geometry<periodic>(c, place.x, place.z, motion.x, motion.z);
      const v8d fv = g.f * fluid.volume * place.volume;
      v8d scale = fv * (pressure + positive_part(gather(a.fluid.tic, j) * fluid.pressure));
      if (c.no_slip) {
        const v8d ratio = linear_extension(c, -g.rx, -g.rz, face, place.depth);
        const v8d approach = ((motion.u - face.u) * g.rx + (motion.w - face.w) * g.rz) * ratio;
        scale += splat(8.0) * fluid.pair_viscosity * fv * (approach / safe_r2(c, g.r2));
      }
      // g.rx points from the fluid to the wall here
      sx -= scale * g.rx;
      sz -= scale * g.rz;
    }
    group.store(fx, sx);
    group.store(fz, sz);
  }
}

void wall_load(const FlowArrays& a, double* fx, double* fz, int begin, int end) {
  PARAPET_PASS(load, a, fx, fz, begin, end);
}

}  // namespace parapet::solver::PARAPET_ISA
