// The program on a damaged log.
#include <algorithm>

#include "study_fixture.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

class LogDamage : public StudyTest {};

TEST_F(LogDamage, HalfWrittenLastLineIsRepairedSaidAndEvaluatedAgain) {
  const std::string whole = file_text(log_of("calm"));
  const std::size_t last_line = whole.rfind('\n', whole.size() - 2) + 1;
  // Nothing of the line, its first byte, its middle, all but its last two bytes, all but its end.
  for (const std::size_t size : {last_line, last_line + 1, (last_line + whole.size()) / 2,
                                 whole.size() - 2, whole.size() - 1}) {
    const std::string out = "cut" + std::to_string(size);
    std::filesystem::copy(folder / "calm", folder / out, std::filesystem::copy_options::recursive);
    std::filesystem::resize_file(log_of(out), size);
    const Outcome outcome = run_program(folder.path(), command(out));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const bool damaged = size != last_line && size + 1 != whole.size();
    EXPECT_EQ(outcome.err.find("only half written") != std::string::npos, damaged) << outcome.err;
    resume_and_compare(out);
  }
}

/// Changes the first place of a text in the log's line with this number, counted from 1.
std::string changed(const std::string& log, int number, const std::string& from,
                    const std::string& to) {
  std::size_t begin = 0;
  for (int k = 1; k < number; ++k) begin = log.find('\n', begin) + 1;
  std::string text = log;
  const std::size_t place = text.find(from, begin);
  EXPECT_LT(place, text.find('\n', begin)) << from;
  return text.replace(place, from.size(), to);
}

struct Damage {
  const char *from, *to, *named;
};

constexpr Damage damages[] = {
    {"{\"id\"", "?\"id\"", "line 2"},                          // no JSON any more
    {"\"feasible\":true", "\"feasible\":false", "/feasible"},  // inverted
    {"\"spacing_m\":0.02", "\"spacing_m\":0.03", "/spacing_m"},
    {"\"deflector_angle_deg\":", "\"deflector_angle_deg\":1", "/design/deflector_angle_deg"},
    {"\"retention_efficiency\":0.", "\"retention_efficiency\":0.1", "/metrics"},
    {"\"crc32c\"", "\"crc32d\"", "line 2"},  // a line of its kind has one
    {",\"crc32c\":\"", "},{\"crc32c\":\"", "line 2"},
    {"\"id\":\"000", "\"id\":\"0/../0", "line 2"}};

TEST_F(LogDamage, DamagedLineIsNamedLeftOutOfAdviceAndEvaluatedAgain) {
  const std::string whole = file_text(log_of("calm"));
  int number = 0;
  for (const auto& [from, to, named] : damages) {
    SCOPED_TRACE(to);
    const std::string out = "damaged" + std::to_string(++number);
    std::filesystem::copy(folder / "calm", folder / out, std::filesystem::copy_options::recursive);
    folder.write(out + "/evaluations.jsonl", changed(whole, 2, from, to));
    const Outcome advice = run_program(folder.path(), {"recommend", out, "--no-confirm"});
    EXPECT_EQ(advice.exit_code, 1) << advice.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "line 2", advice.err);
    EXPECT_PRED_FORMAT2(IsSubstring, named, advice.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "left out", advice.err);
    const Json json = Json::parse(file_text(folder / out / "recommendation.json"));
    EXPECT_EQ(json["study"]["evaluations"], evaluations_in(log_of("calm")) - 1);

    const Outcome outcome = run_program(folder.path(), command(out));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "line 2", outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, named, outcome.err);
    EXPECT_EQ(line_count(folder / out / "evaluations.jsonl.damaged"), 1U);
    resume_and_compare(out);
    EXPECT_EQ(run_program(folder.path(), {"recommend", out, "--no-confirm"}).exit_code, 0);
  }
}

TEST_F(LogDamage, DamagedConfirmationIsSimulatedAgain) {
  const std::vector<std::string> recommend{"recommend", "calm", "--repeats", "2"};
  ASSERT_EQ(run_program(folder.path(), recommend).exit_code, 0);
  const std::string whole = file_text(folder / "calm/confirmations.jsonl");
  folder.write("calm/confirmations.jsonl", changed(whole, 1, "\"metrics\":", "\"metrics\": "));
  const Outcome outcome = run_program(folder.path(), recommend);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED_FORMAT2(IsSubstring, "confirmations.jsonl: line 1", outcome.err);
  EXPECT_EQ(records_in(folder / "calm/confirmations.jsonl").size(),
            static_cast<std::size_t>(std::count(whole.begin(), whole.end(), '\n')));
  EXPECT_EQ(run_program(folder.path(), recommend).exit_code, 0);
}

TEST_F(LogDamage, EachLineStandsAlone) {
  const Json state = Json::parse(file_text(folder / "calm/study.json"));
  int refused = 0;
  for (const auto& [id, record] : records_in(log_of("calm"))) {
    EXPECT_EQ(record["program_version"], state["provenance"]["program_version"]) << id;
    for (const Json& constraint : record["constraints"]) {
      EXPECT_GT(constraint["tolerance"].get<double>(), 0.0) << id;
    }
    if (record["status"] == "refused") {
      ++refused;
      EXPECT_EQ(record["reason"], "violates stem") << id;
      continue;
    }
    EXPECT_EQ(record["case_hash"].get<std::string>().size(), 16U) << id;
    EXPECT_TRUE(record["stop_reason"].is_string()) << id;
  }
  EXPECT_GT(refused, 0) << "the search met no design that a formula refuses";
  EXPECT_EQ(Json::parse(file_text(folder / "calm/summary.json"))["evaluations"],
            evaluations_in(log_of("calm")));
}

TEST_F(LogDamage, ChangedFileIsNamedAndStaysKnownAsDamaged) {
  const std::string report = file_text(folder / "calm/evaluations/0002.json");
  const std::string list = file_text(folder / "calm/checksums.sha256");
  EXPECT_PRED_FORMAT2(IsSubstring, "  evaluations/0002.json\n", list);
  EXPECT_PRED_FORMAT2(IsSubstring, "  study.json\n", list);
  folder.write("calm/evaluations/0002.json", report + " ");
  for (int time = 0; time < 2; ++time) {
    const Outcome advice = run_program(folder.path(), {"recommend", "calm", "--no-confirm"});
    EXPECT_EQ(advice.exit_code, 1) << advice.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "0002.json was changed after it was written", advice.err);
    const Outcome resumed = run_program(folder.path(), command("calm"));
    EXPECT_EQ(resumed.exit_code, 0);
    EXPECT_PRED_FORMAT2(IsSubstring, "0002.json was changed after it was written", resumed.err);
  }
  folder.write("calm/evaluations/0002.json", report);
  EXPECT_EQ(run_program(folder.path(), {"recommend", "calm", "--no-confirm"}).exit_code, 0);
}

TEST_F(LogDamage, ChecksumsAreThoseOfCoreutils) {
  const std::vector<std::string> check{"-c", "cd calm && sha256sum --quiet -c checksums.sha256"};
  for (const char* verb : {"optimize", "recommend"}) {
    const Outcome outcome = run_program(folder.path(), check, "", "/bin/sh");
    EXPECT_EQ(outcome.exit_code, 0) << verb << outcome.out << outcome.err;
    ASSERT_EQ(run_program(folder.path(), {"recommend", "calm", "--no-confirm"}).exit_code, 0);
  }
}

// With scenarios a study resumes in the middle of a design, from the simulations that had ended.
TEST(SimulationDamage, ChangedSimulationOfAnUnfinishedDesignIsNotUsed) {
  const TemporaryFolder folder;
  Json study = tiny_search();
  study["method"] = Json::parse(R"({"algorithm": "SOBOL", "max_evaluations": 3})");
  folder.write("study.json", study.dump());
  const auto command = [](const std::string& out) {
    return std::vector<std::string>{"optimize", "study.json", "--out", out, "--jobs", "1"};
  };
  ASSERT_EQ(run_program(folder.path(), command("calm")).exit_code, 0);
  std::filesystem::copy(folder / "calm", folder / "out", std::filesystem::copy_options::recursive);
  // As if the last design had not been logged yet.
  const std::string log = file_text(folder / "out/evaluations.jsonl");
  folder.write("out/evaluations.jsonl", log.substr(0, log.rfind('\n', log.size() - 2) + 1));
  std::filesystem::remove(folder / "out/checksums.sha256");
  std::filesystem::remove(folder / "out/evaluations/0003.json");
  std::string simulation = file_text(folder / "out/evaluations/0003-usual.json");
  const std::size_t digit = simulation.find("barrier_1_slam_force_n_per_m\": ") + 31;
  simulation[digit] = simulation[digit] == '1' ? '2' : '1';
  folder.write("out/evaluations/0003-usual.json", simulation);
  ASSERT_EQ(run_program(folder.path(), command("out")).exit_code, 0);
  EXPECT_EQ(records_in(folder / "out/evaluations.jsonl"),
            records_in(folder / "calm/evaluations.jsonl"));
}

}  // namespace
}  // namespace parapet::test
