// parapet recommend on a tiny study that was optimised before.
#include <gtest/gtest.h>
#include <unistd.h>

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

// A study on a read-only disk, or of somebody else, is read all the same.
TEST_F(Recommend, NeedsNoFolderToWriteTo) {
  const auto make = [&](std::filesystem::perms perms) {
    std::filesystem::permissions(folder / "out", perms);
  };
  // The superuser may write anywhere, so that then the program runs as somebody else.
  std::vector<std::string> words;
  std::filesystem::path program = parapet_program();
  if (::geteuid() == 0) {
    if (!std::filesystem::exists("/usr/bin/setpriv")) GTEST_SKIP() << "no setpriv";
    words = {"--reuid=65534", "--regid=65534", "--clear-groups", program.string()};
    program = "/usr/bin/setpriv";
  }
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  words.insert(words.end(), {"recommend", "out"});
  make(std::filesystem::perms(0555));
  const Outcome outcome = run_program(folder.path(), words, "", program);
  make(std::filesystem::perms(0755));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "## Which variables matter", outcome.out);
  EXPECT_PRED_FORMAT2(IsSubstring, "cannot be written to", outcome.err);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/recommendation.md"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/confirmations.jsonl"));
}

TEST_F(Recommend, WritesElsewhereWhenAskedTo) {
  const Outcome outcome = recommend({"--no-confirm", "--out", "advice"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* file : {"recommendation.md", "recommendation.json", "sensitivity.json"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "advice" / file)) << file;
    EXPECT_FALSE(std::filesystem::exists(folder / "out" / file)) << file;
  }
}

// Files that were edited by hand: the file is named, in words that are not the library's.
TEST_F(Recommend, NamesTheFileThatDoesNotHoldWhatItShould) {
  struct Damage {
    const char* file;
    const char* key;
  };
  for (const Damage& damage : {Damage{"study.json", "spec_hash"}, Damage{"summary.json", "state"},
                               Damage{"study.json", "format"}}) {
    const std::filesystem::path file = folder / "out" / damage.file;
    const std::string sound = file_text(file);
    Json json = Json::parse(sound);
    json[damage.key] = 5;
    folder.write(std::string("out/") + damage.file, json.dump());
    const Outcome outcome = recommend({"--no-confirm"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_PRED_FORMAT2(IsSubstring, damage.file, outcome.err);
    EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "json.exception", outcome.err);
    folder.write(std::string("out/") + damage.file, sound);
  }
}

// The same version may be another program.
TEST_F(Recommend, ResumingUnderAnotherRevisionIsSaid) {
  const std::filesystem::path file = folder / "out/study.json";
  Json json = Json::parse(file_text(file));
  json["provenance"]["git_revision"] = "another";
  folder.write("out/study.json", json.dump());
  const Outcome outcome = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "begun with the revision \"another\"", outcome.err);
  const Outcome again = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "revision", again.err) << "said once";
}

// What a search was begun with, edited by hand.
TEST_F(Recommend, DamagedBeginningIsNamed) {
  Json json = Json::parse(file_text(folder / "out/study.json"));
  json["begun_with"]["jobs"] = "many";
  folder.write("out/study.json", json.dump());
  const Outcome outcome = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_PRED_FORMAT2(IsSubstring, "study.json", outcome.err);
  EXPECT_PRED_FORMAT2(::testing::IsNotSubstring, "json.exception", outcome.err);
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
