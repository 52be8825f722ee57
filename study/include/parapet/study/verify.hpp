/// Whether the numbers of a folder come out again: stored simulations run once more and compared
/// bit by bit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "parapet/study/simulation_service.hpp"

namespace parapet::study {

/// A simulation that a folder holds: how it is made again, and what it gave.
struct StoredRun {
  std::string label;    ///< evaluation's id, with scenarios "ID SCENARIO"; or a row's
  std::string program;  ///< version and revision that made it; empty: not known
  std::function<SimulationTask()> task;  ///< @throws designs::InputError when it cannot be made
  /// Whether the simulation ended well; empty where the log of an earlier version does not tell it
  /// from a design that failed for want of an objective's value.
  std::optional<bool> ok;
  std::string reason;  ///< why it failed
  std::vector<solver::Metric> metrics;
};

/// Every simulation that a folder holds: a study's (evaluations.jsonl), a sweep's (rows/), or the
/// one of `parapet simulate` (result.json). Refused designs, of which nothing was simulated, are
/// left out.
/// @throws designs::InputError when the folder holds none of these, or what it holds is damaged
std::vector<StoredRun> stored_runs(const std::filesystem::path& folder);

/// A sentence for each damaged line and each file of a folder that is not what was written.
/// @throws designs::InputError when a study's folder cannot be read at all
std::vector<std::string> folder_damage(const std::filesystem::path& folder);

/// `count` of `total` indices, evenly spread, the first and the last among them; all when there are
/// no more.
std::vector<std::size_t> spread_sample(std::size_t total, std::size_t count);

/// One number that did not come out again.
struct Difference {
  std::string key;     ///< metric, "status", or "reason" of a failure
  std::string stored;  ///< as text with all its digits; "absent" without a value
  std::string now;
};

/// What came of a stored run.
struct VerifiedRun {
  std::size_t index = 0;  ///< of the stored run
  std::vector<Difference> differences;
};

/// Compares a stored run with its simulation of now.
std::vector<Difference> compare(const StoredRun& stored, const records::Simulation& now);

/// Simulates the chosen runs again, as many side by side as the service has places.
/// @param on_verified told of each as it ends
/// @return empty when it was cancelled
std::optional<std::vector<VerifiedRun>> verify_runs(
    const std::vector<StoredRun>& runs, const std::vector<std::size_t>& chosen,
    SimulationService& service, const std::function<void(const VerifiedRun&)>& on_verified);

}  // namespace parapet::study
