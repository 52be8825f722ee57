#include "parapet/flow/rheology.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::solver {

double apparent_viscosity(const Material& material, double shear_rate) {
  const bool newtonian = material.yield_stress == 0.0 && material.flow_index == 1.0;
  if (newtonian) return material.consistency;
  const double g = std::max(shear_rate, material.cutoff_shear_rate);
  return material.yield_stress / g + material.consistency * std::pow(g, material.flow_index - 1.0);
}

double still_rate2(const Material& material) {
  const double slower = material.cutoff_shear_rate / 0.1;  // than Table 1's
  return 1e-12 * (slower * slower);
}

double viscous_quadrature(double pp, double pq, double qq, double a, double b, double still2) {
  constexpr double full_support = 0.97;  // smallest (P + Q)/2 of a complete neighbourhood
  const double support = 0.5 * (pp + qq);
  const double strain2 = a * a + b * b + still2;  // at rest: the isotropic value
  const double discrete = a * a * pp + 2.0 * a * b * pq + b * b * qq + still2 * support;
  if (!(discrete > 0.0)) return 1.0;
  return std::clamp(strain2 / discrete * std::min(1.0, support / full_support), 0.5, 2.0);
}

}  // namespace parapet::solver
