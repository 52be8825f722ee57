/// What is simulated: the channel, the released debris and the barriers. SI units, angles in rad.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/solver/vec2.hpp"

namespace parapet::solver {

/// Herschel-Bulkley debris, Eq. 12-15 of Huang et al. 2024; the defaults are Table 1.
struct Material {
  double density = 1135.0;         ///< rho_0 [kg/m3]
  double yield_stress = 90.0;      ///< tau_y [Pa]; with a friction angle the cohesion c
  double consistency = 4.526;      ///< K [Pa s^N]
  double flow_index = 0.795;       ///< N [-]
  double cutoff_shear_rate = 0.1;  ///< below it the viscosity stays constant [1/s]
  double friction_angle = 0.0;     ///< phi of tau_y = c + p tan phi, p >= 0 [rad]
  friend bool operator==(const Material&, const Material&) = default;
};

/// How the fluid meets a wall.
enum class WallSlip { no_slip, free_slip };

/// A plate on the crest of a stem that points upstream (the parapet).
struct Deflector {
  double angle = 0.0;     ///< above the world's horizontal [rad]; positive lifts the tip
  double length = 0.065;  ///< L_d, along the plate's lower face from the crest [m]
  friend bool operator==(const Deflector&, const Deflector&) = default;
};

/// One rigid barrier: a stem on the bed, with or without a deflector. The stem's upstream face
/// starts at (foot_x, 0); the thickness lies downstream of it.
struct Barrier {
  double foot_x = 1.1;       ///< foot of the upstream face, along the bed [m]
  double height = 0.1;       ///< length of the upstream face, foot to crest [m]
  double thickness = 0.015;  ///< of the stem and of the deflector [m]
  double stem_lean = 0.0;    ///< from the world's vertical, positive upstream [rad]; minus the
                             ///< channel's slope makes the stem normal to the bed
  std::optional<Deflector> deflector;
  friend bool operator==(const Barrier&, const Barrier&) = default;
};

/// A further solid body: vertices in counter-clockwise order [m], closed by the last edge.
struct SolidPolygon {
  std::vector<Vec2> vertices;
  friend bool operator==(const SolidPolygon&, const SolidPolygon&) = default;
};

/// A channel with a block of debris released behind a wall at x = 0.
/// Channel axes: gravity is g (sin slope, -cos slope).
struct Scene {
  double slope = 0.4537856055185257;  ///< of the bed [rad]; 26 deg
  double gravity = 9.81;              ///< [m/s2]
  double domain_length = 3.0;         ///< material beyond it has left, counted with its mass [m]
  double domain_height = 1.5;         ///< likewise above it [m]
  double reservoir_length = 0.3;      ///< of the released block along the bed [m]
  double reservoir_height = 0.2;      ///< of the released block, normal to the bed [m]
  double monitor_x = 1.1;             ///< where an open channel is gauged (no barrier) [m]
  WallSlip wall_slip = WallSlip::no_slip;
  Material material;
  std::vector<Barrier> barriers;     ///< from upstream to downstream
  std::vector<SolidPolygon> solids;  ///< anything else in the channel
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Direction of a stem from foot to crest, in channel axes (unit vector).
Vec2 stem_direction(const Scene& scene, const Barrier& barrier);

/// Direction of a deflector from the crest to its tip, in channel axes (unit vector).
Vec2 deflector_direction(const Scene& scene, const Deflector& deflector);

/// Outline of a barrier in channel axes [m]: upstream foot, crest, (deflector tip, tip of the upper
/// face, joint), downstream edge of the crest when bare, downstream foot. Clockwise in (x, z).
std::vector<Vec2> barrier_outline(const Scene& scene, const Barrier& barrier);

/// Drop from the top of the block to the bed at the first barrier, or at the gauge of an open
/// channel [m]: what its fastest debris can have fallen.
double drop_to_gauge(const Scene& scene);

/// Ten times the speed that debris reaches by then [m/s], as the upper limit of the sound speed:
/// 9.71 sqrt(2 g drop), friction leaving 0.971 of a free fall's speed; 35.0 for the default scene.
double usual_sound_speed(const Scene& scene);

/// Everything that makes the scene impossible to simulate, one sentence each, naming the field,
/// its value and what is allowed; empty when the scene is sound.
std::vector<std::string> scene_errors(const Scene& scene);

}  // namespace parapet::solver
