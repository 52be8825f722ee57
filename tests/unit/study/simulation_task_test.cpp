// Tasks and outcomes travel as JSON text and come back the same to the bit.
#include "parapet/study/simulation_task.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "formula_study.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/simulation_json.hpp"
#include "parapet/study/simulator.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::SimulationTask;

/// No short decimal number is any of these.
const designs::Design design{
    {"height_m", 0.04 + 0.06 / 7.0}, {"deflector", 1.0}, {"angle_deg", 100.0 / 3.0}};

designs::StudySpec study_with_scenario() {
  Json json = formula_study();
  json["scenarios"] = Json::parse(R"([
    {"name": "soft", "weight": 1, "set": {"yield_stress_pa": 43.1}}])");
  json["scenarios"][0]["set"]["yield_stress_pa"] = 130.0 / 3.0;
  return designs::parse_study(json, "test");
}

template <typename T>
Json through_text(const T& value) {
  return Json::parse(to_json(value).dump());
}

bool same_bits(double a, double b) {
  // The bits are what is compared. NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(SimulationTaskJson, RoundTripGivesTheSameCaseToTheBit) {
  const designs::StudySpec study = study_with_scenario();
  const SimulationTask task =
      study::make_task(study, design, &study.scenarios[0], 0.1 / 9.0, "0003 soft", 2);
  const SimulationTask back = study::task_from_json(through_text(task));
  EXPECT_EQ(back.label, "0003 soft");
  EXPECT_EQ(back.design, design);
  EXPECT_EQ(back.scenario, "soft");
  EXPECT_EQ(back.threads, 2);
  EXPECT_TRUE(same_bits(back.spacing(), 0.1 / 9.0));
  EXPECT_EQ(back.spec.resolved.dump(), task.spec.resolved.dump());
  ASSERT_EQ(back.spec.scene.barriers.size(), 1U);
  EXPECT_TRUE(same_bits(back.spec.scene.barriers[0].height, design.at("height_m")));
  EXPECT_TRUE(same_bits(back.spec.scene.material.yield_stress, 130.0 / 3.0));
  EXPECT_EQ(back.key, task.key);
  EXPECT_EQ(to_json(back).dump(), to_json(task).dump());
}

TEST(SimulationTaskJson, KeyIsThatOfWhatDecidesTheResult) {
  const designs::StudySpec study = study_with_scenario();
  const auto task = [&](const designs::Design& of, double spacing, const char* label, int threads,
                        const designs::Scenario* scenario) {
    return study::make_task(study, of, scenario, spacing, label, threads);
  };
  const SimulationTask one = task(design, 0.01, "0001", 1, nullptr);
  EXPECT_EQ(one.key, records::case_hash(one.spec));
  EXPECT_EQ(one.key, task(design, 0.01, "0002", 4, nullptr).key);
  EXPECT_NE(one.key, task(design, 0.02, "0001", 1, nullptr).key) << "the spacing counts";
  EXPECT_NE(one.key, task(design, 0.01, "0001", 1, &study.scenarios[0]).key) << "the event too";
  designs::Design other = design;
  other["height_m"] = std::nextafter(other["height_m"], 1.0);
  EXPECT_NE(one.key, task(other, 0.01, "0001", 1, nullptr).key) << "every bit does";
}

TEST(SimulationTaskJson, ChangedOnTheWayItIsRefused) {
  const designs::StudySpec study = study_with_scenario();
  Json json = to_json(study::make_task(study, design, nullptr, 0.01, "0001", 1));
  json["case"]["numerics"]["spacing_m"] = 0.011;
  try {
    study::task_from_json(json);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("the task 0001 has the key"), std::string::npos);
  }
  json["format"] = "parapet-case/1";
  EXPECT_THROW(study::task_from_json(json), std::runtime_error);
}

TEST(SimulationTaskJson, AnImpossibleSceneGivesNoTask) {
  const designs::StudySpec study = study_with_scenario();
  EXPECT_THROW(
      study::make_task(study, {{"height_m", -1.0}, {"deflector", 0.0}}, nullptr, 0.01, "0001", 1),
      designs::InputError);
}

TEST(SimulationJson, RoundTripKeepsEveryBit) {
  records::Simulation simulation;
  simulation.ok = true;
  simulation.reason = "density \"range\"\nµ";
  simulation.metrics = {
      {"third", 1.0 / 3.0, ""},
      {"absent", std::nullopt, "nothing overflows", {}, solver::Absence::run_too_short},
      {"least", std::numeric_limits<double>::denorm_min(), ""},
      {"negative_zero", -0.0, ""},
      {"infinite", -std::numeric_limits<double>::infinity(), "because"},
      {"uncertain", 2.0, "",
       solver::MetricUncertainty{.expanded = 0.1,
                                 .discretisation = 0.2 / 3.0,
                                 .scatter = 0.03,
                                 .extrapolated = std::numeric_limits<double>::infinity(),
                                 .order = 1.7,
                                 .order_observed = true,
                                 .runs = 6,
                                 .level_spacing = {0.005, 0.01},
                                 .level_mean = {1.0 / 7.0, 2.0 / 7.0}}},
  };
  simulation.stop_reason = "end_time";
  simulation.wall_time = 0.1 + 0.2;
  simulation.cpu_time = 1e-300;
  simulation.particle_steps = 123456789012345.0;
  simulation.report = Json::parse(R"({"z": 1, "a": [0.1, null, -5, 18446744073709551615, 2.0]})");

  const records::Simulation back = records::simulation_from_json(through_text(simulation));
  EXPECT_TRUE(back.ok);
  EXPECT_FALSE(back.cancelled);
  EXPECT_EQ(back.reason, simulation.reason);
  EXPECT_EQ(back.stop_reason, simulation.stop_reason);
  ASSERT_EQ(back.metrics.size(), simulation.metrics.size());
  for (std::size_t k = 0; k < back.metrics.size(); ++k) {
    const solver::Metric &a = back.metrics[k], &b = simulation.metrics[k];
    EXPECT_EQ(a.key, b.key);
    EXPECT_EQ(a.absent_reason, b.absent_reason);
    ASSERT_EQ(a.value.has_value(), b.value.has_value()) << a.key;
    if (a.value) {
      EXPECT_TRUE(same_bits(*a.value, *b.value)) << a.key;
    }
  }
  const auto& uncertainty = back.metrics.back().uncertainty;
  ASSERT_TRUE(uncertainty.has_value());
  EXPECT_TRUE(same_bits(uncertainty->discretisation, 0.2 / 3.0));
  EXPECT_TRUE(std::isinf(uncertainty->extrapolated));
  EXPECT_TRUE(uncertainty->order_observed);
  EXPECT_EQ(uncertainty->runs, 6);
  EXPECT_EQ(uncertainty->level_spacing, (std::vector<double>{0.005, 0.01}));
  EXPECT_EQ(uncertainty->level_mean, (std::vector<double>{1.0 / 7.0, 2.0 / 7.0}));
  EXPECT_TRUE(same_bits(back.wall_time, simulation.wall_time));
  EXPECT_TRUE(same_bits(back.cpu_time, simulation.cpu_time));
  EXPECT_TRUE(same_bits(back.particle_steps, simulation.particle_steps));
  EXPECT_EQ(back.report.dump(), simulation.report.dump());
  EXPECT_EQ(records::to_json(back).dump(), records::to_json(simulation).dump());
}

TEST(SimulationJson, CancelledFailedAndNotANumberSurvive) {
  records::Simulation simulation;
  simulation.cancelled = true;
  EXPECT_TRUE(records::simulation_from_json(through_text(simulation)).cancelled);
  simulation = study::impossible_scene("no height");
  simulation.metrics = {{"broken", std::numeric_limits<double>::quiet_NaN(), ""}};
  const auto back = records::simulation_from_json(through_text(simulation));
  EXPECT_FALSE(back.ok);
  EXPECT_FALSE(back.cancelled);
  EXPECT_EQ(back.reason, "the scene is impossible: no height");
  EXPECT_TRUE(std::isnan(*back.metrics.front().value));
  EXPECT_TRUE(back.report.is_object());
  Json json = to_json(simulation);
  json["format"] = "parapet-simulation/1";
  EXPECT_THROW(records::simulation_from_json(json), std::runtime_error);
}

// The solver itself, there and back: what a worker on another machine would return.
TEST(SimulationJson, TheSolversOutcomeComesBackTheSame) {
  const designs::StudySpec study = designs::parse_study(formula_study(), "test");
  const SimulationTask task = study::make_task(study, design, nullptr, 0.02, "0001", 1);
  const auto here = study::solver_simulator()(task, {});
  ASSERT_TRUE(here.ok) << here.reason;
  const auto there = records::simulation_from_json(
      through_text(study::solver_simulator()(study::task_from_json(through_text(task)), {})));
  ASSERT_EQ(here.metrics.size(), there.metrics.size());
  for (std::size_t k = 0; k < here.metrics.size(); ++k) {
    EXPECT_EQ(here.metrics[k].key, there.metrics[k].key);
    EXPECT_EQ(here.metrics[k].value, there.metrics[k].value) << here.metrics[k].key;
    EXPECT_EQ(here.metrics[k].absent_reason, there.metrics[k].absent_reason);
  }
  EXPECT_EQ(here.particle_steps, there.particle_steps);
  EXPECT_EQ(here.report["case"].dump(), there.report["case"].dump());
  EXPECT_EQ(here.report["series"].dump(), there.report["series"].dump());
  EXPECT_EQ(here.report["simulation"]["mass"].dump(), there.report["simulation"]["mass"].dump());
}

}  // namespace
}  // namespace parapet::test
