#include "parapet/flow/rheology.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::solver {

double apparent_viscosity(const Material& material, double shear_rate, double yield_fraction) {
  return apparent_viscosity(material, material.yield_stress, shear_rate, yield_fraction);
}

double apparent_viscosity(const Material& material, double yield_stress, double shear_rate,
                          double yield_fraction) {
  const bool newtonian = yield_stress == 0.0 && material.flow_index == 1.0;
  if (newtonian) return material.consistency;
  const double cutoff = material.cutoff_shear_rate, g = std::max(shear_rate, cutoff);
  const double plastic =
      yield_fraction * yield_stress / std::max(shear_rate, yield_fraction * cutoff);
  return plastic + material.consistency * std::pow(g, material.flow_index - 1.0);
}

double yield_fraction(double pair_rate, double gradient_rate, double wall_trace) {
  constexpr double least = 0.5;                 // a gradient misses modes that alternate
  constexpr double jump = 0.72, smooth = 0.90;  // of g/q
  constexpr double in_reach = 0.1;              // of the walls
  if (!(pair_rate > 0.0)) return 1.0;
  const double share = std::clamp(gradient_rate / pair_rate, least, 1.0);
  const double t = std::clamp((share - jump) / (smooth - jump), 0.0, 1.0);
  const double away = 1.0 - std::clamp(wall_trace / in_reach, 0.0, 1.0);
  return share + (1.0 - share) * (t * t * (3.0 - 2.0 * t)) * away;
}

double still_rate2(const Material& material) {
  const double slower = material.cutoff_shear_rate / 0.1;  // than Table 1's
  return 1e-12 * (slower * slower);
}

double viscous_quadrature(double pp, double pq, double qq, double a, double b, double still2) {
  constexpr double full_support = 0.99;  // smallest (P + Q)/2 of a complete neighbourhood
  const double support = 0.5 * (pp + qq);
  const double strain2 = a * a + b * b + still2;  // at rest: the isotropic value
  const double discrete = a * a * pp + 2.0 * a * b * pq + b * b * qq + still2 * support;
  if (!(discrete > 0.0)) return 1.0;
  return std::clamp(strain2 / discrete * std::min(1.0, support / full_support), 0.5, 2.0);
}

}  // namespace parapet::solver
