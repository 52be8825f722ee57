#include "parapet/flow/as_published.hpp"

#include <cmath>

#include "parapet/flow/index.hpp"
#include "parapet/flow/rheology.hpp"
#include "symmetric.hpp"

namespace parapet::solver {
namespace {

constexpr double lambda_surface =
    0.90 / paper_lattice_sum;  // Eq. 10: below it the free surface is in reach

Vec2 published_shift(Vec2 sum, double lambda, const ShiftingSettings& s) {
  if (is_spray(lambda) || s.factor == 0.0) return {};
  const Vec2 shift = (-2.0 * s.smoothing_length * s.max_speed * s.factor) * sum;  // Eq. 9
  const double size = norm(shift), cap = 0.5 * s.max_speed;
  return size > cap && size > 0.0 ? (cap / size) * shift : shift;  // Eq. 11
}

// Out of the fluid; zero where lambda does not vary.
Vec2 surface_normal(const Fluid& f, const FlowArrays& a, int i) {
  const FlowConstants& c = a.constants;
  const auto k = at(i);
  Symmetric tensor{0.0, 0.0, 0.0};
  Vec2 rise;
  const std::size_t group = at(i / lanes);
  for (int s = a.rows.begin[group] + i % lanes; s < a.rows.wall_begin[group]; s += lanes) {
    const std::int32_t neighbor = a.rows.index[s];
    if (neighbor >= f.n) continue;  // padding
    const auto j = at(neighbor);
    Vec2 r{f.x[k] - f.x[j], f.z[k] - f.z[j]};
    if (c.periodic_length > 0.0) {
      r.x -= c.periodic_length * std::round(r.x / c.periodic_length);
    }
    const double t = 1.0 - 0.5 * norm(r) * c.kernel.inverse_h;
    if (t <= 0.0) continue;
    const double fv = -c.kernel.f_scale * t * t * t * f.volume[j];
    tensor.xx -= fv * r.x * r.x;
    tensor.xz -= fv * r.x * r.z;
    tensor.zz -= fv * r.z * r.z;
    rise = rise + ((f.lambda[j] - f.lambda[k]) * fv) * r;
  }
  if (tensor.smallest_eigenvalue() > lambda_invertible) rise = tensor.solve(rise);
  const double size = norm(rise);
  return size > 0.0 ? (-1.0 / size) * rise : Vec2{};
}

}  // namespace

void published_pressure(Fluid& f, double c2, double reference_density, double background_pressure) {
  for (std::size_t i = 0; i < at(f.n); ++i) {
    f.pressure[i] = c2 * (f.density[i] - reference_density) + background_pressure;
    f.volume[i] = f.mass[i] / f.density[i];
  }
}

void finish_published_gradients(Fluid& f, const GradientSums& s, const ShiftingSettings& settings,
                                const Material& material, int begin, int end) {
  const double tan_phi = std::tan(material.friction_angle);
  for (int i = 0; i < end - begin; ++i) {
    const auto k = at(begin + i);
    const Symmetric all{s.bxx[i], s.bxz[i], s.bzz[i]};
    const Symmetric fluid{s.fluid_bxx[i], s.fluid_bxz[i], s.fluid_bzz[i]};
    f.lambda[k] = all.smallest_eigenvalue() / paper_lattice_sum;  // 1 on a lattice, as everywhere
    f.closeness[k] = s.bxx[i] + s.bzz[i];
    f.tic[k] = f.pressure[k] < 0.0 && f.lambda[k] > lambda_surface ? -1.0 : 1.0;
    const Vec2 shift = published_shift({s.shift_x[i], s.shift_z[i]}, f.lambda[k], settings);
    f.shift_u[k] = shift.x;
    f.shift_w[k] = shift.z;

    const Vec2 density_sum{s.density_x[i], s.density_z[i]};
    const bool invertible = fluid.smallest_eigenvalue() > lambda_invertible;
    const Vec2 gradient = invertible ? fluid.solve(density_sum) : Vec2{};
    f.density_grad_x[k] = gradient.x;
    f.density_grad_z[k] = gradient.z;

    const double shear = s.uz[i] + s.wx[i];  // 2 S:S = 2 (S_xx^2 + S_zz^2) + 4 S_xz^2
    f.shear_rate[k] = std::sqrt(2.0 * (s.ux[i] * s.ux[i] + s.wz[i] * s.wz[i]) + shear * shear);
    f.quadrature[k] = 1.0;
    const double yield =
        yield_stress_under(material, tan_phi, f.pressure[k] - settings.background_pressure);
    f.viscosity[k] = apparent_viscosity(material, yield, f.shear_rate[k], 1.0);
    f.pair_viscosity[k] = f.viscosity[k];
  }
}

void project_shift_at_surface(Fluid& f, const FlowArrays& arrays, int begin, int end) {
  for (int i = begin; i < end; ++i) {
    const auto k = at(i);
    if (is_spray(f.lambda[k]) || f.lambda[k] > lambda_surface) continue;
    const Vec2 shift{f.shift_u[k], f.shift_w[k]}, normal = surface_normal(f, arrays, i);
    const double outwards = dot(shift, normal);
    if (outwards < 0.0) continue;
    f.shift_u[k] -= outwards * normal.x;
    f.shift_w[k] -= outwards * normal.z;
  }
}

}  // namespace parapet::solver
