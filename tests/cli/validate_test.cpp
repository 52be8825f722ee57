// `parapet validate` is carried out by a program of its own beside `parapet`.
#include <gtest/gtest.h>

#include <csignal>

#include "program_runner.hpp"

namespace parapet::test {
namespace {

using ::testing::IsSubstring;

std::filesystem::path validate_program() {
  return parapet_program().replace_filename("parapet-validate");
}

TEST(Validate, ListsTheCases) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder.path(), {"validate", "--list"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "water_column", outcome.out);
  EXPECT_EQ(run_program(folder.path(), {"--list"}, "", validate_program()).out, outcome.out);
}

TEST(Validate, IsListedAndHelps) {
  const TemporaryFolder folder;
  EXPECT_PRED_FORMAT2(IsSubstring, "validate                    Verify and validate the solver",
                      run_program(folder.path(), {"--help"}).out);
  const Outcome outcome = run_program(folder.path(), {"validate", "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* words : {"Usage: parapet validate [OPTIONS] [CASE...]", "--strict",
                            "Examples:\n  parapet validate --list"}) {
    EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.out);
  }
}

TEST(Validate, RefusesWrongArguments) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> calls{{"validate", "--quickly"},
                                                    {"validate", "no_such_case"},
                                                    {"validate", "--jobs", "0"},
                                                    {"--log-level", "loud", "validate"},
                                                    {"validate", "--log-level", "loud"}};
  for (const std::vector<std::string>& call : calls) {
    const Outcome outcome = run_program(folder.path(), call);
    EXPECT_EQ(outcome.exit_code, 2) << call.back();
    EXPECT_PRED_FORMAT2(IsSubstring, call[1] == "validate" ? "--log-level" : call[1], outcome.err);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "nothing may be begun";
}

TEST(Validate, WritesAScorecardAndTakesGlobalOptionsBeforeTheVerb) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder.path(), {"--log-level", "error", "validate",
                                                      "ballistic", "--quick", "--out", "cards"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "the level hides the messages";
  EXPECT_PRED_FORMAT2(IsSubstring, "ballistic", outcome.out);
  EXPECT_TRUE(std::filesystem::exists(folder / "cards/ballistic.json"));
}

TEST(Validate, EndsInGoodOrderWhenInterrupted) {
  const TemporaryFolder folder;
  RunningProgram program(folder.path(),
                         {"validate", "taylor_green", "--out", "cards", "--jobs", "1"});
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(folder / "cards"); }));
  program.send(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_PRED_FORMAT2(IsSubstring, "interrupted; continue with: parapet validate taylor_green",
                      outcome.err);
}

TEST(Validate, SaysHowToGetItsProgramWhenThatIsMissing) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(parapet_program(), folder / "parapet");
  const Outcome outcome =
      run_program(folder.path(), {"validate", "--list"}, "", folder / "parapet");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  for (const std::string& words :
       {(folder / "parapet-validate").string(), std::string("No such file"),
        std::string("./parapet validate"), std::string("--target parapet_validate")}) {
    EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.err);
  }
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace
}  // namespace parapet::test
