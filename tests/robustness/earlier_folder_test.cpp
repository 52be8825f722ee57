// A study folder as version 0.1.0 wrote it, before lines had checksums: read, reported and resumed.
#include <algorithm>

#include "study_fixture.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

class EarlierFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path kept = PARAPET_EARLIER_FOLDER;
    std::filesystem::copy(kept / "study", folder / "study",
                          std::filesystem::copy_options::recursive);
    spec = Json::parse(file_text(kept / "spec.json"));
  }

  TemporaryFolder folder;
  Json spec;
};

TEST_F(EarlierFolder, IsReported) {
  const std::string log = file_text(folder / "study/evaluations.jsonl");
  const Outcome outcome =
      run_program(folder.path(), {"recommend", "study", "--repeats", "1", "--jobs", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "design 0004", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "6 of its lines have no checksum", outcome.err);
  EXPECT_EQ(line_count(folder / "study/confirmations.jsonl"), 1U) << "it was confirmed before";
  EXPECT_EQ(file_text(folder / "study/evaluations.jsonl"), log);
}

TEST_F(EarlierFolder, IsResumedWithTheSameLinesAndTheirSuccessors) {
  const std::string log = file_text(folder / "study/evaluations.jsonl");
  spec["method"]["max_evaluations"] = 8;
  folder.write("spec.json", spec.dump());
  const Outcome outcome =
      run_program(folder.path(), {"optimize", "spec.json", "--out", "study", "--jobs", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "6 of its lines have no checksum", outcome.err);
  const std::string now = file_text(folder / "study/evaluations.jsonl");
  EXPECT_EQ(now.substr(0, log.size()), log) << "earlier lines stay as they are";
  EXPECT_EQ(evaluations_in(folder / "study/evaluations.jsonl"), 8U);
  EXPECT_EQ(Json::parse(file_text(folder / "study/study.json"))["format"], "parapet-study-state/2");
  EXPECT_TRUE(std::filesystem::exists(folder / "study/checksums.sha256"));
}

TEST_F(EarlierFolder, IsFoundAgainUnderItsName) {
  std::filesystem::create_directory(folder / "runs");
  // "tiny study of 0.1.0" with blanks: version 0.1.0 put no hash behind it.
  std::filesystem::rename(folder / "study", folder / "runs/tiny_study_of_0.1.0-optimize");
  folder.write("spec.json", spec.dump());
  const Outcome outcome = run_program(folder.path(), {"optimize", "spec.json", "--jobs", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "resuming", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "0 by this run", outcome.out);
}

}  // namespace
}  // namespace parapet::test
