// A study that is killed or interrupted ends, once resumed, exactly where an undisturbed one does.
#include <csignal>

#include "study_fixture.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

class Interruption : public StudyTest {
 protected:
  /// Begins the study and sends a signal when its log has this many lines (or it has ended).
  Outcome disturb(const std::string& out, std::size_t lines, int signal) {
    RunningProgram program(folder.path(), command(out));
    EXPECT_TRUE(wait_until([&] {
      return program.ended() ||
             (std::filesystem::exists(log_of(out)) && line_count(log_of(out)) >= lines);
    }));
    program.send(signal);
    return program.wait();
  }
};

TEST_F(Interruption, KilledAmongTheStartsResumesToTheSameAnswer) {
  EXPECT_EQ(disturb("out", 1, SIGKILL).exit_code, 128 + SIGKILL);
  EXPECT_LT(line_count(log_of("out")), line_count(log_of("calm")));
  resume_and_compare("out");
}

TEST_F(Interruption, KilledInTheSearchResumesToTheSameAnswer) {
  EXPECT_EQ(disturb("out", 6, SIGKILL).exit_code, 128 + SIGKILL);
  EXPECT_LT(line_count(log_of("out")), line_count(log_of("calm")));
  resume_and_compare("out");
}

TEST_F(Interruption, KilledAgainAndAgainResumesToTheSameAnswer) {
  for (std::size_t lines = 1; lines <= 7; lines += 2) disturb("out", lines, SIGKILL);
  resume_and_compare("out");
}

TEST_F(Interruption, KilledBeforeAnythingIsLoggedResumes) {
  RunningProgram program(folder.path(), command("out"));
  EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(folder / "out/study.json"); }));
  program.send(SIGKILL);
  program.wait();
  resume_and_compare("out");
}

TEST_F(Interruption, ControlCEndsInGoodOrderAndSaysHowToResume) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string out = "out" + std::to_string(signal);
    const Outcome outcome = disturb(out, 5, signal);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "the same command resumes", outcome.err);
    const Json summary = summary_of(out);
    EXPECT_EQ(summary["state"], "interrupted");
    EXPECT_EQ(summary["evaluations"], evaluations_in(log_of(out)));
    resume_and_compare(out);
  }
}

TEST_F(Interruption, FinishedStudyIsNotRunAgain) {
  const std::string log = file_text(log_of("calm"));
  const Outcome outcome = run_program(folder.path(), command("calm"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(file_text(log_of("calm")), log);
  EXPECT_EQ(Json::parse(file_text(folder / "calm/summary.json"))["simulated_by_this_run"], 0);
}

TEST_F(Interruption, LargerBudgetContinuesTheStudy) {
  Json study = tiny_study();
  study["method"]["max_evaluations"] = 8;
  folder.write("study.json", study.dump());
  ASSERT_EQ(run_program(folder.path(), command("out")).exit_code, 0);
  EXPECT_EQ(evaluations_in(log_of("out")), 8U);
  folder.write("study.json", tiny_study().dump());
  resume_and_compare("out");
}

/// The lines of a log without what was measured with a clock, in their order.
std::vector<Json> lines_in(const std::filesystem::path& log) {
  std::vector<Json> lines;
  const std::string text = file_text(log);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const Json line = Json::parse(text.substr(begin, end - begin));
    lines.push_back({{"id", line["id"]},
                     {"design", line["design"]},
                     {"metrics", line["metrics"]},
                     {"spacing_m", line["spacing_m"]}});
    begin = end + 1;
  }
  return lines;
}

// What the quickstart does on two cores, at coarser spacings: killed anywhere, it ends where an
// undisturbed run does, line by line.
TEST(InterruptedSearch, DefaultsWithTwoJobsKilledAnywhereEndTheSame) {
  const TemporaryFolder folder;
  Json study = tiny_study();
  study["case"]["run"]["stop_time_s"] = 0.3;
  study["fidelity"] = {{"spacings_m", {0.02, 0.025}}};
  study["method"] = Json::parse(R"({"algorithm": "BAYESIAN", "max_evaluations": 14, "seed": 2,
    "starts": [{"deflector_angle_deg": 30, "upstream_height_m": 0.08}]})");
  study["variables"]["upstream_height_m"]["lower"] = 0.06;
  folder.write("study.json", study.dump());
  const auto command = [&](const std::string& out) {
    return std::vector<std::string>{"optimize", "study.json", "--out", out, "--jobs", "2"};
  };
  const Outcome calm = run_program(folder.path(), command("calm"));
  ASSERT_EQ(calm.exit_code, 0) << calm.err;
  const auto expected = lines_in(folder / "calm/evaluations.jsonl");
  ASSERT_EQ(expected.size(), 14U);
  for (const std::size_t lines : {1U, 3U, 6U, 11U}) {
    const std::string out = "out" + std::to_string(lines);
    const auto log = folder / out / "evaluations.jsonl";
    RunningProgram program(folder.path(), command(out));
    EXPECT_TRUE(wait_until([&] {
      return program.ended() || (std::filesystem::exists(log) && line_count(log) >= lines);
    }));
    program.send(SIGKILL);
    program.wait();
    ASSERT_LT(line_count(log), expected.size()) << "too late to disturb";
    const Outcome resumed = run_program(folder.path(), command(out));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(lines_in(log), expected) << "killed after " << lines;
  }
}

// With one job, or a repeatable method, the search replays itself from the log.
TEST(InterruptedSearch, KilledAgainAndAgainResumesToTheSameLog) {
  for (const char* jobs : {"1", "3"}) {
    const TemporaryFolder folder;
    Json study = tiny_search();
    folder.write("study.json", study.dump());
    const auto command = [&](const std::string& out) {
      return std::vector<std::string>{"optimize", "study.json", "--out", out, "--jobs", jobs};
    };
    const Outcome calm = run_program(folder.path(), command("calm"));
    ASSERT_EQ(calm.exit_code, 0) << calm.err;
    const auto log = folder / "out/evaluations.jsonl";
    const auto simulations = [&] {
      std::size_t count = 0;
      if (!std::filesystem::exists(folder / "out/evaluations")) return count;
      for (const auto& entry : std::filesystem::directory_iterator(folder / "out/evaluations")) {
        if (entry.path().filename().string().find('-') != std::string::npos) ++count;
      }
      return count;
    };
    // In the middle of a design: a number of simulations that three do not divide.
    for (const std::size_t ended : {2U, 10U, 22U}) {
      RunningProgram program(folder.path(), command("out"));
      EXPECT_TRUE(wait_until([&] { return program.ended() || simulations() >= ended; }));
      program.send(SIGKILL);
      program.wait();
    }
    ASSERT_LT(line_count(log), 12U) << "too late to disturb";
    const Outcome resumed = run_program(folder.path(), command("out"));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(records_in(log), records_in(folder / "calm/evaluations.jsonl")) << jobs << " jobs";
  }
}

TEST(InterruptedSimulation, WritesNoResult) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  spec["numerics"]["spacing_m"] = 0.005;  // long enough to be interrupted
  spec["run"]["stop_time_s"] = 60.0;
  spec["run"]["settled"]["enabled"] = false;
  folder.write("case.json", spec.dump());
  RunningProgram program(folder.path(), {"simulate", "case.json", "--out", "out", "--frames"});
  EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(folder / "out/frames/tiny.pvd"); }));
  program.send(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "interrupted", outcome.err);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/result.json"));
}

TEST(InterruptedSweep, KeepsFinishedRowsAndResumes) {
  const TemporaryFolder folder;
  Json sweep = tiny_sweep();
  sweep["case"]["numerics"]["spacing_m"] = 0.01;  // time enough between two rows for the kill
  folder.write("sweep.json", sweep.dump());
  const std::vector<std::string> command{"table3", "sweep.json", "--out", "out", "--jobs", "1"};
  RunningProgram program(folder.path(), command);
  EXPECT_TRUE(wait_until([&] {
    return program.ended() || std::filesystem::exists(folder / "out/rows/lifted.json") ||
           std::filesystem::exists(folder / "out/rows/flat.json");
  }));
  program.send(SIGKILL);
  program.wait();
  const std::size_t kept = Json::parse(file_text(folder / "out/tiny.json"))["rows"].size();
  EXPECT_LT(kept, 3U);
  const Outcome resumed = run_program(folder.path(), command);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "finished before, not run again", resumed.err);
  EXPECT_EQ(Json::parse(file_text(folder / "out/tiny.json"))["rows"].size(), 3U);
}

}  // namespace
}  // namespace parapet::test
