#include "parapet/flow/totals.hpp"

#include "parapet/flow/index.hpp"

namespace parapet::solver {

Totals totals(const Flow& flow) {
  Totals t;
  const Fluid& f = flow.fluid();
  const Vec2 g = flow.setup().gravity;
  const double central = flow.setup().central_force;
  const double rho_0 = flow.setup().material.density, c = flow.sound_speed();
  for (std::size_t i = 0; i < at(f.n); ++i) {
    const double m = f.mass[i], compression = f.density[i] / rho_0 - 1.0;
    t.mass += m;
    t.momentum = t.momentum + m * Vec2{f.u[i], f.w[i]};
    t.angular_momentum += m * (f.x[i] * f.w[i] - f.z[i] * f.u[i]);
    t.kinetic += 0.5 * m * (f.u[i] * f.u[i] + f.w[i] * f.w[i]);
    t.potential +=
        m * (0.5 * central * (f.x[i] * f.x[i] + f.z[i] * f.z[i]) - (g.x * f.x[i] + g.z * f.z[i]));
    t.elastic += 0.5 * m * c * c * compression * compression;
    t.dissipation += f.volume[i] * f.viscosity[i] * f.shear_rate[i] * f.shear_rate[i];
  }
  return t;
}

}  // namespace parapet::solver
