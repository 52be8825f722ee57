/// A flow of particles: set it up, step it, look at everything in it, or call the terms of its
/// equations one by one on particles of your own. `simulate` (parapet/solver/simulation.hpp) runs a
/// whole design with it; this is the door for those who verify the scheme or build other flows.
///
///     FlowSetup setup;                        // a pool of debris, 0.4 m long and 0.1 m deep
///     setup.numerics.spacing = 0.01;
///     setup.gravity = {0.0, -9.81};
///     setup.particles = lattice_block(0.0, 0.0, 0.4, 0.1, 0.01, setup.material.density);
///     add_wall(setup, {0.0, 0.0}, {0.4, 0.0});
///     add_wall(setup, {0.0, 0.5}, {0.0, 0.0});
///     add_wall(setup, {0.4, 0.0}, {0.4, 0.5});
///     Flow flow(setup);
///     while (flow.time() < 1.0) {
///       if (const auto failure = flow.step(1.0 - flow.time())) return failure->reason;
///     }
///     const double energy = totals(flow).kinetic;
///
/// The plane is (x, z); everything is per metre width, in SI units. A flow gives the same bits for
/// any number of threads and any instruction set; flows share nothing and may run side by side.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "parapet/flow/flow_state.hpp"
#include "parapet/flow/fluid.hpp"
#include "parapet/flow/geometry.hpp"
#include "parapet/flow/pass_table.hpp"
#include "parapet/flow/step_rows.hpp"
#include "parapet/flow/wall_layout.hpp"
#include "parapet/solver/numerics.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::solver {

class StageTimer;
class TimeIntegrator;
class ViscousSolve;

/// Along what the load on a load cell is told apart, in strips of one particle spacing. What acts
/// before its start or past its end counts for the strip there.
struct LoadAxis {
  Vec2 start, direction;                        ///< [m], unit vector
  double length = 0.0;                          ///< [m]; 0: not told apart
  int strips(double spacing) const;             ///< the last one may be shorter
  int strip(Vec2 place, double spacing) const;  ///< of a place; -1 without strips
};

/// Everything that defines a flow. channel_setup (channel.hpp) makes one from a scene, add_wall and
/// add_periodic_wall (walls.hpp) and add_outline (geometry.hpp) put solids into it.
struct FlowSetup {
  Numerics numerics;  ///< what a thin fluid gets in place of defaults (thin_fluid.hpp) Flow adds
  Material material;
  Vec2 gravity;  ///< [m/s2]
  /// A^2 of a force -A^2 r towards the origin beside gravity, for drops without walls: the pressure
  /// of wall points does not know it [1/s2].
  double central_force = 0.0;
  Solids solids;
  std::vector<InitialParticle> particles;  ///< [n_released]
  int n_barriers = 0;  ///< faces name a load cell in 0 .. n_barriers - 1, or none (-1)
  WallSlip wall_slip = WallSlip::no_slip;
  /// Whether the sound speed follows the flow between its floor and numerics.sound_speed.
  bool adapt_sound_speed = false;
  /// The one that the densities of the particles belong to [m/s]; 0: numerics.sound_speed.
  double start_sound_speed = 0.0;
  double periodic_length = 0.0;          ///< along x, from 0 [m]; 0: not periodic
  double outlet_x = 1e9;                 ///< material beyond it has left [m]
  double ceiling_z = 1e9;                ///< material above it has left [m]
  const PassTable* passes = nullptr;     ///< of numerics.scheme; nullptr: the fastest
  int threads = 1;                       ///< the answer does not depend on it
  StageTimer* timer = nullptr;           ///< is told what the time goes into; may be nullptr
  std::vector<LoadAxis> load_axes = {};  ///< of the first so many load cells
};

/// Everything wrong with a setup's particles, faces and threads, one sentence each; empty when they
/// are sound. The numerics have their own numerics_errors.
std::vector<std::string> setup_errors(const FlowSetup& setup);

/// Why a step could not be taken.
struct Failure {
  StopReason stop_reason;
  std::string reason;  ///< a sentence
};

/// Impulse of the fluid on a load cell since the last reading, per metre width.
struct BarrierImpulse {
  Vec2 force;           ///< [N s/m]
  double moment = 0.0;  ///< about the foot, positive when it overturns downstream [N s]
};

/// A flow being computed. It can neither be copied nor moved: a copy is a new flow of the particles
/// that the old one has now.
class Flow {
 public:
  /// @throws std::invalid_argument with all setup_errors when there are any.
  explicit Flow(FlowSetup setup);
  ~Flow();
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  /// Advances by one time step, no longer than `longest` > 0 [s]: the stable step, shortened so
  /// that a whole number of them covers `longest`.
  /// @return nothing when all went well; after a failure the flow is not to be used any more.
  std::optional<Failure> step(double longest);

  /// The state between two steps, as a copy. Impulses that were not read are not part of it.
  FlowState state() const;
  /// Goes on from a state of another flow: from here on every bit is what it would be there, as
  /// long as no particle comes near a solid that only one of the two has.
  /// @pre same material, numerics, particles at release and gravity; the other solids the same
  void resume(const FlowState& state);

  double time() const { return now_.time; }                 ///< [s]
  double last_time_step() const { return now_.time_step; }  ///< [s]; 0 before the first step
  double sound_speed() const { return now_.sound_speed; }   ///< of the equation of state now [m/s]
  /// What the run cost so far and how the numerics behaved.
  const RunStatistics& statistics() const { return now_.statistics; }

  /// The particles. Steps sort them anew and drop those that leave: `id` tells which is which.
  /// Pressure and volume are those of the last update_pressure, what belongs to gradients and
  /// rheology that of the last update_gradients; refresh() brings the former up to date.
  const Fluid& fluid() const { return fluid_; }
  /// The same to change: velocities, densities, masses; places with prepare_neighbors() after it.
  /// Whoever adds or takes away particles makes a new flow.
  Fluid& fluid() { return fluid_; }
  /// The wall points, which do not move.
  const WallPoints& walls() const { return walls_; }
  const Solids& solids() const { return setup_.solids; }  ///< of the setup
  const FlowSetup& setup() const { return setup_; }       ///< without the particles
  double smoothing_length() const;                        ///< h [m]
  bool inviscid() const;                                  ///< neither yield stress nor consistency
  bool as_published() const;                              ///< the scheme
  bool thin() const { return thin_; }                     ///< has the settings of thin_fluid.hpp
  int threads() const { return setup_.threads; }          ///< of the setup

  /// All that have left, in the order in which they left.
  const std::vector<Departure>& departures() const { return departures_; }
  double left_mass() const { return now_.left_mass; }      ///< of the departures [kg/m]
  double released_mass() const { return released_mass_; }  ///< of all particles at release [kg/m]
  /// Reads and clears the impulses since the last call, one for each load cell.
  std::vector<BarrierImpulse> take_impulses();
  /// The same forces by strip of the load axes: the strips of the first load cell, then those of
  /// the next, and so on [N s/m].
  std::vector<Vec2> take_strip_impulses();
  /// Number of particles inside a solid body, below the bed or behind the back wall.
  int particles_inside_walls() const;
  /// Brings pressure (and, before the first step, viscosity) up to date with the state.
  void refresh();

  /// Neighbours, pressures, wall state, gradients and rheology of the particles as they are now:
  /// prepare_neighbors, update_pressure, extrapolate_walls and update_gradients(0). Sorts the
  /// particles.
  void evaluate();

  // The terms, one by one; the time integrations call them in their own order. Those that visit
  // pairs see places as of the last prepare_neighbors, densities and pressures as of the last
  // update_pressure.

  /// Rebuilds the neighbour rows when a pair may have come within reach, which sorts the particles.
  void prepare_neighbors();
  /// Picks from the rows the pairs that the kernel reaches; whenever particles have moved.
  void find_reached_pairs();
  /// Equation of state (Eq. 2) and volumes. Spray is under no tension, and a particle that is alone
  /// has the reference density; as_published has neither rule.
  void update_pressure();
  /// The fluid's pressure at the wall points (Adami et al. 2012); as_published: and velocity.
  void extrapolate_walls();
  /// Renormalised gradients, shifting velocity and rheology (Eq. 8-11, 13-15).
  /// @param interval the shifting velocity will be kept that long [s]
  void update_gradients(double interval);
  /// What update_gradients starts from: the sums of all particles, with the wall state as it is.
  GradientSumArrays gradient_sums();
  /// Acceleration by pressure, gravity and the central force into ax, az, [n + 1] each [m/s2];
  /// what stood there is lost.
  void add_body_and_pressure_force(std::vector<double>& ax, std::vector<double>& az);
  /// Adds the viscous part of Eq. 6 to ax, az, [n + 1] each [m/s2].
  void add_viscous_force(std::vector<double>& ax, std::vector<double>& az);
  /// Implicit viscous step of length dt [s]: from the velocity after all other forces (u_star,
  /// w_star) to the one after it; u and w hold a guess first. All are [n + 1] [m/s].
  /// @return false when the conjugate gradients did not converge
  bool solve_viscosity(const std::vector<double>& u_star, const std::vector<double>& w_star,
                       std::vector<double>& u, std::vector<double>& w, double dt);
  /// Rates of density and mass, and the momentum that comes with the mass (Eq. 6-7 with shifting).
  void update_density_rate();
  /// Adds the fluid's present force over dt [s] to the impulses.
  void measure_barrier_load(double dt);
  /// What the passes see (pass_table.hpp): views of everything, its records up to date. Valid until
  /// the flow is next called.
  FlowArrays arrays();

 private:
  std::optional<Failure> check_state();
  void follow_flow();
  bool takes_over_pairs() const;  // whether the next step may, of the one before
  void renew_neighbors(bool keep_pairs);
  void stop_at_walls();
  void add_to_strip(int load_cell, Vec2 place, Vec2 impulse);
  FlowArrays packed_arrays();                   // with the records as they are
  void pack(void (Fluid::*records)(int, int));  // brings some of them up to date
  void remove_departed();

  FlowSetup setup_;
  const bool thin_, damps_sound_;
  const PassTable& passes_;
  Kernel kernel_;  // its gradient is exact on a square lattice, but for as_published
  WallPoints walls_;
  std::vector<double> load_x_, load_z_;  // [n_active]
  int first_barrier_point_ = 0;
  Fluid fluid_;
  NeighborRows rows_;
  StepRows step_rows_;
  std::unique_ptr<ViscousSolve> viscous_;
  std::unique_ptr<TimeIntegrator> integrator_;
  std::vector<BarrierImpulse> impulses_;
  std::vector<int> first_strip_;      // [n_load_axes] of each
  std::vector<Vec2> strip_impulses_;  // [n_strips]
  std::vector<Departure> departures_;
  std::vector<double> x_before_, z_before_, u_before_, w_before_;
  FlowProgress now_;
  double released_mass_ = 0.0;  // [kg/m]
};

}  // namespace parapet::solver
