#include "formula_study.hpp"

#include <unistd.h>

namespace parapet::test {

designs::Json formula_study() {
  return designs::Json::parse(R"({
    "format": "parapet-study/1",
    "name": "formulas",
    "case": {
      "name": "formulas",
      "channel": {"length_m": 1.2},
      "reservoir": {"length_m": 0.2, "height_m": 0.1},
      "barriers": [{"foot_x_m": 0.4, "height_m": 0.06,
                    "deflector": {"angle_deg": 30, "length_m": 0.04}}],
      "numerics": {"spacing_m": 0.01},
      "run": {"stop_time_s": 0.5}
    },
    "variables": {
      "height_m": {"lower": 0.04, "upper": 0.1, "targets": ["/barriers/0/height_m"]},
      "deflector": {"type": "choice", "options": {
        "none": {"remove": ["/barriers/0/deflector"]}, "plate": {}}},
      "angle_deg": {"lower": 0, "upper": 60, "targets": ["/barriers/0/deflector/angle_deg"],
                    "active_when": {"deflector": ["plate"]}}
    },
    "objectives": [{"metric": "retention_efficiency", "goal": "maximize"}],
    "constraints": [{"name": "reach", "metric": "launch_length_m", "upper": 0.5},
                    {"name": "stem", "expression": "height_m + angle_deg / 1000", "upper": 0.15}],
    "method": {"algorithm": "BAYESIAN", "max_evaluations": 40, "seed": 7}
  })");
}

double scaled_height(const designs::Design& design) {
  return (design.at("height_m") - 0.04) / 0.06;
}

double scaled_angle(const designs::Design& design) {
  const auto found = design.find("angle_deg");
  return found == design.end() ? 0.0 : found->second / 60.0;
}

bool has_plate(const designs::Design& design) {
  return design.at("deflector") == 1.0;
}

FormulaSimulator::FormulaSimulator(Formula retention, Formula launch)
    : retention_(std::move(retention)), launch_(std::move(launch)) {}

records::Simulation FormulaSimulator::operator()(const study::SimulationTask& task,
                                                 const solver::Callbacks&) const {
  records::Simulation simulation;
  const std::scoped_lock lock(state_->mutex);
  if (state_->left == 0) {
    simulation.cancelled = true;
    return simulation;
  }
  if (state_->left > 0) --state_->left;
  state_->asked.push_back({task.design, task.spacing(), task.scenario});
  simulation.ok = true;
  simulation.metrics = {{"retention_efficiency", retention_(task.design), ""},
                        {"launch_length_m", launch_(task.design), ""}};
  simulation.wall_time = 0.5;
  simulation.cpu_time = 1.0;
  simulation.particle_steps = 1000.0;
  return simulation;
}

std::vector<Asked> FormulaSimulator::asked() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->asked;
}

void FormulaSimulator::cancel_after(int simulations) {
  state_->left = simulations;
}

void FormulaSimulator::go_on() {
  state_->left = -1;
}

FolderTest::FolderTest() {
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  folder = std::filesystem::temp_directory_path() /
           (std::string("parapet_") + info->test_suite_name() + "_" + info->name() + "_" +
            std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
}

FolderTest::~FolderTest() {
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

}  // namespace parapet::test
