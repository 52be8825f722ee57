#include "parapet/flow/shifting.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/flow/rheology.hpp"
#include "parapet/solver/vec2.hpp"
#include "symmetric.hpp"

namespace parapet::solver {
namespace {

constexpr double lambda_interior =
    0.90 / paper_lattice_sum;  // Eq. 10: above it no edge is in reach

// Only where the fluid alone fills the support. At a free surface, where Eq. 10 keeps the
// tangential part, the sum is the hole of the missing neighbours, along the normal and at the cap
// of half the largest speed: what is left across it after the projection is no measure of disorder.
// At a wall the mass that a shifted particle leaves behind finds no neighbour to take it, and its
// weight would be lifted for nothing.
Vec2 shifting_velocity(Vec2 sum, double fluid_lambda, const ShiftingSettings& s) {
  if (fluid_lambda <= lambda_interior || s.factor == 0.0) return {};
  const Vec2 shift = (-2.0 * s.smoothing_length * s.max_speed * s.factor) * sum;  // Eq. 9
  const double size = norm(shift), cap = 0.5 * s.max_speed;
  return size > cap && size > 0.0 ? (cap / size) * shift : shift;  // Eq. 11
}

}  // namespace

void finish_gradients(Fluid& f, const GradientSums& s, const ShiftingSettings& settings,
                      const Material& material, int begin, int end) {
  const double tan_phi = std::tan(material.friction_angle);
  for (int i = 0; i < end - begin; ++i) {
    const auto k = static_cast<std::size_t>(begin + i);
    const Symmetric all{s.bxx[i], s.bxz[i], s.bzz[i]};
    const Symmetric fluid{s.fluid_bxx[i], s.fluid_bxz[i], s.fluid_bzz[i]};
    const double fluid_lambda = fluid.smallest_eigenvalue();
    f.lambda[k] = all.smallest_eigenvalue();
    f.closeness[k] = s.bxx[i] + s.bzz[i];
    const Vec2 shift = shifting_velocity({s.shift_x[i], s.shift_z[i]}, fluid_lambda, settings);
    f.tic[k] = f.pressure[k] < 0.0 && fluid_lambda > lambda_interior ? -1.0 : 1.0;
    f.shift_u[k] = shift.x;
    f.shift_w[k] = shift.z;

    const Vec2 density_sum{s.density_x[i], s.density_z[i]};
    const Vec2 gradient = fluid_lambda > lambda_invertible ? fluid.solve(density_sum) : Vec2{};
    f.density_grad_x[k] = gradient.x;
    f.density_grad_z[k] = gradient.z;

    Vec2 du{s.ux[i], s.uz[i]}, dw{s.wx[i], s.wz[i]};
    const Symmetric& tensor = settings.no_slip ? all : fluid;
    if (tensor.smallest_eigenvalue() > lambda_invertible) {
      du = tensor.solve(du);
      dw = tensor.solve(dw);
    }
    const double a = 0.5 * (du.x - dw.z), b = 0.5 * (du.z + dw.x);
    f.quadrature[k] =
        viscous_quadrature(s.moment_pp[i], s.moment_pq[i], s.moment_qq[i], a, b, settings.still2);
    // Not the modulus of the gradient above: the rate whose dissipation eta g^2 is that of the
    // particle's own viscous pair forces.
    f.shear_rate[k] = std::sqrt(4.0 * f.quadrature[k] * s.approach2[i]);
    // modulus of the part without divergence, which is all that pairs resist with
    const double modulus = 2.0 * std::sqrt(a * a + b * b);
    const double walls = settings.no_slip ? f.closeness[k] - (fluid.xx + fluid.zz) : 0.0;
    f.viscosity[k] =
        apparent_viscosity(material, yield_stress_under(material, tan_phi, f.pressure[k]),
                           f.shear_rate[k], yield_fraction(f.shear_rate[k], modulus, walls));
    f.pair_viscosity[k] = f.quadrature[k] * f.viscosity[k];
  }
}

}  // namespace parapet::solver
