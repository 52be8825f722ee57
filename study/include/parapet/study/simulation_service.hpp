/// Who simulates: tasks are handed in, outcomes are fetched when they are there.
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include "parapet/records/simulation.hpp"
#include "parapet/solver/simulation.hpp"
#include "parapet/study/simulation_task.hpp"

namespace parapet::study {

/// What a service tells its user while it works, and how the user stops it. Called from the
/// service's threads, from several at once. Both may be empty.
struct ServiceHooks {
  /// Polled often; true ends what runs soon, and what waits at once: as cancelled simulations.
  std::function<bool()> cancelled;
  std::function<void(const SimulationTask& task, const solver::Progress& progress)> on_progress;
};

/// A simulation that has ended.
struct EndedSimulation {
  std::size_t ticket = 0;  ///< what submit() gave
  records::Simulation simulation;
  /// What went wrong in the service itself; the simulation means nothing then.
  std::exception_ptr failure = nullptr;
};

/// Simulates tasks side by side. An implementation needs of a task no more than its JSON, and of
/// the outcome no less than a records::Simulation's JSON, so that it may work on other machines.
///
/// One thread hands in and fetches. A task that cannot be simulated is a failed simulation with its
/// reason, not an exception; the same task gives the same metrics wherever it is simulated.
/// The destructor ends what still runs or waits, and waits for it; nobody learns of it.
class SimulationService {
 public:
  virtual ~SimulationService() = default;

  /// Tasks that run at once. More may be handed in: they wait, first come, first served.
  virtual int places() const = 0;

  /// Hands a task in and returns at once.
  /// @return the number of this submission, counted from 0
  virtual std::size_t submit(SimulationTask task) = 0;

  /// A simulation that has ended and was not fetched yet; empty when there is none at the moment.
  virtual std::optional<EndedSimulation> poll() = 0;

  /// The same, but waits for one. Something must have been handed in and not fetched.
  virtual EndedSimulation wait() = 0;
};

/// Opens a service with so many places. The hooks must stay valid while it lives.
using ServiceFactory =
    std::function<std::unique_ptr<SimulationService>(int places, ServiceHooks hooks)>;

}  // namespace parapet::study
