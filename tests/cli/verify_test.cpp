// parapet verify: what a folder holds comes out again, and what was changed is named.
#include <gtest/gtest.h>

#include <cmath>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

Outcome verify(const TemporaryFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), "verify");
  return run_program(folder.path(), options);
}

TEST(Verify, StudyWithScenariosComesOutAgainOnAnyNumberOfThreads) {
  const TemporaryFolder folder;
  Json study = tiny_search();
  study["method"]["max_evaluations"] = 3;
  folder.write("study.json", study.dump());
  const Outcome made =
      run_program(folder.path(), {"optimize", "study.json", "--out", "out", "--jobs", "2"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  for (const char* jobs : {"1", "3"}) {
    const Outcome outcome = verify(folder, {"out", "--all", "--jobs", jobs});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_PRED_FORMAT2(IsSubstring, "0001 stiff", outcome.out);
    EXPECT_PRED_FORMAT2(IsSubstring, "9 of 9 simulations run again", outcome.out);
  }
  EXPECT_PRED_FORMAT2(IsSubstring, "2 of 2 simulations run again, of 9",
                      verify(folder, {"out", "--count", "2"}).out);
}

TEST(Verify, ChangedMetricIsNamedWithBothValues) {
  const TemporaryFolder folder;
  folder.write("case.json", tiny_case().dump());
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 0);
  EXPECT_EQ(verify(folder, {"out"}).exit_code, 0);
  Json result = Json::parse(file_text(folder / "out/result.json"));
  const double stored = result["metrics"]["retention_efficiency"].get<double>();
  result["metrics"]["retention_efficiency"] = std::nextafter(stored, 2.0);
  folder.write("out/result.json", result.dump());
  const Outcome outcome = verify(folder, {"out"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED_FORMAT2(IsSubstring, "retention_efficiency: stored ", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "NOT all the same", outcome.out);
}

TEST(Verify, DamageBesideTheSampleIsSaid) {
  const TemporaryFolder folder;
  Json study = tiny_search();
  study["method"]["max_evaluations"] = 3;
  folder.write("study.json", study.dump());
  ASSERT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", "out"}).exit_code, 0);
  EXPECT_EQ(verify(folder, {"out", "--count", "1"}).exit_code, 0);
  std::string log = file_text(folder / "out/evaluations.jsonl");
  const std::size_t digit = log.rfind("\"wall_time_s\":") + 14;
  log[digit] = log[digit] == '1' ? '2' : '1';
  folder.write("out/evaluations.jsonl", log);
  const Outcome outcome = verify(folder, {"out", "--count", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED_FORMAT2(IsSubstring, "line 3", outcome.err);
}

TEST(Verify, SweepComesOutAgain) {
  const TemporaryFolder folder;
  folder.write("sweep.json", tiny_sweep().dump());
  ASSERT_EQ(run_program(folder.path(), {"table3", "sweep.json", "--out", "out"}).exit_code, 0);
  const Outcome outcome = verify(folder, {"out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "lifted", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "3 of 3 simulations", outcome.out);
}

TEST(Verify, FailedSimulationFailsAgain) {
  const TemporaryFolder folder;
  Json spec = tiny_case();
  make_unsolvable(spec);
  folder.write("case.json", spec.dump());
  ASSERT_EQ(run_program(folder.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 1);
  const Outcome outcome = verify(folder, {"out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
}

TEST(Verify, FolderWithoutResultsIsRefused) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "empty");
  std::filesystem::create_directories(folder / "no_rows/rows");
  for (const char* name : {"empty", "nowhere", "no_rows"}) {
    const Outcome outcome = verify(folder, {name});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_PRED_FORMAT2(IsSubstring, "there is nothing to verify here", outcome.err);
  }
}

}  // namespace
}  // namespace parapet::test
