// Results go only where nobody else's files are, and no link inside a folder is followed.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "study_fixture.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

namespace fs = std::filesystem;
using designs::Json;
using ::testing::IsSubstring;

const std::string victim_text = "what somebody wrote\n";
const std::string design = R"({"deflector_angle_deg": 30, "upstream_height_m": 0.06})";

class ForeignFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder.write("case.json", tiny_case().dump());
    folder.write("sweep.json", tiny_sweep().dump());
    Json study = tiny_study();
    study["method"]["max_evaluations"] = 8;
    folder.write("study.json", study.dump());
    folder.write("victim", victim_text);
  }

  Outcome run(const std::vector<std::string>& arguments) const {
    return run_program(folder.path(), arguments);
  }

  /// The call of each verb that writes into a folder.
  static std::vector<std::vector<std::string>> calls(const std::string& out) {
    return {{"simulate", "case.json", "--out", out},
            {"table3", "sweep.json", "--out", out},
            {"optimize", "study.json", "--out", out},
            {"evaluate", "study.json", "--design", design, "--log", out}};
  }

  std::size_t entries(const std::string& name) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder / name), {}));
  }

  TemporaryFolder folder;
};

TEST_F(ForeignFolder, IsRefusedAndNotTouched) {
  fs::create_directory(folder / "thesis");
  folder.write("thesis/chapter.tex", victim_text);
  for (const auto& call : calls("thesis")) {
    const Outcome outcome = run(call);
    EXPECT_EQ(outcome.exit_code, 2) << call[0] << outcome.err;
    EXPECT_PRED_FORMAT2(IsSubstring, "is not Parapet's", outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "chapter.tex", outcome.err);
    EXPECT_PRED_FORMAT2(IsSubstring, "--out", outcome.err);
    EXPECT_EQ(entries("thesis"), 1U) << call[0];
  }
  EXPECT_EQ(file_text(folder / "thesis/chapter.tex"), victim_text);
}

TEST_F(ForeignFolder, WithASpecOfOnesOwnIsNotTakenForResults) {
  EXPECT_EQ(run({"optimize", "study.json", "--out", "."}).exit_code, 2);
  EXPECT_EQ(run({"simulate", "case.json", "--out", "."}).exit_code, 2);
  EXPECT_FALSE(fs::exists(folder / ".lock"));
}

TEST_F(ForeignFolder, OfAnotherVerbIsRefused) {
  ASSERT_EQ(run({"optimize", "study.json", "--out", "study"}).exit_code, 0);
  ASSERT_EQ(run({"simulate", "case.json", "--out", "simulation"}).exit_code, 0);
  for (const auto& call : {std::vector<std::string>{"simulate", "case.json", "--out", "study"},
                           std::vector<std::string>{"table3", "sweep.json", "--out", "study"}}) {
    const Outcome outcome = run(call);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_PRED_FORMAT2(IsSubstring, "holds results of a study", outcome.err);
  }
  EXPECT_EQ(run({"optimize", "study.json", "--out", "simulation"}).exit_code, 2);
}

TEST_F(ForeignFolder, IsRefusedByValidateAndRecommendToo) {
  fs::create_directory(folder / "thesis");
  folder.write("thesis/README.md", victim_text);
  ASSERT_EQ(run({"optimize", "study.json", "--out", "study"}).exit_code, 0);
  const std::vector<std::string> advise{"recommend", "study", "--no-confirm", "--out"};
  const auto advise_into = [&](const std::string& out) {
    auto call = advise;
    call.push_back(out);
    return run(call);
  };
  EXPECT_EQ(run({"validate", "--pages-only", "--out", "thesis"}).exit_code, 2);
  EXPECT_EQ(advise_into("thesis").exit_code, 2);
  EXPECT_EQ(entries("thesis"), 1U);
  EXPECT_EQ(file_text(folder / "thesis/README.md"), victim_text);
  EXPECT_EQ(advise_into("advice").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "advice/recommendation.json"));
  EXPECT_EQ(advise_into("advice").exit_code, 0) << "its own";
  EXPECT_EQ(advise_into("study").exit_code, 0) << "the study's";
  ASSERT_EQ(run({"optimize", "study.json", "--out", "other"}).exit_code, 0);
  EXPECT_EQ(advise_into("other").exit_code, 2) << "another study's";
}

TEST_F(ForeignFolder, EmptyOneIsTakenAndSoIsOneOfAnEarlierVersion) {
  for (const auto& call : calls("new")) {
    fs::remove_all(folder / "new");
    fs::create_directory(folder / "new");
    EXPECT_EQ(run(call).exit_code, 0) << call[0];
    fs::remove(folder / "new/.parapet");  // 0.1.0 wrote none
    EXPECT_EQ(run(call).exit_code, 0) << call[0];
  }
}

TEST_F(ForeignFolder, LinkInThePathIsFollowed) {
  fs::create_directory(folder / "disk");
  fs::create_directory_symlink(folder / "disk", folder / "link");
  EXPECT_EQ(run({"simulate", "case.json", "--out", "link/new/out"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "disk/new/out/result.json"));
  EXPECT_EQ(run({"simulate", "case.json", "--out", "link"}).exit_code, 2) << "it holds a folder";
}

TEST_F(ForeignFolder, LinkInsideIsRefusedAndItsTargetUntouched) {
  for (const char* name :
       {".lock", ".parapet", "evaluations.jsonl", "study.json", "result.json", "series.csv",
        "summary.json", "checksums.sha256", "tiny.json", "evaluations.jsonl.damaged"}) {
    for (const auto& call : calls("out")) {
      SCOPED_TRACE(call[0] + " " + name);
      fs::remove_all(folder / "out");
      fs::create_directory(folder / "out");
      fs::create_symlink(folder / "victim", folder / (std::string("out/") + name));
      const Outcome outcome = run(call);
      EXPECT_EQ(outcome.exit_code, 2);
      EXPECT_PRED_FORMAT2(IsSubstring, "is a link", outcome.err);
      EXPECT_EQ(file_text(folder / "victim"), victim_text);
      EXPECT_EQ(entries("out"), 1U);
    }
  }
}

TEST_F(ForeignFolder, LinkedFolderInsideIsRefused) {
  fs::create_directory(folder / "elsewhere");
  for (const char* name : {"evaluations", "rows", "frames"}) {
    fs::remove_all(folder / "out");
    fs::create_directory(folder / "out");
    fs::create_directory_symlink(folder / "elsewhere", folder / (std::string("out/") + name));
    for (const auto& call : calls("out")) EXPECT_EQ(run(call).exit_code, 2) << name;
    EXPECT_EQ(entries("elsewhere"), 0U);
  }
}

TEST_F(ForeignFolder, RecommendFollowsNoLinkEither) {
  ASSERT_EQ(run({"optimize", "study.json", "--out", "out"}).exit_code, 0);
  fs::create_symlink(folder / "victim", folder / "out/recommendation.md");
  const Outcome outcome = run({"recommend", "out", "--no-confirm"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "is a link", outcome.err);
  EXPECT_EQ(file_text(folder / "victim"), victim_text);
}

TEST_F(ForeignFolder, FileWithASecondNameIsNotWrittenInPlace) {
  fs::create_directory(folder / "out");
  fs::create_hard_link(folder / "victim", folder / "out/.lock");
  const Outcome outcome = run({"simulate", "case.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_PRED_FORMAT2(IsSubstring, "another name", outcome.err);
  EXPECT_EQ(file_text(folder / "victim"), victim_text);
}

TEST_F(ForeignFolder, NamesThatDifferInOneLetterDoNotShareAFolder) {
  for (const char* name : {"Bär", "Bör", "B r"}) {
    Json spec = tiny_case();
    spec["name"] = name;
    folder.write("case.json", spec.dump());
    EXPECT_EQ(run({"simulate", "case.json"}).exit_code, 0);
  }
  EXPECT_EQ(entries("runs"), 3U);
  EXPECT_EQ(records::file_name("plain-name_1.0"), "plain-name_1.0");
  EXPECT_EQ(records::file_name("a b").substr(0, 4), "a_b-");
  EXPECT_EQ(records::file_name("a b").size(), 12U);
  EXPECT_NE(records::file_name(".."), "..");
}

TEST_F(ForeignFolder, NameOfASweepIsNoPath) {
  Json sweep = tiny_sweep();
  sweep["name"] = "../../escaped";
  folder.write("sweep.json", sweep.dump());
  fs::create_directory(folder / "deep");
  ASSERT_EQ(run({"table3", "sweep.json", "--out", "deep/out", "--only", "bare"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "escaped.json"));
  EXPECT_TRUE(fs::exists(folder / ("deep/out/" + records::file_name("../../escaped") + ".json")));
}

TEST_F(ForeignFolder, FilesOfAnEarlierCaseDoNotStayBesideANewResult) {
  ASSERT_EQ(run({"simulate", "case.json", "--out", "out", "--frames", "--picture"}).exit_code, 0);
  ASSERT_TRUE(fs::exists(folder / "out/frames/tiny.pvd"));
  ASSERT_TRUE(fs::exists(folder / "out/flow.png"));
  Json other = tiny_case();
  other["name"] = "other";
  folder.write("case.json", other.dump());
  ASSERT_EQ(run({"simulate", "case.json", "--out", "out"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "out/frames"));
  EXPECT_FALSE(fs::exists(folder / "out/flow.png"));
  ASSERT_EQ(run({"simulate", "case.json", "--out", "out", "--frames"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "out/frames/tiny.pvd"));
  const Outcome sums =
      run_program(folder / "out", {"-c", "sha256sum --quiet -c checksums.sha256"}, "", "/bin/sh");
  EXPECT_EQ(sums.exit_code, 0) << sums.out << sums.err;
}

TEST_F(ForeignFolder, RowsOfAnotherSweepAreNotMixed) {
  ASSERT_EQ(run({"table3", "sweep.json", "--out", "out"}).exit_code, 0);
  const Outcome sums =
      run_program(folder / "out", {"-c", "sha256sum --quiet -c checksums.sha256"}, "", "/bin/sh");
  EXPECT_EQ(sums.exit_code, 0) << sums.out << sums.err;
  Json sweep = tiny_sweep();
  sweep["rows"].erase(0);
  folder.write("sweep.json", sweep.dump());
  const Outcome outcome = run({"table3", "sweep.json", "--out", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "bare.json", outcome.err);
}

TEST_F(ForeignFolder, OrphansOfACrashAreRemovedAndFilesBeingWrittenAreNot) {
  ASSERT_EQ(run({"optimize", "study.json", "--out", "out"}).exit_code, 0);
  const std::vector<std::string> orphans{
      "out/.parapet-0123456789abcdef.tmp", "out/summary.json.tmp4711",
      "out/evaluations/.parapet-ffffffffffffffff.tmp", "out/evaluations/0001.json.tmp12"};
  for (const std::string& name : orphans) folder.write(name, "half");
  const std::string busy = folder.write("out/.parapet-aaaaaaaaaaaaaaaa.tmp", "half");
  const int descriptor = ::open(busy.c_str(), O_RDWR);
  ASSERT_EQ(::flock(descriptor, LOCK_EX), 0);
  folder.write("out/notes.tmp", victim_text);
  EXPECT_EQ(run({"optimize", "study.json", "--out", "out"}).exit_code, 0);
  ::close(descriptor);
  for (const std::string& name : orphans) EXPECT_FALSE(fs::exists(folder / name)) << name;
  EXPECT_TRUE(fs::exists(busy));
  EXPECT_TRUE(fs::exists(folder / "out/notes.tmp"));
}

}  // namespace
}  // namespace parapet::test
