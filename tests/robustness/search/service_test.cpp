// Studies over other services than threads of this program, and optimisers that wait for answers.
#include <mutex>
#include <stdexcept>
#include <thread>

#include "fake_study.hpp"
#include "parapet/records/simulation_json.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using study::EndedSimulation;
using study::SimulationTask;
using study::StudyState;

/// Another machine: all that goes there and comes back is text.
class TextService : public study::SimulationService {
 public:
  explicit TextService(std::unique_ptr<SimulationService> inner) : inner_(std::move(inner)) {}

  int places() const override { return inner_->places(); }
  std::size_t submit(SimulationTask task) override {
    return inner_->submit(study::task_from_json(Json::parse(to_json(task).dump())));
  }
  std::optional<EndedSimulation> poll() override {
    auto ended = inner_->poll();
    if (ended) *ended = as_text(*ended);
    return ended;
  }
  EndedSimulation wait() override { return as_text(inner_->wait()); }

 private:
  static EndedSimulation as_text(const EndedSimulation& ended) {
    return {
        .ticket = ended.ticket,
        .simulation = records::simulation_from_json(Json::parse(to_json(ended.simulation).dump())),
        .failure = ended.failure};
  }
  std::unique_ptr<SimulationService> inner_;
};

study::ServiceFactory as_text(const study::ServiceFactory& factory) {
  return [factory](int places, study::ServiceHooks hooks) {
    return std::make_unique<TextService>(factory(places, std::move(hooks)));
  };
}

Json with_method(Json study, const char* method) {
  study["method"] = Json::parse(method);
  return study;
}

constexpr const char* cobyla =
    R"({"algorithm": "COBYLA", "max_evaluations": 14, "start_count": 4, "seed": 2})";

class Service : public FakeStudyTest {
 protected:
  std::string log(const std::string& out) const {
    return file_text(folder / (out + "/evaluations.jsonl"));
  }
};

TEST_F(Service, ThatPassesEverythingAsTextGivesTheSameLog) {
  const std::map<std::string, Json> studies{
      {"bayesian", fake_study()},
      {"scenarios", fake_study_with_scenarios()},
      {"sobol", with_method(fake_study(), R"({"algorithm": "SOBOL", "max_evaluations": 9})")},
      {"cobyla", with_method(fake_study_with_scenarios(), cobyla)},
      {"isres", with_method(fake_study(), R"({"algorithm": "ISRES", "max_evaluations": 25})")},
      {"scalarised", with_method(fake_study(), R"({"algorithm": "COBYLA", "max_evaluations": 30,
          "pareto_points": 4, "scalarization": "epsilon_constraint", "start_count": 3})")}};
  for (const auto& [name, json] : studies) {
    const auto fails = [](const designs::Design& design) { return scaled_height(design) > 0.7; };
    const FakeSimulator simulator({.delays = false, .fails = fails, .cancel_after = -1});
    run(parsed(json), name, simulator);
    run(parsed(json), name + "-text", as_text(study::local_service(simulator)), {}, 1);
    EXPECT_FALSE(log(name).empty());
    EXPECT_EQ(log(name), log(name + "-text")) << name;
  }
}

TEST_F(Service, ThatRunsTheSolverFromTextGivesTheSameLog) {
  Json json = with_method(fake_study(), cobyla);
  json["case"]["numerics"]["spacing_m"] = 0.02;
  json["objectives"].erase(1);  // particles so coarse tell no launch
  json["method"]["max_evaluations"] = 8;
  run(parsed(json), "here", study::local_service(), {}, 1);
  run(parsed(json), "there", as_text(study::local_service()), {}, 1);
  auto here = records("here"), there = records("there");
  EXPECT_EQ(here.size(), 8U);
  for (auto* log : {&here, &there}) {
    for (auto& [id, record] : *log) {
      record.erase("wall_time_s");
      record.erase("cpu_time_s");
    }
  }
  EXPECT_EQ(here, there);
}

TEST_F(Service, ThatFailsEndsTheStudyWithItsReason) {
  for (const char* algorithm : {"BAYESIAN", "SOBOL", "COBYLA"}) {
    Json json = fake_study();
    json["method"]["algorithm"] = algorithm;
    const FakeSimulator simulator;
    const auto failing = [&](const SimulationTask& task, const solver::Callbacks& callbacks) {
      if (simulator.ended() == 5) throw std::runtime_error("the machine is gone");
      return simulator(task, callbacks);
    };
    EXPECT_THROW(run(parsed(json), algorithm, study::local_service(failing), {}, 1),
                 std::runtime_error);
    EXPECT_EQ(records(algorithm).size(), 5U) << "what had ended is kept";
    const Json summary = this->json(algorithm, "summary.json");
    EXPECT_EQ(summary["state"], "failed");
    EXPECT_EQ(summary["message"], "the machine is gone");
  }
}

TEST_F(Service, ImpossibleScenesAreFailedSimulationsAndNeverSent) {
  Json json = fake_study();
  json["scenarios"] = Json::parse(R"([
    {"name": "usual", "weight": 0.5, "set": {"yield_stress_pa": 90}},
    {"name": "stiff", "weight": 0.5, "set": {"yield_stress_pa": 100}}])");
  json["method"] = Json::parse(R"({"algorithm": "LIST", "max_evaluations": 2, "starts": [
    {"deflector_angle_deg": 1, "upstream_height_m": 0.05},
    {"deflector_angle_deg": 2, "upstream_height_m": 0.05}]})");
  designs::StudySpec study = parsed(json);
  // Too low to be resolved; past the check at the door.
  study.method.starts[0]["upstream_height_m"] = 1e-6;
  const FakeSimulator simulator;
  run(study, "out", simulator);
  EXPECT_EQ(simulator.ended(), 2) << "the two events of the second design";
  const auto log = records("out");
  EXPECT_EQ(log.at("0001")["status"], "failed");
  EXPECT_NE(log.at("0001")["reason"].get<std::string>().find("the scene is impossible"),
            std::string::npos);
  EXPECT_EQ(log.at("0002")["status"], "ok");
}

// With fewer simulations than places each takes several threads: rounds of an optimiser only.
TEST_F(Service, PlacesAreSharedAsThreadsInRounds) {
  const auto threads = [&](const Json& json, const std::string& out) {
    std::mutex mutex;
    std::map<std::string, int> seen;
    const FakeSimulator simulator;
    const auto noting = [&](const SimulationTask& task, const solver::Callbacks& callbacks) {
      const std::scoped_lock lock(mutex);
      seen[task.label] = task.threads;
      return simulator(task, callbacks);
    };
    run(parsed(json), out, study::local_service(noting), {}, 4);
    return seen;
  };
  Json json = with_method(fake_study(), cobyla);
  json["method"]["start_count"] = 2;
  for (const auto& [label, count] : threads(json, "cobyla")) {
    EXPECT_EQ(count, label <= "0002" ? 2 : 4) << label;
  }
  for (const auto& [label, count] :
       threads(with_method(fake_study_with_scenarios(), cobyla), "scenarios")) {
    EXPECT_EQ(count, 1) << label << ": four starts or three events for four places";
  }
  for (const auto& [label, count] : threads(fake_study(), "bayesian")) {
    EXPECT_EQ(count, 1) << label;
  }
}

TEST_F(Service, OptimiserStoppedAnywhereResumesToTheSameLog) {
  const std::map<std::string, int> algorithms{{"COBYLA", 14}, {"ISRES", 24}, {"MLSL", 14}};
  for (const auto& [name, evaluations] : algorithms) {
    Json json = with_method(fake_study_with_scenarios(), cobyla);
    json["method"]["algorithm"] = name;
    json["method"]["max_evaluations"] = evaluations;
    const auto study = parsed(json);
    run(study, name, FakeSimulator());
    for (const int jobs : {1, 3}) {
      for (const int stop : {1, 11, 13, 39}) {
        const std::string out = name + std::to_string(jobs) + "-" + std::to_string(stop);
        const FakeSimulator disturbed({.delays = jobs > 1, .fails = {}, .cancel_after = stop});
        EXPECT_EQ(run(study, out, disturbed, jobs).state, StudyState::interrupted) << out;
        const FakeSimulator again({.delays = jobs > 1, .fails = {}, .cancel_after = -1});
        EXPECT_EQ(run(study, out, again, jobs).state, StudyState::done) << out;
        EXPECT_EQ(records(out), records(name)) << out;
        EXPECT_EQ(disturbed.ended() + again.ended(), 3 * evaluations) << out << ": nothing twice";
      }
    }
  }
}

// The limit is asked for a round as a whole: starting designs stay together.
TEST_F(Service, ARoundIsNotCutByTheProcessorTime) {
  Json json = with_method(fake_study(), cobyla);
  json["method"]["max_cpu_time_s"] = 2.5;  // a simulation takes 1 s
  const auto summary = run(parsed(json), "out", FakeSimulator());
  EXPECT_EQ(summary.termination, "cpu_time_limit") << summary.message;
  EXPECT_EQ(summary.evaluations, 4);
}

}  // namespace
}  // namespace parapet::test
