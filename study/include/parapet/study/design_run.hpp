/// One design of a study: its simulations, one for each event, and their score.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/study/simulation_service.hpp"

namespace parapet::study {

/// A design that is being simulated, event by event.
class DesignRun {
 public:
  /// The study must outlive the run.
  DesignRun(const designs::StudySpec& study, designs::Design design, double spacing);

  /// The design, as given.
  const designs::Design& design() const { return design_; }

  /// Particle spacing [m].
  double spacing() const { return spacing_; }

  /// Number of events: the scenarios, or the base event.
  std::size_t size() const { return simulations_.size(); }

  /// The scenario of an event; null for the base event.
  const designs::Scenario* scenario(std::size_t event) const;

  /// What is to be simulated for an event.
  /// @param label for people; threads: that the simulation may use
  /// @throws designs::InputError when the scene is impossible
  SimulationTask task(std::size_t event, std::string label, int threads) const;

  /// Stores the simulation of an event.
  void set(std::size_t event, records::Simulation simulation);

  /// The simulation of an event; empty until it is set.
  const std::optional<records::Simulation>& simulation(std::size_t event) const {
    return simulations_[event];
  }

  /// The scored record, without id and stage, which the log gives. Every event must be set.
  /// A failed simulation or an objective without a value gives a failed record with the reason.
  records::EvaluationRecord record() const;

  /// Provenance, and with the base event alone what the simulator reported.
  designs::Json report(const records::ProgramInfo& program) const;

 private:
  void fail(records::EvaluationRecord& record, const std::string& reason) const;

  const designs::StudySpec& study_;
  designs::Design design_;
  double spacing_;
  std::vector<std::optional<records::Simulation>> simulations_;
};

/// Simulates every event of a design, as many side by side as the service has places; nothing else
/// may be under way there. Empty when it was cancelled.
/// @throws what went wrong in the service
std::optional<DesignRun> run_design(const designs::StudySpec& study, const designs::Design& design,
                                    double spacing, SimulationService& service);

}  // namespace parapet::study
