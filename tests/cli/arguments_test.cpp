// What the command line accepts, and how it says what it does not.
#include <gtest/gtest.h>

#include <regex>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using ::testing::IsSubstring;

TEST(Help, ProgramListsVerbsAndExitCodes) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder.path(), {"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* words :
       {"simulate", "table3", "optimize", "evaluate", "recommend", "check", "Examples:",
        "Exit codes: 0 done, 1 a run failed or a file could not be read or written, 2 bad input"}) {
    EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.out);
  }
}

class VerbHelp : public ::testing::TestWithParam<const char*> {};

TEST_P(VerbHelp, ShowsUsageAndExamples) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder.path(), {GetParam(), "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_PRED_FORMAT2(IsSubstring, std::string("Usage: parapet ") + GetParam(), outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "Examples:\n  parapet ", outcome.out);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "help must not write anything";
}

INSTANTIATE_TEST_SUITE_P(Verbs, VerbHelp,
                         ::testing::Values("simulate", "table3", "optimize", "recommend", "check"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Help, EvaluateShowsUsageAndExamples) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder.path(), {"evaluate", "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_PRED_FORMAT2(IsSubstring, "--design JSON", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "| parapet evaluate", outcome.out);
}

TEST(Version, IsPrinted) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder.path(), {"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(std::regex_match(outcome.out, std::regex("parapet [0-9]+\\.[0-9]+\\.[0-9]+.*\n")));
}

struct WrongCall {
  const char* name;
  std::vector<std::string> arguments;
  std::vector<std::string> words;  // on standard error
};

void PrintTo(const WrongCall& call, std::ostream* out) {
  *out << call.name;
}

class WrongArguments : public ::testing::TestWithParam<WrongCall> {};

TEST_P(WrongArguments, EndWithTwoAndSayWhy) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  folder.write("study.json", tiny_study().dump());
  folder.write("sweep.json", tiny_sweep().dump());
  folder.write("plain_file", "not a folder");
  const Outcome outcome = run_program(folder.path(), GetParam().arguments);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  for (const std::string& words : GetParam().words)
    EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.err);
  EXPECT_EQ(outcome.out, "");
  EXPECT_FALSE(std::filesystem::exists(folder / "runs")) << "nothing may be begun";
}

INSTANTIATE_TEST_SUITE_P(
    Calls, WrongArguments,
    ::testing::Values(
        WrongCall{"UnknownVerb", {"fly"}, {"fly"}}, WrongCall{"NoVerb", {}, {"Usage", "simulate"}},
        WrongCall{
            "UnknownOption", {"simulate", "case.json", "--spaceing-mm", "5"}, {"--spaceing-mm"}},
        WrongCall{"NoSpec", {"optimize"}, {"SPEC", "required"}},
        WrongCall{"NoDesign", {"evaluate", "study.json"}, {"--design", "required"}},
        WrongCall{"JobsZero", {"optimize", "study.json", "--jobs", "0"}, {"--jobs", "1 to 1024"}},
        WrongCall{"JobsText", {"optimize", "study.json", "--jobs", "many"}, {"--jobs", "many"}},
        WrongCall{"ThreadsWithUncertainty",
                  {"simulate", "case.json", "--uncertainty", "--threads", "2"},
                  {"--uncertainty", "excludes", "--threads"}},
        WrongCall{"SpacingNegative",
                  {"simulate", "case.json", "--spacing-mm", "-5"},
                  {"--spacing-mm", "-5"}},
        WrongCall{"SpacingTooCoarse",
                  {"simulate", "case.json", "--spacing-mm", "900"},
                  {"case.json with --spacing-mm", "/numerics/spacing_m"}},
        WrongCall{
            "LogLevel", {"--log-level", "loud", "check", "case.json"}, {"--log-level", "loud"}},
        WrongCall{"MissingFile",
                  {"simulate", "nowhere.json"},
                  {"nowhere.json", "no such file", "quickstart"}},
        WrongCall{"FolderAsFile", {"simulate", "."}, {"is a folder"}},
        WrongCall{"StudyToSimulate",
                  {"simulate", "study.json"},
                  {"/format", "parapet-study/1", "parapet optimize"}},
        WrongCall{"CaseToOptimize",
                  {"optimize", "case.json"},
                  {"/format", "parapet-case/1", "parapet simulate"}},
        WrongCall{"CaseToTable3", {"table3", "case.json"}, {"/format", "parapet-sweep/1"}},
        WrongCall{"UnknownRow",
                  {"table3", "sweep.json", "--only", "flat,steep"},
                  {"--only: steep", "bare, lifted, flat"}},
        WrongCall{"RecommendNowhere", {"recommend", "nowhere"}, {"nowhere", "study.json"}},
        WrongCall{"PictureTime",
                  {"simulate", "case.json", "--picture-times-s", "soon"},
                  {"--picture-times-s", "soon"}}),
    [](const auto& test) { return std::string(test.param.name); });

// The disk, and what cannot be written on it, are no bad input.
TEST(FileTrouble, EndsWithOne) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  folder.write("study.json", tiny_study().dump());
  folder.write("plain_file", "not a folder");
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"simulate", "case.json", "--out", "plain_file"},
           {"optimize", "study.json", "--out", "plain_file/deeper"}}) {
    const Outcome outcome = run_program(folder.path(), arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "cannot ", outcome.err);
  }
  // A disk without room for the files: none may grow beyond half a kilobyte.
  const std::string full = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
  const Outcome outcome = run_program(
      folder.path(),
      {"-c", full, parapet_program().string(), "optimize", "study.json", "--out", "out"}, "",
      "/bin/sh");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "cannot write", outcome.err);
}

TEST(Check, SaysWhatTheSimulationsWillCost) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  folder.write("study.json", tiny_search().dump());
  folder.write("sweep.json", tiny_sweep().dump());
  const Outcome outcome =
      run_program(folder.path(), {"check", "case.json", "study.json", "sweep.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"each simulation at 20 mm: 50 particles, about ", " time steps, ",
                            " of one core at 2.6 GHz, ", " MiB",
                            "at most 12 designs, 36 simulations, ", "for each job", "all rows: "}) {
    EXPECT_PRED_FORMAT2(IsSubstring, words, outcome.out);
  }
}

// Before anything is begun, with the key that is to be changed.
TEST(Check, RefusesWhatCannotRun) {
  const TemporaryFolder folder;
  designs::Json samples = tiny_case();
  samples["run"] = {{"stop_time_s", 10000.0}, {"series_interval_s", 1e-5}};
  samples["run"]["settled"]["enabled"] = false;
  folder.write("samples.json", samples.dump());
  for (const char* verb : {"check", "simulate"}) {
    const Outcome outcome = run_program(folder.path(), {verb, "samples.json"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_PRED_FORMAT2(IsSubstring, "samples.json: /run/series_interval_s: ", outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "MiB of memory", outcome.err);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "runs"));
}

TEST(Check, AcceptsEveryShippedSpec) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"check"};
  for (const auto& entry : std::filesystem::directory_iterator(PARAPET_DESIGNS)) {
    if (entry.path().extension() == ".json") arguments.push_back(entry.path().string());
  }
  ASSERT_GE(arguments.size(), 4U);
  const Outcome outcome = run_program(folder.path(), arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    EXPECT_PRED_FORMAT2(IsSubstring, arguments[k] + ": ok (", outcome.out);
  }
}

TEST(Check, FindsShippedSpecsByNameAnywhere) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program(folder.path(), {"check", "designs/quickstart.json", "table3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "table3: ok (sweep, 15 rows)", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "designs/quickstart.json: ok (study, ", outcome.out);
}

TEST(Check, SaysEveryErrorOfEveryFileAtOnce) {
  const TemporaryFolder folder;
  designs::Json wrong = tiny_case();
  wrong["barriers"][0]["height_m"] = -1;
  wrong["numerics"]["spacing_m"] = "fine";
  folder.write("wrong.json", wrong.dump());
  folder.write("sound.json", tiny_case().dump());
  const Outcome outcome =
      run_program(folder.path(), {"check", "wrong.json", "sound.json", "missing.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out.find("sound.json: ok (case, 1 barrier)\n"), 0U) << outcome.out;
  EXPECT_PRED_FORMAT2(IsSubstring, "wrong.json: /barriers/0/height_m: -1", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "wrong.json: /numerics/spacing_m: \"fine\"", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "missing.json", outcome.err);
}

}  // namespace
}  // namespace parapet::test
