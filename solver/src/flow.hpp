// A flow being computed: particles, walls, neighbour rows and the terms of the equations. The two
// time integrations call the terms in their own order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fluid.hpp"
#include "geometry.hpp"
#include "neighbor_rows.hpp"
#include "parapet/solver/numerics.hpp"
#include "parapet/solver/result.hpp"
#include "passes/pass_table.hpp"
#include "stage_timer.hpp"
#include "viscous_solve.hpp"
#include "wall_layout.hpp"

namespace parapet::solver {

// Everything that defines a flow, in channel axes; not tied to channels.
struct FlowSetup {
  Numerics numerics;
  Material material;
  Vec2 gravity;  // [m/s2]
  // A^2 of a force -A^2 r towards the origin beside gravity, for drops without walls: the pressure
  // of wall points does not know it [1/s2].
  double central_force = 0.0;
  Solids solids;
  std::vector<InitialParticle> particles;
  int n_barriers = 0;
  WallSlip wall_slip = WallSlip::no_slip;
  double periodic_length = 0.0;            // along x [m]; 0: not periodic
  double outlet_x = 1e9, ceiling_z = 1e9;  // material beyond has left [m]
  const PassTable* passes = nullptr;       // nullptr: the fastest
  int threads = 1;
  StageTimer* timer = nullptr;  // told what the time goes into; nullptr: nobody wants to know
};

struct Failure {
  StopReason stop_reason;
  std::string reason;
};

// Impulse of the fluid on a barrier since the last reading, per metre width.
struct BarrierImpulse {
  Vec2 force;           // [N s/m]
  double moment = 0.0;  // about the foot, positive when it overturns downstream [N s]
};

// A particle that has left the domain.
struct Departure {
  std::int32_t id;
  double mass;  // [kg/m]
  double x;     // where it left [m]
};

class TimeIntegrator;

class Flow {
 public:
  explicit Flow(FlowSetup setup);
  ~Flow();
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  // Advances by one time step, no longer than `longest` [s]. Nothing when all went well.
  std::optional<Failure> step(double longest);

  double time() const { return time_; }
  double last_time_step() const { return dt_; }
  const Fluid& fluid() const { return fluid_; }
  const WallPoints& walls() const { return walls_; }
  const Solids& solids() const { return setup_.solids; }
  const FlowSetup& setup() const { return setup_; }
  const RunStatistics& statistics() const { return statistics_; }
  const std::vector<Departure>& departures() const { return departures_; }
  double left_mass() const { return left_mass_; }
  // Reads and clears the impulses since the last call, one for each barrier.
  std::vector<BarrierImpulse> take_impulses();
  // Particles inside a solid body, below the bed or behind the back wall.
  int particles_inside_walls() const;
  // Brings pressure (and, before the first step, viscosity) up to date with the state, for frames.
  void refresh();
  double smoothing_length() const;

  // The terms, for the time integrations. Those that visit pairs see places as of the last
  // prepare_neighbors, densities and pressures as of the last update_pressure.
  Fluid& fluid() { return fluid_; }
  void prepare_neighbors();   // rebuilds the rows when they are outdated
  void find_reached_pairs();  // among the rows' pairs; whenever particles have moved
  void update_pressure();     // Eq. 2 and the volumes
  void extrapolate_walls();   // the fluid's pressure and velocity at the wall points
  // Eq. 8-11, Eq. 13-15; the shifting velocity will be kept for `interval` [s]
  void update_gradients(double interval);
  void add_body_and_pressure_force(std::vector<double>& ax, std::vector<double>& az);
  void add_viscous_force(std::vector<double>& ax, std::vector<double>& az);
  bool solve_viscosity(const std::vector<double>& u_star, const std::vector<double>& w_star,
                       std::vector<double>& u, std::vector<double>& w, double dt);
  void update_density_rate();            // Eq. 6-7, with the shifting
  void measure_barrier_load(double dt);  // adds to the impulses
  FlowArrays arrays();                   // what the passes see, its records up to date
  int threads() const { return setup_.threads; }
  bool inviscid() const;

 private:
  std::optional<Failure> check_state();
  void stop_at_walls();
  FlowArrays packed_arrays();                   // with the records as they are
  void pack(void (Fluid::*records)(int, int));  // brings some of them up to date
  void remove_departed();

  FlowSetup setup_;
  const PassTable& passes_;
  WallPoints walls_;
  std::vector<double> load_x_, load_z_;  // [n_active]
  int first_barrier_point_ = 0;
  Fluid fluid_;
  NeighborRows rows_;
  std::vector<std::int32_t> reached_begin_, reached_wall_begin_, reached_end_, reached_index_;
  ViscousSolve viscous_;
  std::unique_ptr<TimeIntegrator> integrator_;
  std::vector<BarrierImpulse> impulses_;
  std::vector<Departure> departures_;
  std::vector<double> x_before_, z_before_, u_before_, w_before_;
  RunStatistics statistics_;
  double time_ = 0.0, dt_ = 0.0, max_speed_ = 0.0, max_acceleration_ = 0.0, left_mass_ = 0.0;
};

}  // namespace parapet::solver
