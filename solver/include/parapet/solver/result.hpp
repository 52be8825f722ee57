/// What a simulation returns: a status, metrics, time series and an account of the mass.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/solver/profile.hpp"
#include "parapet/solver/vec2.hpp"

namespace parapet::solver {

/// A failed run is data, not an exception.
enum class Status { ok, failed, cancelled };

/// Why a run ended.
enum class StopReason {
  end_time,       ///< the stop time was reached
  metrics_final,  ///< no metric can change any more
  settled,        ///< everything is at rest (RunOptions::until_rest)
  drained,        ///< no fluid is left in the domain
  not_a_number,   ///< a particle's state became NaN or infinite
  runaway_speed,  ///< a speed above what the sound speed allows
  density_range,  ///< a density too far from rho_0
  time_step_collapse,
  viscous_solver,  ///< the conjugate gradients did not converge
  cancelled
};

/// The name as results spell it: "ok", "failed", "cancelled".
std::string_view to_string(Status status);

/// The same for the reason: "settled", "end_time", ...
std::string_view to_string(StopReason reason);

/// How far a metric can be trusted as a solution of the equations (not: of nature); in its unit.
struct MetricUncertainty {
  double expanded = 0.0;        ///< 95 %: root of discretisation^2 + (2 scatter)^2
  double discretisation = 0.0;  ///< half width of the band about the value that should hold the
                                ///< limit of fine spacings (see DiscretisationError)
  double scatter = 0.0;         ///< standard deviation between runs with a jittered lattice
  double extrapolated = 0.0;    ///< limit of fine spacings, as far as it can be told
  double order = 0.0;           ///< of convergence, observed or assumed
  bool order_observed = false;  ///< false: the runs are not in the asymptotic range
  int runs = 0;                 ///< that entered
  std::vector<double> level_spacing;  ///< [n_levels] particle spacing, finest first [m]
  std::vector<double> level_mean;     ///< [n_levels] mean of the runs there
};

/// Why a metric has no value.
enum class Absence {
  none,            ///< it has one
  does_not_exist,  ///< such as a launch length when nothing overflowed
  run_too_short,   ///< the run ended before it could be told
  too_coarse       ///< the particles do not resolve it
};

/// The word as results spell it: "does_not_exist", "run_too_short", "too_coarse"; "" for none.
std::string_view to_string(Absence absence);

/// The kind of that word; any other word is does_not_exist.
Absence absence_of(std::string_view word);

/// One scalar answer; metric_catalog.hpp says what each means. Keys carry their unit as a suffix; a
/// value that does not exist (the launch length when nothing overflows) is absent, with the reason.
struct Metric {
  std::string key;
  std::optional<double> value;
  std::string absent_reason;                          ///< empty when there is a value
  std::optional<MetricUncertainty> uncertainty = {};  ///< when it was asked for and can be told
  /// What kind of reason it is; one that is not known (old logs) counts as does_not_exist.
  Absence absence = Absence::none;
};

/// Time series sampled at the chosen interval: a table, one column per quantity.
struct Series {
  std::vector<std::string> columns;       ///< first is time_s; each key carries its unit
  std::vector<std::vector<double>> rows;  ///< [n_samples][n_columns]; NaN where not defined
};

/// Where the released mass is, per metre width [kg/m].
struct MassBalance {
  double released = 0.0;
  double in_domain = 0.0;
  double left_domain = 0.0;  ///< through the outlet or over the top
  std::int64_t particles_released = 0;
  std::int64_t particles_left = 0;
};

/// What the run cost and how the numerics behaved.
struct RunStatistics {
  std::int64_t steps = 0;
  std::int64_t neighbor_builds = 0;
  std::int64_t cg_iterations = 0;
  std::int64_t wall_contacts = 0;               ///< particles stopped at a wall by the contact rule
  std::int64_t max_particles_inside_walls = 0;  ///< over all samples; 0 in a sound run
  double mean_time_step = 0.0;                  ///< [s]
  double max_speed = 0.0;                       ///< [m/s]
  double max_density_error = 0.0;               ///< max |rho/rho_0 - 1|
  double wall_time = 0.0;  ///< [s]; alone in that it may differ between repeats (and the profile)
};

/// What the numerics of a run were like. Outside QualityLimits a result carries a warning.
struct Quality {
  /// Largest rise of kinetic and potential energy above their lowest sum before, until something
  /// has left the domain, over the released block's potential energy above the bed.
  double energy_gain_ratio = 0.0;
  double density_error_max = 0.0;  ///< max |rho/rho_0 - 1|, be it of a single droplet: no limit
  double mass_spread = 0.0;      ///< coefficient of variation of the particles' masses, at the end
  double spray_share_max = 0.0;  ///< largest share of the mass that had come off the fluid
  double wall_contacts_per_particle = 0.0;  ///< stopped at a wall by the contact rule
  /// Depth of the flow that meets the first barrier, front_clearance before it, in particle
  /// spacings; absent when none arrived, or in an open channel.
  std::optional<double> particles_across_approach;
  /// Largest density error that a hundredth of the mass exceeds at once (density_mass_share).
  double density_error_bulk = 0.0;
};

/// Beyond these a result warns.
struct QualityLimits {
  static constexpr double energy_gain_ratio = 0.05;
  static constexpr double density_error_bulk = 0.1;
  static constexpr double mass_spread = 0.15;
  static constexpr double spray_share_max = 0.6;
  static constexpr double wall_contacts_per_particle = 1.0;
  static constexpr double particles_across_approach = 4.0;  ///< at least
};

/// Something that a reader of the result must know; the run is not failed for it.
struct Warning {
  std::string key;     ///< member of Quality, or "stop_time"
  double value = 0.0;  ///< what was found
  double limit = 0.0;  ///< what is allowed
  std::string text;    ///< a sentence
  friend bool operator==(const Warning&, const Warning&) = default;
};

/// How the load on a part of a barrier is spread over its face, as the mean over the window of the
/// barrier's design load. Net: of all faces of the part, so that a flow behind it counts against
/// one before it.
struct LoadProfile {
  int barrier = 0;          ///< counted from 1, upstream first
  bool deflector = false;   ///< else the stem
  double window_end = 0.0;  ///< of the window of the design load [s]; negative: no force acted
  double window = 0.0;      ///< its length [s]
  Vec2 normal;  ///< of the part: the stem's downstream, the plate's out of its upper face
  /// [n + 1] ends of the strips along the part, one particle spacing long: from the stem's foot,
  /// from the plate's crest [m]. Strips at the ends hold what acts on the part's edges.
  std::vector<double> edge;
  std::vector<double> pressure;  ///< [n] part of the force along the normal, over the strip [Pa]
  double normal_force() const;   ///< the sum of pressure times length [N/m]
};

/// The answer of one simulation.
struct Result {
  Status status = Status::ok;
  StopReason stop_reason = StopReason::end_time;
  std::string reason;      ///< a sentence when the status is not ok
  double stop_time = 0.0;  ///< simulated [s]
  std::vector<Metric> metrics;
  Series series;
  MassBalance mass;
  RunStatistics statistics;
  Quality quality;
  std::vector<Warning> warnings;   ///< empty for a sound run
  std::optional<Profile> profile;  ///< when it was asked for
  std::vector<LoadProfile> loads;  ///< of each stem, and each deflector after its stem

  /// The metric of that key, or nullptr.
  const Metric* find_metric(std::string_view key) const;
};

}  // namespace parapet::solver
