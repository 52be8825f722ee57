/// pareto.json read again: the surrogate's estimates and the search's progress.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace parapet::study {

/// How much of the objectives' space was dominated after an evaluation.
struct FrontEntry {
  int evaluations = 0;
  double cpu_time = 0.0;     ///< of these evaluations [s]
  double hypervolume = 0.0;  ///< NaN where the file holds none
};

/// What the surrogate says of an objective at a design, in the objective's unit.
struct Estimate {
  std::optional<double> median, lower_95, upper_95;  ///< ends of the 95 % interval
};

/// What the surrogate says of a design; empty members: there is no surrogate.
struct DesignEstimates {
  std::string id;
  std::vector<Estimate> objectives;            ///< [n_objectives]
  std::optional<double> probability_feasible;  ///< that it meets every constraint
};

/// How well the surrogate of a metric, over design and event, predicts events that it has not seen
/// (see LeaveOneEventOut).
struct EventError {
  std::string metric;
  std::optional<double> rmse;         ///< in the metric's unit
  std::optional<double> q_squared;    ///< 1 - error variance over variance
  std::optional<double> coverage_95;  ///< share within 95 % intervals
};

/// What statistics over a distribution of events rest on.
struct EventBasis {
  int simulated = 0, drawn = 0, designs = 0;  ///< events, events of the statistics, designs
  std::vector<EventError> errors;
};

/// The content of pareto.json as types.
struct StoredFront {
  std::vector<DesignEstimates> designs;
  std::vector<std::optional<double>> reference;  ///< [n_objectives] in the objectives' units
  std::optional<double> hypervolume;
  std::vector<FrontEntry> history;
  std::optional<EventBasis> events = {};  ///< of a study with a distribution of events

  /// The estimates of a design; null when it is not on the front.
  const DesignEstimates* find(const std::string& id) const;
};

/// Reads pareto.json (format "parapet-pareto/1"). Empty when the file is missing, not whole, or of
/// another study: what it tells is a help and not needed.
std::optional<StoredFront> read_stored_front(const std::filesystem::path& file,
                                             const std::string& spec_hash);

}  // namespace parapet::study
