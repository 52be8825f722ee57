/// How it is simulated: resolution and the constants of the delta-plus-SPH scheme.
#pragma once

#include <string>
#include <vector>

namespace parapet::solver {

/// The two time integrations; both solve the same equations.
enum class Integrator {
  implicit_viscosity,  ///< pressure explicit (symplectic), viscosity by conjugate gradients
  rk4_explicit         ///< the paper's fourth-order Runge-Kutta, everything explicit
};

/// The two spatial schemes.
enum class Scheme {
  corrected,    ///< with what Parapet adds to the paper's method (docs/theory.md)
  as_published  ///< Eq. 2-11 of the paper as they are, misprints mended
};

/// Whether a fluid that is thin enough gets settings of its own (thin_fluid.hpp). Off by default:
/// they are for vortices, and make the pressures of breaking waves worse.
enum class ThinFluid { automatic, off };

/// Sound speed over flow speed: the density then stays within about a per cent.
constexpr double sound_over_flow = 10.0;

/// Numerical settings; the defaults are those of the paper where it gives them.
struct Numerics {
  double spacing = 0.005;         ///< initial particle distance dx [m]
  double smoothing_ratio = 1.33;  ///< h/dx; the Wendland C2 support is 2h
  /// c_s [m/s], at least 10 x the largest speed; usual_sound_speed(scene) knows one for a channel.
  double sound_speed = 35.0;
  /// In a channel c_s follows the flow: 10 x the fastest particle that is not spray, at least this
  /// share of sound_speed and at most all of it. 1 keeps it constant, as rk4_explicit always does.
  double sound_speed_floor = 4.0 / 7.0;
  double density_diffusion = 0.1;  ///< delta of the density diffusion term, Eq. 6-7
  double shifting_factor = 1.0;    ///< scales the shifting velocity of Eq. 9; 0 switches it off
  double skin_ratio = 0.7;         ///< neighbour rows reach (2 + skin_ratio) h
  double cfl_acoustic = 0.0;       ///< dt <= cfl h / (c_s + u_max); 0 takes the integrator's own
  double cfl_force = 0.25;         ///< dt <= cfl sqrt(h / |a|max)
  double cfl_viscous = 0.125;      ///< dt <= cfl h^2 rho / eta_max (explicit viscosity only)
  double cg_tolerance = 0.5;       ///< residual of the viscous solve, as an acceleration [m/s2]
  int steps_per_solve = 3;         ///< acoustic steps for each step of viscosity and shifting
  int cg_max_iterations = 500;     ///< more than this is a failed run
  bool hydrostatic_start = true;   ///< the block starts with p = rho g cos(slope) depth
  double lattice_jitter = 0.0;     ///< random offset of the initial lattice, as a share of dx
  unsigned lattice_seed = 1;       ///< seed of that offset
  Integrator integrator = Integrator::implicit_viscosity;
  Scheme scheme = Scheme::corrected;
  double background_pressure = 0.0;       ///< P_0 of Eq. 2 [Pa]; as_published only
  ThinFluid thin_fluid = ThinFluid::off;  ///< corrected scheme only
  friend bool operator==(const Numerics&, const Numerics&) = default;
};

/// Everything wrong with the settings, one sentence each; empty when they are sound.
std::vector<std::string> numerics_errors(const Numerics& numerics);

}  // namespace parapet::solver
