// parapet recommend on a tiny study that was optimised before.
#include <gtest/gtest.h>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

class Recommend : public ::testing::Test {
 protected:
  void SetUp() override {
    Json study = tiny_study();
    study["method"]["max_evaluations"] = 8;
    folder.write("study.json", study.dump());
    const Outcome outcome = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  Outcome recommend(std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"recommend", "out"});
    return run_program(folder.path(), options);
  }

  TemporaryFolder folder;
};

TEST_F(Recommend, ConfirmsItsPickOnce) {
  const Outcome first = recommend({"--repeats", "1"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::string lines = file_text(folder / "out/confirmations.jsonl");
  EXPECT_FALSE(lines.empty());
  const Json json = Json::parse(file_text(folder / "out/recommendation.json"));
  EXPECT_NE(json["confirmation"]["verdict"], "none");
  EXPECT_EQ(Json::parse(file_text(folder / "out/sensitivity.json"))["format"],
            "parapet-sensitivity/1");
  const std::string text = file_text(folder / "out/recommendation.md");
  EXPECT_PRED_FORMAT2(IsSubstring, "## Which variables matter", text);
  const Outcome second = recommend({"--repeats", "1"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(file_text(folder / "out/confirmations.jsonl"), lines) << "nothing simulated again";
  EXPECT_EQ(file_text(folder / "out/recommendation.md"), text);
}

TEST_F(Recommend, SimulatesNothingWhenAskedNotTo) {
  const Outcome outcome = recommend({"--no-confirm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out/confirmations.jsonl"));
  EXPECT_PRED_FORMAT2(IsSubstring, "not simulated again", outcome.out);
}

TEST_F(Recommend, NamesARuleThatDoesNotFit) {
  const Outcome outcome = recommend({"--rule", "knee"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "--rule", outcome.err);
  EXPECT_PRED_FORMAT2(IsSubstring, "one objective", outcome.err);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/confirmations.jsonl"));
}

}  // namespace
}  // namespace parapet::test
