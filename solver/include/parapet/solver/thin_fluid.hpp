/// Fluids so thin that viscosity does not act from particle to particle, such as water, and the
/// settings that they are computed with (docs/theory.md, "Thin fluids").
#pragma once

#include "parapet/solver/numerics.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::solver {

/// Cell Reynolds number rho U dx/eta: U = c_s/10 is the largest speed that the numerics expect,
/// eta the material's largest viscosity (at the cut-off, or at U/dx where shear thickens it).
/// Infinite without viscosity, 0 where friction makes the viscosity grow with the pressure.
double cell_reynolds_number(const Numerics& numerics, const Material& material);

/// From this cell Reynolds number on a fluid counts as thin.
constexpr double thin_cell_reynolds_number = 5.0;

/// Whether the fluid is computed with the settings for thin fluids: the corrected scheme,
/// thin_fluid not off, and a cell Reynolds number of at least thin_cell_reynolds_number.
bool is_thin(const Numerics& numerics, const Material& material);

/// Whether sound is damped: in every fluid as thin as that, whatever thin_fluid says, but not in
/// the scheme as_published. Nothing else would end it.
bool damps_sound(const Numerics& numerics, const Material& material);

/// Where sound is damped, p = c_s^2 (rho - rho_0) + sound_damping h c_s drho/dt: a bulk viscosity
/// of sound_damping rho h c_s, which shear does not feel. A wave of number k decays at the rate
/// sound_damping h c_s k^2/2.
constexpr double sound_damping = 0.2;

/// The support of the kernel for thin fluids, h/dx; in place of the default alone.
constexpr double thin_smoothing_ratio = 1.5;

/// The numerics with the smoothing ratio that the fluid gets: a thin one has thin_smoothing_ratio
/// unless it was set to other than the default.
Numerics numerics_for(Numerics numerics, const Material& material);

}  // namespace parapet::solver
