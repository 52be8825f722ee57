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
  std::vector<std::string> call{"optimize", "spec.json", "--out", "study", "--jobs", "1"};
  const Outcome refused = run_program(folder.path(), call);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "study.json: /physics: [1]", refused.err)
      << "the same study, although defaults have changed and keys are new since then";
  EXPECT_EQ(file_text(folder / "study/evaluations.jsonl"), log);
  call.emplace_back("--mix-revisions");
  const Outcome outcome = run_program(folder.path(), call);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "6 of its lines have no checksum", outcome.err);
  const std::string now = file_text(folder / "study/evaluations.jsonl");
  EXPECT_EQ(now.substr(0, log.size()), log) << "earlier lines stay as they are";
  EXPECT_EQ(evaluations_in(folder / "study/evaluations.jsonl"), 8U);
  EXPECT_EQ(Json::parse(file_text(folder / "study/study.json"))["format"], "parapet-study-state/2");
  EXPECT_TRUE(std::filesystem::exists(folder / "study/checksums.sha256"));
}

/// What study.json says, with one member replaced and no list of checksums beside it.
void replace_in_state(const TemporaryFolder& folder, const char* key, const Json& value) {
  Json state = Json::parse(file_text(folder / "study/study.json"));
  state[key] = value;
  folder.write("study/study.json", state.dump());
  std::filesystem::remove(folder / "study/checksums.sha256");
}

// A setting that the earlier version had, and that its user chose, still makes another study.
TEST_F(EarlierFolder, WithAnotherSettingIsAnotherStudys) {
  for (const char* change :
       {R"({"numerics": {"cg_tolerance_m_s2": 0.04}})", R"({"numerics": {"sound_speed_floor": 1}})",
        R"({"material": {"yield_stress_pa": 91}})"}) {
    Json other = spec;
    other["case"].merge_patch(Json::parse(change));
    folder.write("other.json", other.dump());
    const Outcome outcome =
        run_program(folder.path(), {"optimize", "other.json", "--out", "study", "--mix-revisions"});
    EXPECT_EQ(outcome.exit_code, 2) << change;
    EXPECT_PRED_FORMAT2(IsSubstring, "belongs to another study", outcome.err) << change;
  }
}

TEST_F(EarlierFolder, OfOtherPhysicsIsContinuedOnlyWhenThatIsAskedFor) {
  replace_in_state(folder, "physics", {99});
  const std::string state = file_text(folder / "study/study.json");
  spec["method"]["max_evaluations"] = 7;
  folder.write("spec.json", spec.dump());
  const std::vector<std::string> call{"optimize", "spec.json", "--out", "study", "--jobs", "1"};
  const Outcome refused = run_program(folder.path(), call);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "study.json: /physics: [99]", refused.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "--mix-revisions", refused.err);
  EXPECT_EQ(file_text(folder / "study/study.json"), state) << "nothing is changed";
  EXPECT_EQ(evaluations_in(folder / "study/evaluations.jsonl"), 6U);

  const Outcome advice = run_program(folder.path(), {"recommend", "study", "--repeats", "2"});
  EXPECT_EQ(advice.exit_code, 0) << advice.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "nothing is simulated again", advice.err);

  auto mixing = call;
  mixing.emplace_back("--mix-revisions");
  const Outcome mixed = run_program(folder.path(), mixing);
  EXPECT_EQ(mixed.exit_code, 0) << mixed.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "their numbers do not compare", mixed.err);
  EXPECT_EQ(evaluations_in(folder / "study/evaluations.jsonl"), 7U);
  EXPECT_EQ(run_program(folder.path(), call).exit_code, 0) << "it is mixed already";
  const Outcome mixed_advice = run_program(folder.path(), {"recommend", "study", "--no-confirm"});
  EXPECT_PRED_FORMAT2(IsSubstring, "their numbers do not compare", mixed_advice.err);
}

TEST_F(EarlierFolder, OfANewerFormatIsRefusedByName) {
  replace_in_state(folder, "format", "parapet-study-state/3");
  folder.write("spec.json", spec.dump());
  for (const auto& call : {std::vector<std::string>{"optimize", "spec.json", "--out", "study"},
                           std::vector<std::string>{"recommend", "study"},
                           std::vector<std::string>{"verify", "study"}}) {
    const Outcome outcome = run_program(folder.path(), call);
    EXPECT_EQ(outcome.exit_code, 2) << call[0];
    EXPECT_PRED_FORMAT2(IsSubstring, "\"parapet-study-state/3\"", outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "a newer version of the program wrote this", outcome.err);
  }
}

TEST_F(EarlierFolder, IsFoundAgainUnderItsName) {
  std::filesystem::create_directory(folder / "runs");
  // "tiny study of 0.1.0" with blanks: version 0.1.0 put no hash behind it.
  std::filesystem::rename(folder / "study", folder / "runs/tiny_study_of_0.1.0-optimize");
  folder.write("spec.json", spec.dump());
  const Outcome outcome =
      run_program(folder.path(), {"optimize", "spec.json", "--jobs", "1", "--mix-revisions"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "resuming", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "0 by this run", outcome.out);
}

}  // namespace
}  // namespace parapet::test
