// parapet evaluate: one JSON object for other optimisers.
#include <gtest/gtest.h>

#include <set>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

const std::string design = R"({"deflector_angle_deg": 45, "upstream_height_m": 0.07})";

class Evaluate : public ::testing::Test {
 protected:
  void SetUp() override { folder.write("study.json", tiny_study().dump()); }

  Outcome evaluate(const std::string& text, std::vector<std::string> more = {},
                   const std::string& input = "") const {
    std::vector<std::string> arguments{"evaluate", "study.json", "--design", text};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder.path(), arguments, input);
  }

  TemporaryFolder folder;
};

TEST_F(Evaluate, StandardOutputIsExactlyOneObject) {
  const Outcome outcome = evaluate(design);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
  const Json record = Json::parse(outcome.out);  // throws for anything beside the object
  EXPECT_EQ(record["status"], "ok");
  EXPECT_EQ(record["design"]["deflector_angle_deg"], 45.0);
  EXPECT_TRUE(record["metrics"]["retention_efficiency"].is_number());
  EXPECT_EQ(record["objectives"][0]["metric"], "barrier_1_slam_force_n_per_m");
  // Minimised with scale 100: the scalar is force / 100.
  EXPECT_DOUBLE_EQ(record["objective_scalar"].get<double>(),
                   record["metrics"]["barrier_1_slam_force_n_per_m"].get<double>() / 100.0);
  EXPECT_EQ(record["constraints"].size(), 2U);
  EXPECT_NEAR(record["constraints"][0]["margin"].get<double>(), 0.13 - 0.115, 1e-12);
  EXPECT_EQ(record["constraints"][0]["satisfied"], true);
}

TEST_F(Evaluate, TakesTheDesignFromAFileOrStandardInput) {
  folder.write("design.json", design);
  const auto without_timing = [](const Outcome& outcome) {
    Json record = Json::parse(outcome.out);
    for (const char* key : {"wall_time_s", "cpu_time_s", "crc32c"}) record.erase(key);
    return record.dump();
  };
  const std::string direct = without_timing(evaluate(design));
  EXPECT_EQ(without_timing(evaluate("@design.json")), direct);
  EXPECT_EQ(without_timing(evaluate("-", {}, design)), direct);
}

TEST_F(Evaluate, AnswersFromTheLogTheSecondTime) {
  const Outcome first = evaluate(design, {"--log", "outside"});
  const Outcome second = evaluate(design, {"--log", "outside"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, second.out) << "the same line, wall time too: nothing was simulated";
  EXPECT_EQ(line_count(folder / "outside/evaluations.jsonl"), 1U);
  EXPECT_EQ(file_text(folder / "outside/evaluations.jsonl"), first.out);
  const Json report = Json::parse(file_text(folder / "outside/evaluations/0001.json"));
  EXPECT_EQ(report["format"], "parapet-evaluation/1");
  EXPECT_GT(report["series"]["rows"].size(), 10U);
  EXPECT_EQ(report["provenance"]["seed"], 1);
}

TEST_F(Evaluate, SeveralAtOnceShareALog) {
  std::vector<std::unique_ptr<RunningProgram>> programs;
  for (const char* height : {"0.05", "0.06", "0.07", "0.08"}) {
    const std::string text =
        std::string(R"({"deflector_angle_deg": 20, "upstream_height_m": )") + height + "}";
    programs.push_back(std::make_unique<RunningProgram>(
        folder.path(), std::vector<std::string>{"evaluate", "study.json", "--design", text, "--log",
                                                "outside", "--jobs", "1"}));
  }
  std::set<std::string> ids;
  for (auto& program : programs) {
    const Outcome outcome = program->wait();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    ids.insert(Json::parse(outcome.out)["id"].get<std::string>());
  }
  EXPECT_EQ(ids, (std::set<std::string>{"0001", "0002", "0003", "0004"}));
  EXPECT_EQ(line_count(folder / "outside/evaluations.jsonl"), 4U);
}

TEST_F(Evaluate, WrongDesignsAreNamed) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {R"({"deflector_angle_deg": 45})", "upstream_height_m"},
      {R"({"deflector_angle_deg": 99, "upstream_height_m": 0.07})", "/deflector_angle_deg: 99"},
      {R"({"deflector_angle_deg": "steep", "upstream_height_m": 0.07})", "is not a number"},
      {R"({"angle": 1, "deflector_angle_deg": 45, "upstream_height_m": 0.07})", "/angle"},
      {"[45, 0.07]", "is not an object"},
      {"{", "is not JSON"},
      {"@nowhere.json", "cannot read nowhere.json"}};
  for (const auto& [text, words] : wrong) {
    const Outcome outcome = evaluate(text, {"--log", "outside"});
    EXPECT_EQ(outcome.exit_code, 2) << text;
    EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.err) << text;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "") << text;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "outside"));
}

TEST_F(Evaluate, FailedSimulationIsReportedInTheObject) {
  Json study = tiny_study();
  make_unsolvable(study["case"]);
  folder.write("study.json", study.dump());
  const Outcome outcome = evaluate(design);
  EXPECT_EQ(outcome.exit_code, 1);
  const Json record = Json::parse(outcome.out);
  EXPECT_EQ(record["status"], "failed");
  EXPECT_NE(record["reason"], "");
  EXPECT_EQ(record["feasible"], false);
  EXPECT_TRUE(record["objective_scalar"].is_null());
}

}  // namespace
}  // namespace parapet::test
