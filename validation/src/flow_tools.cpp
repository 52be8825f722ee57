#include "flow_tools.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "balance.hpp"

namespace parapet::validation {

using solver::Flow;
using solver::FlowSetup;
using solver::Fluid;
using solver::Vec2;

void add_wall(FlowSetup& setup, Vec2 a, Vec2 b) {
  const int body = static_cast<int>(setup.solids.bodies.size());
  setup.solids.bodies.push_back({});
  setup.solids.faces.push_back(solver::make_face(a, b, body, -1));
}

void add_periodic_wall(FlowSetup& setup, double length, double z, bool upwards, Vec2 velocity) {
  const double margin = 20.0 * setup.numerics.spacing;
  const Vec2 left{-margin, z}, right{length + margin, z};
  add_wall(setup, upwards ? left : right, upwards ? right : left);
  solver::Face& face = setup.solids.faces.back();
  face.points_from = margin;
  face.points_to = margin + length;
  face.velocity = velocity;
}

void advance(Flow& flow, double time, const CaseRun& run, Balance* balance) {
  constexpr double close = 1e-12;  // [s]
  while (time - flow.time() > close) {
    run.check_cancelled();
    if (const auto failure = flow.step(time - flow.time())) {
      throw std::runtime_error(failure->reason + " at t = " + std::to_string(flow.time()) + " s");
    }
    if (balance) balance->add_step(flow);
  }
}

void advance_sampled(Flow& flow, double end, double interval, const CaseRun& run,
                     const std::function<void(Flow&)>& sample, Balance* balance) {
  flow.refresh();
  sample(flow);
  const auto count = static_cast<long>(std::ceil(end / interval - 1e-9));
  for (long k = 1; k <= count; ++k) {
    advance(flow, std::min(end, static_cast<double>(k) * interval), run, balance);
    flow.refresh();
    sample(flow);
  }
}

Totals totals(const Flow& flow) {
  Totals t;
  const Fluid& f = flow.fluid();
  const Vec2 g = flow.setup().gravity;
  const double central = flow.setup().central_force;
  const double rho_0 = flow.setup().material.density, c = flow.setup().numerics.sound_speed;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
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

double fitted_order(std::span<const double> spacings, std::span<const double> errors) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(spacings.size());
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    const double x = std::log(spacings[k]), y = std::log(errors[k]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double rms_difference(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace parapet::validation
