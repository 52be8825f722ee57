// Names that try to act: on the terminal, in Markdown, in a shell.
#include <algorithm>

#include "study_fixture.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsSubstring;

const std::string wicked =
    "<script>x</script> **bold** [a](javascript:y) `code` ![p](http://x/y) www.example.org a|b $x$ "
    "~~s~~";

/// Whether a text holds a character that acts on a terminal, other than the end of a line.
bool acts_on_terminal(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == '\x7f';
  });
}

Json hostile_study() {
  Json study = tiny_study();
  study["name"] = wicked;
  study["description"] = wicked;
  study["case"]["name"] = wicked;
  study["case"]["reservoir"]["height_m"] = 0.12;
  study["case"]["numerics"]["spacing_m"] = 0.03;
  study["objectives"] = Json::array(
      {{{"name", wicked}, {"metric", "barrier_1_slam_force_n_per_m"}, {"goal", "minimize"}},
       {{"metric", "retention_efficiency"}, {"goal", "maximize"}}});
  study["constraints"][0]["name"] = wicked;
  study["scenarios"] =
      Json::array({{{"name", wicked}, {"weight", 0.5}, {"set", {{"yield_stress_pa", 40}}}},
                   {{"name", "usual"}, {"weight", 0.5}, {"set", {{"yield_stress_pa", 90}}}}});
  study["variables"]["upstream_height_m"]["lower"] = 0.065;
  study["method"] = Json::parse(R"({"algorithm": "SOBOL", "max_evaluations": 6, "seed": 1})");
  return study;
}

void expect_harmless(const std::string& markdown) {
  EXPECT_EQ(markdown.find("<script"), std::string::npos);
  EXPECT_EQ(markdown.find("**bold**"), std::string::npos);
  EXPECT_EQ(markdown.find("](javascript"), std::string::npos);
  EXPECT_EQ(markdown.find("](http://x"), std::string::npos);
  EXPECT_EQ(markdown.find("http://"), std::string::npos);
  EXPECT_EQ(markdown.find("www.example"), std::string::npos);
  EXPECT_EQ(markdown.find(" `code`"), std::string::npos);
  EXPECT_FALSE(acts_on_terminal(markdown));
}

TEST(HostileText, NamesOfASpecAreShownAndDoNothing) {
  const TemporaryFolder folder;
  folder.write("study.json", hostile_study().dump());
  const Outcome check = run_program(folder.path(), {"check", "study.json"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  const Outcome optimum = run_program(folder.path(), {"optimize", "study.json", "--out", "out"});
  ASSERT_EQ(optimum.exit_code, 0) << optimum.err;
  const Outcome advice = run_program(folder.path(), {"recommend", "out", "--repeats", "1"});
  ASSERT_EQ(advice.exit_code, 0) << advice.err;
  const std::string markdown = file_text(folder / "out/recommendation.md");
  EXPECT_PRED_FORMAT2(IsSubstring, "&lt;script&gt;x", markdown);
  expect_harmless(markdown);
  // As many columns in each row of a table as in its heading.
  std::size_t columns = 0;
  for (std::size_t begin = 0; begin < markdown.size(); begin = markdown.find('\n', begin) + 1) {
    const std::string line = markdown.substr(begin, markdown.find('\n', begin) - begin);
    std::size_t bars = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
      bars += line[k] == '|' && (k == 0 || line[k - 1] != '\\') ? 1 : 0;
    }
    if (line.empty() || line.front() != '|') columns = 0;
    if (columns == 0) columns = bars;
    EXPECT_EQ(bars, columns) << line;
  }
  EXPECT_EQ(Json::parse(file_text(folder / "out/recommendation.json"))["study"]["name"], wicked)
      << "a program gets the name as it is";
}

TEST(HostileText, ControlCharactersAreRefusedWithTheirPlace) {
  const TemporaryFolder folder;
  const std::vector<std::string> controls{"\x1b]0;title\x07",
                                          "\x1b[2J",
                                          "a\nb",
                                          "a\tb",
                                          "a\rb",
                                          "\x7f",
                                          std::string("\xc2\x9b") + "31m",
                                          "\xe2\x80\xae",
                                          "\xe2\x81\xa6",
                                          "\xe2\x80\xa8",
                                          std::string("a\0b", 3)};
  for (const std::string& control : controls) {
    for (const char* place :
         {"/name", "/description", "/case/name", "/constraints/0/name", "/constraints/0/expression",
          "/objectives/0/metric", "/method/algorithm"}) {
      Json study = tiny_study();
      study[Json::json_pointer(place)] = "a" + control;
      folder.write("study.json", study.dump());
      const Outcome outcome = run_program(folder.path(), {"check", "study.json"});
      EXPECT_EQ(outcome.exit_code, 2) << place;
      EXPECT_PRED_FORMAT2(IsSubstring, place, outcome.err);
      EXPECT_PRED_FORMAT2(IsSubstring, "control character", outcome.err);
      EXPECT_FALSE(acts_on_terminal(outcome.err)) << outcome.err;
    }
  }
  Json study = tiny_study();
  study["variables"]["a\x1b[31m"] = study["variables"]["upstream_height_m"];
  folder.write("study.json", study.dump());
  Json spec = tiny_case();
  spec["name"] = "a\x1b[31m";
  folder.write("case.json", spec.dump());
  Json sweep = tiny_sweep();
  sweep["rows"][0]["description"] = "a\x1b[31m";
  folder.write("sweep.json", sweep.dump());
  for (const char* file : {"study.json", "case.json", "sweep.json"}) {
    const Outcome outcome = run_program(folder.path(), {"check", file});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_PRED_FORMAT2(IsSubstring, "\\u001b[31m", outcome.err);
    EXPECT_FALSE(acts_on_terminal(outcome.err)) << outcome.err;
  }
}

TEST(HostileText, ArgumentsAndFileNamesDoNotActEither) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"check", "\x1b[31mno.json"},
        std::vector<std::string>{"\x1b[31mverb"},
        std::vector<std::string>{"recommend", "\x1b[31mfolder"},
        std::vector<std::string>{"optimize", "quickstart", "--jobs", "\x1b[31m"}}) {
    const Outcome outcome = run_program(folder.path(), arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_FALSE(acts_on_terminal(outcome.out + outcome.err)) << outcome.err;
  }
}

// A folder of a stranger: its texts were never checked.
TEST(HostileText, StoredFoldersDoNotActEither) {
  const TemporaryFolder folder;
  Json study = tiny_study();
  study["method"] = Json::parse(R"({"algorithm": "SOBOL", "max_evaluations": 5})");
  folder.write("study.json", study.dump());
  ASSERT_EQ(run_program(folder.path(), {"optimize", "study.json", "--out", "out"}).exit_code, 0);
  std::filesystem::remove(folder / "out/checksums.sha256");
  Json state = Json::parse(file_text(folder / "out/study.json"));
  state["spec"]["name"] = "a\x1b]0;x\x07\n# heading";
  state["spec"]["description"] = "a\x1b[31m";
  state["provenance"]["compiler"] = "<img src=x>\x1b[31m\n\n# heading";
  folder.write("out/study.json", state.dump());
  // The last design failed, for a reason with everything in it.
  std::string log = file_text(folder / "out/evaluations.jsonl");
  const std::size_t last = log.rfind('\n', log.size() - 2) + 1;
  Json record = Json::parse(log.substr(last));
  for (const char* key : {"crc32c", "case_hash", "program_version", "git_revision", "physics",
                          "warnings", "metrics_unknown"}) {
    record.erase(key);
  }
  record["status"] = "failed";
  record["reason"] = "\x1b[2J" + wicked + "\n\n# heading";
  record["objectives"] = record["constraints"] = Json::array();
  record["feasible"] = false;
  folder.write("out/evaluations.jsonl", log.substr(0, last) + record.dump() + "\n");
  const Outcome advice = run_program(folder.path(), {"recommend", "out", "--no-confirm"});
  ASSERT_EQ(advice.exit_code, 0) << advice.err;
  EXPECT_FALSE(acts_on_terminal(advice.out + advice.err));
  const std::string markdown = file_text(folder / "out/recommendation.md");
  expect_harmless(markdown);
  EXPECT_EQ(markdown.find("<img"), std::string::npos);
  EXPECT_EQ(markdown.find("\n# heading"), std::string::npos);
  EXPECT_PRED_FORMAT2(IsSubstring, "\\\\u001b", markdown);
}

}  // namespace
}  // namespace parapet::test
