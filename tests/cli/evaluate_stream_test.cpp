// parapet evaluate --stdin-jsonl: many designs through one process.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

class EvaluateStream : public ::testing::Test {
 protected:
  void SetUp() override {
    folder.write("study.json", tiny_study().dump());
    folder.write("search.json", tiny_search().dump());
  }

  Outcome stream(const std::string& spec, const std::string& input,
                 std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"evaluate", spec, "--stdin-jsonl", "--jobs", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(folder.path(), arguments, input);
  }

  /// The records of the output by their ids.
  static std::map<std::string, Json> records(const Outcome& outcome) {
    std::map<std::string, Json> all;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
      const Json json = Json::parse(line);
      const std::string id =
          json["id"].is_string() ? json["id"].get<std::string>() : json["id"].dump();
      EXPECT_TRUE(all.emplace(id, json).second) << "twice: " << id;
    }
    return all;
  }

  static Json without_origin(Json record) {
    for (const char* key : {"id", "wall_time_s", "cpu_time_s", "crc32c", "log_id", "from_log"}) {
      record.erase(key);
    }
    if (record.contains("scenarios")) {
      for (Json& one : record["scenarios"]) {
        for (const char* key : {"wall_time_s", "cpu_time_s"}) one.erase(key);
      }
    }
    return record;
  }

  TemporaryFolder folder;
};

const std::string first = R"({"deflector_angle_deg": 45, "upstream_height_m": 0.07})";
const std::string second = R"({"deflector_angle_deg": 20, "upstream_height_m": 0.06})";

TEST_F(EvaluateStream, GivesTheRecordsOfOneProcessEach) {
  const Outcome many = stream("study.json", first + "\n\n" + second);  // no line end at the end
  ASSERT_EQ(many.exit_code, 0) << many.err;
  const auto found = records(many);
  ASSERT_EQ(found.size(), 2U) << many.out;
  const Outcome one = run_program(folder.path(), {"evaluate", "study.json", "--design", second});
  EXPECT_EQ(without_origin(found.at("3")), without_origin(Json::parse(one.out)));
  EXPECT_EQ(found.at("1")["design"]["deflector_angle_deg"], 45.0);
}

TEST_F(EvaluateStream, IdScenarioAndSpacingComeWithTheDesign) {
  const std::string input = R"({"design": )" + first +
                            R"(, "id": "a/b", "scenario": "stiff", "spacing_mm": 15})" + "\n" +
                            R"({"design": )" + first + R"(, "id": 7})" + "\n";
  const Outcome outcome = stream("search.json", input);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto found = records(outcome);
  ASSERT_EQ(found.size(), 2U) << outcome.out;
  const Json& alone = found.at("a/b");
  ASSERT_EQ(alone["scenarios"].size(), 1U);
  EXPECT_EQ(alone["scenarios"][0]["name"], "stiff");
  EXPECT_EQ(alone["scenarios"][0]["weight"], 1.0);
  EXPECT_EQ(alone["spacing_m"], 0.015);
  EXPECT_EQ(alone["metrics"], alone["scenarios"][0]["metrics"]);
  EXPECT_EQ(found.at("7")["scenarios"].size(), 3U);
}

TEST_F(EvaluateStream, AWrongLineGetsItsErrorAndStopsNothing) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"{", "is not JSON"},
      {"[1]", "is not an object"},
      {R"({"deflector_angle_deg": 45})", "upstream_height_m"},
      {R"({"deflector_angle_deg": 99, "upstream_height_m": 0.07})", "/deflector_angle_deg: 99"},
      {R"({"design": )" + first + R"(, "scenario": "wet"})", "/scenario: \"wet\""},
      {R"({"design": )" + first + R"(, "spacing_mm": "fine"})", "/spacing_mm: \"fine\""},
      {R"({"design": )" + first + R"(, "id": [1]})", "/id: [1]"},
      {R"({"design": )" + first + R"(, "angle": 1})", "/angle: 1: is an unknown key"}};
  std::string input;
  for (const auto& [line, words] : wrong) input += line + "\n";
  const Outcome outcome = stream("study.json", input + second + "\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<Json> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
  ASSERT_EQ(lines.size(), wrong.size() + 1);
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    EXPECT_EQ(lines[k]["status"], "error") << wrong[k].first;
    EXPECT_PRED_FORMAT2(IsSubstring, wrong[k].second, lines[k]["reason"].get<std::string>());
    EXPECT_PRED_FORMAT2(IsSubstring, "line " + std::to_string(k + 1),
                        lines[k]["issues"][0]["file"].get<std::string>());
  }
  EXPECT_EQ(lines.back()["status"], "ok");
}

TEST_F(EvaluateStream, ALogAnswersAndTakesDesigns) {
  const Outcome before = stream("study.json", first + "\n", {"--log", "outside", "--no-report"});
  ASSERT_EQ(before.exit_code, 0) << before.err;
  EXPECT_EQ(line_count(folder / "outside/evaluations.jsonl"), 1U);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "outside/evaluations")) << "--no-report";
  const Outcome after = stream("study.json", first + "\n" + second + "\n", {"--log", "outside"});
  ASSERT_EQ(after.exit_code, 0) << after.err;
  EXPECT_EQ(line_count(folder / "outside/evaluations.jsonl"), 2U);
  const auto found = records(after);
  EXPECT_EQ(found.at("1")["from_log"], true);
  EXPECT_EQ(found.at("1")["wall_time_s"], records(before).at("1")["wall_time_s"]);
  EXPECT_EQ(found.at("2")["from_log"], false);
  EXPECT_EQ(found.at("2")["log_id"], "0002");
  EXPECT_TRUE(std::filesystem::exists(folder / "outside/evaluations/0002.json"));
  // The folder is a study's like any other.
  EXPECT_EQ(run_program(folder.path(), {"verify", "outside"}).exit_code, 0);
  EXPECT_EQ(run_program(folder.path(), {"recommend", "outside", "--no-confirm"}).exit_code, 0);
}

TEST_F(EvaluateStream, WhatALogCannotHoldIsRefused) {
  const Outcome outcome = stream("search.json",
                                 R"({"design": )" + first + R"(, "scenario": "stiff"})" + "\n" +
                                     R"({"design": )" + first + R"(, "spacing_mm": 33})" + "\n",
                                 {"--log", "outside"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto found = records(outcome);
  EXPECT_EQ(found.at("1")["status"], "error");
  EXPECT_EQ(found.at("2")["status"], "error");
  EXPECT_EQ(line_count(folder / "outside/evaluations.jsonl"), 0U);
}

// A client that waits for each answer before it puts the next question, through a named pipe.
TEST_F(EvaluateStream, AnswersBeforeTheNextLineComes) {
  folder.write("client.sh", R"(set -e
mkfifo questions answers
"$1" evaluate study.json --stdin-jsonl --quiet <questions >answers &
exec 3>questions 4<answers
for angle in 20 30 40; do
  echo "{\"deflector_angle_deg\": $angle, \"upstream_height_m\": 0.06}" >&3
  read -r answer <&4
  case $answer in *"\"deflector_angle_deg\":$angle.0"*) ;; *) echo "wrong: $answer"; exit 1 ;; esac
done
exec 3>&-
wait $!
)");
  const Outcome outcome =
      run_program(folder.path(), {"client.sh", parapet_program().string()}, "", "/bin/sh");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST_F(EvaluateStream, AReaderThatGoesAwayEndsIt) {
  std::string input;
  for (int k = 0; k < 40; ++k) {
    input += R"({"upstream_height_m": 0.06, "deflector_angle_deg": )" + std::to_string(k) + "}\n";
  }
  folder.write("designs.jsonl", input);
  folder.write(
      "client.sh",
      R"("$1" evaluate study.json --stdin-jsonl --jobs 1 --log outside <designs.jsonl | head -n 1
)");
  const Outcome outcome =
      run_program(folder.path(), {"client.sh", parapet_program().string()}, "", "/bin/sh");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
  EXPECT_LT(line_count(folder / "outside/evaluations.jsonl"), 40U) << "it went on for nobody";
}

TEST_F(EvaluateStream, OneOfTheTwoIsAsked) {
  const Outcome neither = run_program(folder.path(), {"evaluate", "study.json"});
  EXPECT_EQ(neither.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "--stdin-jsonl", neither.err);
  const Outcome both = stream("study.json", first, {"--design", first});
  EXPECT_EQ(both.exit_code, 2);
}

}  // namespace
}  // namespace parapet::test
