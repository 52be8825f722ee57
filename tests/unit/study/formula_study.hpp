/// A study of a barrier with or without a deflector, and a stand-in for the solver.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "parapet/study/simulator.hpp"

namespace parapet::test {

/// Variables: height_m 0.04..0.1, the choice deflector (none, plate), angle_deg 0..60 with a plate
/// only. One objective (retention_efficiency, more is better), one limit (launch_length_m <= 0.5)
/// and a formula (height_m + angle_deg / 1000 <= 0.15).
designs::Json formula_study();

/// height_m and angle_deg scaled to 0..1; the angle is 0 without a plate.
double scaled_height(const designs::Design& design);
double scaled_angle(const designs::Design& design);
bool has_plate(const designs::Design& design);

/// What was asked of a simulator.
struct Asked {
  designs::Design design;
  double spacing;
  std::string scenario;
};

/// Metrics from formulas; copies share what was asked.
class FormulaSimulator {
 public:
  using Formula = std::function<double(const designs::Design& design)>;
  FormulaSimulator(Formula retention, Formula launch);

  records::Simulation operator()(const study::SimulationTask& task,
                                 const solver::Callbacks& callbacks) const;

  std::vector<Asked> asked() const;
  void cancel_after(int simulations);  ///< the next ones are cancelled
  void go_on();

 private:
  struct State {
    std::mutex mutex;
    std::vector<Asked> asked;
    int left = -1;
  };
  Formula retention_, launch_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

/// A folder of its own for each test, removed afterwards.
class FolderTest : public testing::Test {
 protected:
  FolderTest();
  ~FolderTest() override;
  std::filesystem::path folder;
};

}  // namespace parapet::test
