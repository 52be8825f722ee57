#include "parapet/solver/thin_fluid.hpp"

#include <algorithm>
#include <limits>

#include "parapet/flow/rheology.hpp"

namespace parapet::solver {

double cell_reynolds_number(const Numerics& numerics, const Material& material) {
  if (material.friction_angle > 0.0) return 0.0;
  const double speed = numerics.sound_speed / sound_over_flow;
  const double thickest = std::max(apparent_viscosity(material, 0.0, 1.0),
                                   apparent_viscosity(material, speed / numerics.spacing, 1.0));
  return thickest > 0.0 ? material.density * speed * numerics.spacing / thickest
                        : std::numeric_limits<double>::infinity();
}

bool is_thin(const Numerics& numerics, const Material& material) {
  return numerics.thin_fluid == ThinFluid::automatic && damps_sound(numerics, material);
}

bool damps_sound(const Numerics& numerics, const Material& material) {
  return numerics.scheme == Scheme::corrected &&
         cell_reynolds_number(numerics, material) >= thin_cell_reynolds_number;
}

Numerics numerics_for(Numerics numerics, const Material& material) {
  if (is_thin(numerics, material) && numerics.smoothing_ratio == Numerics{}.smoothing_ratio) {
    numerics.smoothing_ratio = thin_smoothing_ratio;
  }
  return numerics;
}

}  // namespace parapet::solver
