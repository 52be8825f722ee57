#include "fake_study.hpp"

#include <chrono>
#include <random>
#include <thread>

#include "tiny_specs.hpp"

namespace parapet::test {

using designs::Json;

Json fake_study() {
  Json study = tiny_study();
  study["name"] = "fake";
  // Nothing is simulated, but every design must give a scene: none too low to be resolved.
  study["case"]["numerics"]["spacing_m"] = 0.01;
  study["objectives"] = Json::parse(R"([
    {"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize"},
    {"metric": "launch_length_m", "goal": "minimize", "value_when_absent": 0}])");
  study["constraints"] = Json::parse(R"json([
    {"name": "corner", "expression": "deflector_angle_deg / 60 + (upstream_height_m - 0.04) / 0.06",
     "upper": 1.7},
    {"metric": "retention_efficiency", "lower": 0.6}])json");
  study["method"] = Json::parse(R"({"algorithm": "BAYESIAN", "max_evaluations": 14, "seed": 3})");
  return study;
}

Json fake_study_with_scenarios() {
  Json study = fake_study();
  study["scenarios"] = Json::parse(R"([
    {"name": "soft", "weight": 0.5, "set": {"yield_stress_pa": 50}},
    {"name": "usual", "weight": 0.3, "set": {"yield_stress_pa": 100}},
    {"name": "stiff", "weight": 0.2, "set": {"yield_stress_pa": 200}}])");
  return study;
}

designs::StudySpec parsed(const Json& study) {
  return designs::parse_study(study, "fake");
}

double scaled_angle(const designs::Design& design) {
  return design.at("deflector_angle_deg") / 60.0;
}

double scaled_height(const designs::Design& design) {
  return (design.at("upstream_height_m") - 0.04) / 0.06;
}

FakeSimulator::FakeSimulator(Behaviour behaviour) : state_(std::make_shared<State>()) {
  state_->behaviour = std::move(behaviour);
}

records::Simulation FakeSimulator::operator()(const study::SimulationTask& task,
                                              const solver::Callbacks&) const {
  records::Simulation simulation;
  if (state_->behaviour.delays) {
    thread_local std::mt19937_64 generator(std::random_device{}());
    std::this_thread::sleep_for(std::chrono::microseconds(generator() % 3000));
  }
  const std::scoped_lock lock(state_->mutex);
  if (state_->behaviour.cancel_after == state_->ended) state_->cancelled = true;
  if (state_->cancelled) {
    simulation.cancelled = true;
    return simulation;
  }
  ++state_->ended;
  ++state_->counts[Json(task.design).dump() + std::to_string(task.spacing()) + task.scenario];
  const double a = scaled_angle(task.design), h = scaled_height(task.design);
  const double stress =
      task.scenario.empty() ? 0.0 : task.spec.scene.material.yield_stress / 1000.0;
  simulation.ok = !(state_->behaviour.fails && state_->behaviour.fails(task.design));
  if (!simulation.ok) simulation.reason = "it broke";
  simulation.metrics = {{"barrier_1_slam_force_n_per_m", a * a + h * h + stress, ""},
                        {"launch_length_m", (1 - a) * (1 - a) + h * h, ""},
                        {"retention_efficiency", 1 - h / 2, ""}};
  simulation.wall_time = 0.5;
  simulation.cpu_time = 1.0;
  simulation.particle_steps = 1000.0;
  return simulation;
}

int FakeSimulator::ended() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->ended;
}

std::map<std::string, int> FakeSimulator::counts() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->counts;
}

std::function<bool()> FakeSimulator::cancelled() const {
  return [state = state_] { return state->cancelled.load(); };
}

study::StudySummary FakeStudyTest::run(const designs::StudySpec& study, const std::string& out,
                                       const FakeSimulator& simulator, int jobs) {
  return run(study, out, study::local_service(simulator), simulator.cancelled(), jobs);
}

study::StudySummary FakeStudyTest::run(const designs::StudySpec& study, const std::string& out,
                                       const study::ServiceFactory& service,
                                       std::function<bool()> cancelled, int jobs) {
  study::StudyRunOptions options;
  options.folder = folder / out;
  options.jobs = jobs;
  options.program.version = "test";
  options.hooks.cancelled = std::move(cancelled);
  options.service = service;
  return study::run_study(study, options);
}

std::map<std::string, Json> FakeStudyTest::records(const std::string& out) const {
  std::map<std::string, Json> result;
  const std::string text = file_text(folder / (out + "/evaluations.jsonl"));
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    Json record = Json::parse(text.substr(begin, end - begin));
    begin = end + 1;
    if (record["status"] == "refused") continue;
    record.erase("crc32c");
    const std::string id = record["id"].get<std::string>();
    EXPECT_TRUE(result.emplace(id, std::move(record)).second) << id << " stands twice";
  }
  return result;
}

Json FakeStudyTest::json(const std::string& out, const std::string& file) const {
  return Json::parse(file_text(folder / (out + "/" + file)));
}

int FakeStudyTest::files(const std::string& out) const {
  int count = 0;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator(folder / (out + "/evaluations"))) {
    ++count;
  }
  return count;
}

}  // namespace parapet::test
