// One study per folder, one writer at a time.
#include "parapet/records/folder_lock.hpp"
#include "study_fixture.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

class StudyFolderRules : public StudyTest {};

TEST_F(StudyFolderRules, AnotherStudyIsRefusedAndNothingIsTouched) {
  const auto before = contents("calm");
  Json other = tiny_study();
  other["variables"]["deflector_angle_deg"]["upper"] = 50;
  folder.write("study.json", other.dump());
  const Outcome outcome = run_program(folder.path(), command("calm"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "belongs to another study", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "--out", outcome.err);
  EXPECT_EQ(contents("calm"), before);
}

TEST_F(StudyFolderRules, AnotherSpacingIsAnotherStudy) {
  std::vector<std::string> arguments = command("calm");
  arguments.insert(arguments.end(), {"--spacing-mm", "25"});
  EXPECT_EQ(run_program(folder.path(), arguments).exit_code, 2);
}

TEST_F(StudyFolderRules, AnotherNameIsTheSameStudy) {
  Json renamed = tiny_study();
  renamed["name"] = "renamed";
  renamed["description"] = "the same question";
  folder.write("study.json", renamed.dump());
  const std::string log = file_text(log_of("calm"));
  EXPECT_EQ(run_program(folder.path(), command("calm")).exit_code, 0);
  EXPECT_EQ(file_text(log_of("calm")), log);
}

TEST_F(StudyFolderRules, LogWithoutStudyJsonIsRefused) {
  std::filesystem::remove(folder / "calm/study.json");
  const auto before = contents("calm");
  const Outcome outcome = run_program(folder.path(), command("calm"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "study.json", outcome.err);
  EXPECT_EQ(contents("calm"), before);
}

TEST_F(StudyFolderRules, SecondWriterIsRefusedWhileTheFirstWrites) {
  const auto before = contents("calm");
  {
    const records::FolderLock lock(folder / "calm");
    const Outcome outcome = run_program(folder.path(), command("calm"));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_PRED_FORMAT2(IsSubstring, "another parapet process", outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "is writing into this folder", outcome.err);
    EXPECT_EQ(contents("calm"), before);
  }
  EXPECT_EQ(run_program(folder.path(), command("calm")).exit_code, 0);
}

TEST_F(StudyFolderRules, DesignsFromOutsideJoinTheLogWithoutDisturbingTheStudy) {
  ASSERT_EQ(run_program(folder.path(),
                        {"evaluate", "study.json", "--log", "mixed", "--jobs", "1", "--design",
                         R"({"deflector_angle_deg": 30, "upstream_height_m": 0.06})"})
                .exit_code,
            0);  // the study's own first start
  const Outcome outcome = run_program(folder.path(), command("mixed"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(line_count(log_of("mixed")), line_count(log_of("calm"))) << "it was not run again";
  EXPECT_EQ(summary_of("mixed")["best"]["design"], summary_of("calm")["best"]["design"]);
}

}  // namespace
}  // namespace parapet::test
