/// Runs one design: the only function of the solver that the rest of Parapet needs.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "parapet/solver/approach.hpp"
#include "parapet/solver/gauge_settings.hpp"
#include "parapet/solver/numerics.hpp"
#include "parapet/solver/result.hpp"
#include "parapet/solver/scene.hpp"
#include "parapet/solver/start_states.hpp"

namespace parapet::solver {

/// Stop early once no metric can change any more; with RunOptions::until_rest, once all is at rest.
struct SettledRule {
  bool enabled = true;
  /// The rules must hold this long with until_rest; otherwise half as long, and a sixteenth of the
  /// time so far [s].
  double window = 0.25;
  double retention_change = 0.002;  ///< largest change of any barrier's retention in the window
  /// Kinetic energy as a share of the largest seen: with until_rest of everything; otherwise half
  /// of that of the material that can still change a metric, without its fastest parcels
  /// (retention_change of the mass).
  double kinetic_energy_share = 1e-3;
  double earliest_time = 0.0;  ///< never before this time [s]
};

/// How long, how often sampled, on how many threads. Times are those of the flume of the default
/// scene; usual_run_options gives them for another.
struct RunOptions {
  double stop_time = 6.0;                ///< [s]
  double series_interval = 0.005;        ///< [s]
  double frame_interval = 0.0;           ///< [s]; 0 for none at regular times
  std::vector<double> frame_times = {};  ///< further times of frames, ascending [s]
  int threads = 1;                       ///< the answer does not depend on it
  bool profile = false;                  ///< measure where the time goes
  /// Go on until the whole flow is at rest, although no metric can change any more: for pictures,
  /// series and deposits.
  bool until_rest = false;
  /// The instant at which launch_tip_x_m and ramp_angle_deg are read [s]; 0: never.
  double reading_time = 0.0;
  SettledRule settled;
  GaugeSettings gauges;
  /// [n_barriers] the undisturbed flow at each barrier's foot, for the coefficients of the hand
  /// formulas; empty where it is not known.
  std::vector<Approach> approach = {};
};

/// The options with their times in the same ratio to sqrt(H0/g) as those of the default scene.
RunOptions usual_run_options(const Scene& scene);

/// Whether the options ask for frames at all.
inline bool frames_wanted(const RunOptions& options) {
  return options.frame_interval > 0.0 || !options.frame_times.empty();
}

/// One picture of the particles, valid during the callback. Arrays are [n_fluid] and [n_wall].
struct Frame {
  double time = 0.0;                       ///< [s]
  bool last = false;                       ///< the run ends with this state
  std::span<const double> x, z;            ///< position [m]
  std::span<const double> u, w;            ///< velocity [m/s]
  std::span<const double> density;         ///< [kg/m3]
  std::span<const double> pressure;        ///< [Pa]
  std::span<const double> viscosity;       ///< apparent [Pa s]
  std::span<const std::int32_t> id;        ///< of the particle at release
  std::span<const double> wall_x, wall_z;  ///< wall points [m]
  std::span<const double> mass;            ///< [kg/m]
};

/// How far a run is.
struct Progress {
  double time = 0.0;       ///< simulated [s]
  double stop_time = 0.0;  ///< [s]; a settled run ends before it
  std::int64_t steps = 0;
};

/// Optional hooks; all are called from the calling thread, between time steps.
struct Callbacks {
  std::function<bool(const Progress&)> on_progress;  ///< return false to cancel the run
  /// Called at exactly the times that the options ask for, interpolated between two steps where no
  /// step ends there, and once more with the last state of a run that ends well, also where its
  /// time was asked for. The run has the same bits with and without frames.
  std::function<void(const Frame&)> on_frame;
};

/// Simulates a scene.
/// Bitwise the same result for any number of threads. Any number of simulations may run side by
/// side in one process.
/// @throws std::invalid_argument when scene_errors, numerics_errors or run_errors is not empty.
/// A run that goes wrong does not throw: the result says Status::failed with its reason.
/// @param starts where designs share how their flows begin; the answer is the same without it
Result simulate(const Scene& scene, const Numerics& numerics, const RunOptions& options,
                const Callbacks& callbacks = {}, StartStates* starts = nullptr);

/// Everything wrong with the options, one sentence each.
std::vector<std::string> run_errors(const RunOptions& options);

}  // namespace parapet::solver
