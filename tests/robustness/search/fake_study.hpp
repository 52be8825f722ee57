/// Studies whose simulations are formulas: everything of the study loop but the solver.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "parapet/study/study_run.hpp"
#include "program_runner.hpp"

namespace parapet::test {

/// Two variables a and h, each scaled to [0, 1], and two objectives to be minimised:
///   f1 = a^2 + h^2 (barrier_1_slam_force_n_per_m), f2 = (1 - a)^2 + h^2 (launch_length_m).
/// The Pareto set is h = 0, where sqrt(f1) + sqrt(f2) = 1.
/// A limit on retention_efficiency = 1 - h / 2 rules out h > 0.8; a formula a + h > 1.7.
designs::Json fake_study();

/// The same with the scenarios "soft" (weight 0.5), "usual" (0.3) and "stiff" (0.2), whose yield
/// stress s = 50, 100 and 200 Pa adds s / 1000 to f1.
designs::Json fake_study_with_scenarios();

designs::StudySpec parsed(const designs::Json& study);

double scaled_angle(const designs::Design& design);   // a
double scaled_height(const designs::Design& design);  // h

/// Stands in for the solver; may be copied, and then counts on together.
class FakeSimulator {
 public:
  struct Behaviour {
    bool delays = false;                                     ///< of random length, up to 3 ms
    std::function<bool(const designs::Design&)> fails = {};  ///< designs that fail
    int cancel_after = -1;  ///< simulations that end before all others are cancelled; -1: never
  };

  explicit FakeSimulator(Behaviour behaviour);
  FakeSimulator() : FakeSimulator(Behaviour{}) {}

  records::Simulation operator()(const study::SimulationTask& task,
                                 const solver::Callbacks& callbacks) const;

  int ended() const;                          ///< simulations that were not cancelled
  std::map<std::string, int> counts() const;  ///< by design, spacing and scenario
  std::function<bool()> cancelled() const;    ///< for Hooks

 private:
  struct State {
    Behaviour behaviour;
    std::mutex mutex;
    std::map<std::string, int> counts;
    int ended = 0;
    std::atomic<bool> cancelled = false;
  };
  std::shared_ptr<State> state_;
};

/// Runs a study with the fake simulator in a folder.
class FakeStudyTest : public ::testing::Test {
 protected:
  study::StudySummary run(const designs::StudySpec& study, const std::string& out,
                          const FakeSimulator& simulator, int jobs = 1);

  /// The same with any service; `cancelled` may be empty.
  study::StudySummary run(const designs::StudySpec& study, const std::string& out,
                          const study::ServiceFactory& service, std::function<bool()> cancelled,
                          int jobs);

  /// What the log says, by id, without measured times.
  std::map<std::string, designs::Json> records(const std::string& out) const;
  designs::Json json(const std::string& out, const std::string& file) const;
  int files(const std::string& out) const;  ///< in evaluations/

  TemporaryFolder folder;
};

}  // namespace parapet::test
