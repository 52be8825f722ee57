// Closed, full and abandoned standard streams: no file of ours is hurt, and lost output is said.
#include <gtest/gtest.h>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

const std::string design = R"({"deflector_angle_deg": 45, "upstream_height_m": 0.07})";

class Streams : public ::testing::Test {
 protected:
  void SetUp() override {
    folder.write("case.json", tiny_case().dump());
    folder.write("sweep.json", tiny_sweep().dump());
    Json study = tiny_study();
    study["method"]["max_evaluations"] = 8;
    folder.write("study.json", study.dump());
    ASSERT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", "done"}).exit_code, 0);
  }

  /// The program in a shell, with redirections such as ">&-".
  Outcome run(const std::string& redirections, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {"-c", "\"$0\" \"$@\" " + redirections, parapet_program().string()});
    return run_program(folder.path(), arguments, "", "/bin/sh");
  }

  void expect_sound(const std::string& out) const {
    const std::string lock = file_text(folder / out / ".lock");
    EXPECT_EQ(lock.find_first_not_of("0123456789"), std::string::npos) << lock;
    for (const char* name : {"evaluations.jsonl", "confirmations.jsonl"}) {
      const std::string text = file_text(folder / out / name);
      for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
        const std::string line = text.substr(begin, text.find('\n', begin) - begin);
        EXPECT_TRUE(Json::accept(line)) << name << ": " << line;
      }
    }
  }

  TemporaryFolder folder;
};

struct Closed {
  const char* redirections;
  bool output_lost;
};

constexpr Closed closed[] = {
    {">&-", true}, {"2>&-", false}, {">&- 2>&-", true}, {"<&-", false}, {"<&- >&- 2>&-", true}};

TEST_F(Streams, ClosedStreamsHurtNoFileAndLostOutputIsNoSuccess) {
  int number = 0;
  for (const auto& [redirections, lost] : closed) {
    SCOPED_TRACE(redirections);
    const std::string out = "study" + std::to_string(++number);
    const int expected = lost ? 1 : 0;
    EXPECT_EQ(run(redirections, {"optimize", "study.json", "--out", out}).exit_code, expected);
    expect_sound(out);
    EXPECT_EQ(line_count(folder / out / "evaluations.jsonl"),
              line_count(folder / "done/evaluations.jsonl"));
    EXPECT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", out}).exit_code, 0)
        << "it resumes";
    EXPECT_EQ(run(redirections, {"recommend", out, "--repeats", "1"}).exit_code, expected);
    expect_sound(out);
    EXPECT_FALSE(file_text(folder / out / "recommendation.md").empty());
    const std::string log = "log" + std::to_string(number);
    EXPECT_EQ(
        run(redirections, {"evaluate", "study.json", "--design", design, "--log", log}).exit_code,
        expected);
    expect_sound(log);
    const std::string simulated = "simulated" + std::to_string(number);
    EXPECT_EQ(run(redirections, {"simulate", "case.json", "--out", simulated}).exit_code, expected);
    expect_sound(simulated);
    EXPECT_TRUE(Json::accept(file_text(folder / simulated / "result.json")));
    EXPECT_EQ(run(redirections, {"check", "study.json"}).exit_code, expected);
    const std::string rows = "rows" + std::to_string(number);
    EXPECT_EQ(run(redirections, {"table3", "sweep.json", "--out", rows}).exit_code, expected);
    expect_sound(rows);
  }
}

TEST_F(Streams, ClosedOutputIsSaid) {
  const Outcome outcome = run(">&-", {"evaluate", "study.json", "--design", design});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED_FORMAT2(IsSubstring, "cannot write standard output: Bad file descriptor",
                      outcome.err);
}

TEST_F(Streams, ClosedInputIsAnErrorWhereItIsRead) {
  const Outcome outcome = run("<&-", {"evaluate", "study.json", "--design", "-"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED_FORMAT2(IsSubstring, "cannot read standard input", outcome.err);
}

TEST_F(Streams, FullOutputIsExitCodeOneForEveryVerbThatPrints) {
  const std::vector<std::vector<std::string>> calls{
      {"evaluate", "study.json", "--design", design},
      {"optimize", "study.json", "--out", "done"},
      {"recommend", "done", "--no-confirm"},
      {"simulate", "case.json", "--out", "full"},
      {"simulate", "case.json", "--out", "full", "--profile"},
      {"table3", "sweep.json", "--out", "rows"},
      {"check", "study.json", "case.json"},
      {"validate", "--list"},
      {"--version"},
      {"--help"},
      {"optimize", "--help"}};
  for (const auto& arguments : calls) {
    SCOPED_TRACE(arguments.front());
    const Outcome outcome = run(">/dev/full", arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_PRED_FORMAT2(IsSubstring, "cannot write standard output: No space left", outcome.err);
    EXPECT_EQ(run(">/dev/full 2>/dev/full", arguments).exit_code, 1);
    EXPECT_EQ(run("2>/dev/full", arguments).exit_code, 0)
        << "the exit code tells what messages cannot";
  }
}

TEST_F(Streams, WhatWasWrongBeforeKeepsItsExitCode) {
  EXPECT_EQ(run(">/dev/full", {"check", "nowhere.json", "study.json"}).exit_code, 2);
  EXPECT_EQ(run(">/dev/full 2>/dev/full", {"optimize"}).exit_code, 2);
}

// As `parapet ... | head` does once head has seen enough.
TEST_F(Streams, AReaderThatLeavesEndsTheProgramQuietlyButNotAsASuccess) {
  std::vector<std::string> arguments{"-c",
                                     "{ sleep 0.3; \"$0\" \"$@\"; echo $? >code; } | true",
                                     parapet_program().string(),
                                     "check",
                                     "study.json",
                                     "case.json"};
  const Outcome outcome = run_program(folder.path(), arguments, "", "/bin/sh");
  EXPECT_EQ(file_text(folder / "code"), "1\n");
  EXPECT_EQ(outcome.err, "");
}

}  // namespace
}  // namespace parapet::test
