#include "parapet/study/loaded_study.hpp"

#include <fstream>

#include "formula_study.hpp"
#include "parapet/designs/error.hpp"
#include "parapet/study/front.hpp"

namespace parapet::test {
namespace {

using designs::Json;

class StudyOnDisk : public FolderTest {
 protected:
  StudyOnDisk() {
    write("study.json", Json{{"format", "parapet-study-state/1"},
                             {"spec_hash", "0123456789abcdef"},
                             {"provenance", {{"program_version", "9.9.9"}}},
                             {"spec", spec.resolved}}
                            .dump());
  }

  records::EvaluationRecord record(int number) const {
    records::EvaluationRecord one;
    one.id = records::evaluation_id(number);
    one.stage = "search";
    one.design = {{"height_m", 0.05}, {"deflector", 0.0}};
    one.options = {{"deflector", "none"}};
    one.ok = true;
    one.objectives = {{"retention_efficiency", designs::Goal::maximize, 1.0, 0.8, false}};
    one.objective_scalar = -0.8;
    one.constraints = {{"reach", 0.2, std::nullopt, 0.5, true, 0.3},
                       {"stem", 0.05, std::nullopt, 0.15, true, 0.1}};
    one.feasible = true;
    one.spacing = 0.01;
    return one;
  }

  static std::string line(const records::EvaluationRecord& record) {
    return to_json(record).dump() + "\n";
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  /// What is said when the folder is read.
  std::string refusal() const {
    try {
      study::load_study_folder(folder);
    } catch (const designs::InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  designs::StudySpec spec = designs::parse_study(formula_study(), "test");
};

#define EXPECT_REFUSED(words) EXPECT_NE(refusal().find(words), std::string::npos) << refusal()

TEST_F(StudyOnDisk, IsReadAsTypes) {
  write("evaluations.jsonl", line(record(1)) + line(record(2)));
  records::EvaluationRecord near = record(3);
  near.id = "0001-near-1";
  write("confirmations.jsonl", line(near) + "{\"id\":");
  write("summary.json", R"({"state": "interrupted"})");
  const study::LoadedStudy study = study::load_study_folder(folder);
  EXPECT_EQ(study.spec.resolved, spec.resolved);
  EXPECT_EQ(study.spec.variables[2].active_when->options, std::vector<int>{1});
  EXPECT_EQ(study.spec_hash, "0123456789abcdef");
  EXPECT_EQ(study.provenance["program_version"], "9.9.9");
  EXPECT_EQ(study.state, "interrupted");
  ASSERT_EQ(study.designs.size(), 2U);
  EXPECT_EQ(study.designs[1].id, "0002");
  EXPECT_TRUE(study.log_complete);
  ASSERT_EQ(study.confirmations.size(), 1U) << "a half-written line is passed over";
  EXPECT_FALSE(study.front.has_value());
  EXPECT_FALSE(study.sensitivity.has_value());
}

TEST_F(StudyOnDisk, AHalfWrittenLastLineIsPassedOverAndLeftAlone) {
  const std::string text = line(record(1)) + line(record(2)).substr(0, 40);
  write("evaluations.jsonl", text);
  const study::LoadedStudy study = study::load_study_folder(folder);
  EXPECT_EQ(study.designs.size(), 1U);
  EXPECT_FALSE(study.log_complete);
  EXPECT_EQ(std::filesystem::file_size(folder / "evaluations.jsonl"), text.size());
}

TEST_F(StudyOnDisk, NamesADamagedLineAndLeavesItOut) {
  write("evaluations.jsonl", line(record(1)) + "{\"id\": \"0002\", \n" + line(record(3)));
  write("confirmations.jsonl", "nothing\n");
  const study::LoadedStudy study = study::load_study_folder(folder);
  ASSERT_EQ(study.designs.size(), 2U);
  EXPECT_EQ(study.designs[1].id, "0003");
  ASSERT_EQ(study.damage.size(), 2U);
  EXPECT_NE(study.damage[0].find("evaluations.jsonl: line 2"), std::string::npos);
  EXPECT_NE(study.damage[1].find("confirmations.jsonl: line 1"), std::string::npos);
  EXPECT_EQ(study.notes.size(), 1U) << "the lines have no checksums";
}

TEST_F(StudyOnDisk, LinksAreNotFollowed) {
  write("elsewhere.jsonl", line(record(1)));
  std::filesystem::create_symlink(folder / "elsewhere.jsonl", folder / "evaluations.jsonl");
  EXPECT_REFUSED("is a link");
}

TEST_F(StudyOnDisk, NamesWhatIsMissingOrNotOfThisStudy) {
  EXPECT_REFUSED("evaluations.jsonl");
  write("evaluations.jsonl", "");
  EXPECT_REFUSED("no design has been evaluated yet");
  records::EvaluationRecord other = record(1);
  other.constraints.pop_back();
  write("evaluations.jsonl", line(other));
  EXPECT_REFUSED("its constraints are not those of the spec");
  other = record(1);
  other.design.erase("height_m");
  write("evaluations.jsonl", line(other));
  EXPECT_REFUSED("there is no height_m");
  write("study.json", R"({"format": "something"})");
  EXPECT_REFUSED("/format");
  write("study.json", R"({"format": "parapet-study-state/1", "spec": {}})");
  EXPECT_REFUSED("study.json");
  write("study.json", "{");
  EXPECT_REFUSED("study.json");
  std::filesystem::remove(folder / "study.json");
  EXPECT_REFUSED("a study folder");
}

TEST_F(StudyOnDisk, AFailedDesignNeedsNoObjectives) {
  records::EvaluationRecord failed = record(1);
  failed.ok = failed.feasible = false;
  failed.reason = "the time step fell to zero";
  failed.objectives.clear();
  failed.constraints.erase(failed.constraints.begin());
  write("evaluations.jsonl", line(failed));
  EXPECT_EQ(study::load_study_folder(folder).designs[0].reason, "the time step fell to zero");
}

TEST_F(StudyOnDisk, EstimatesAreThoseOfThisStudy) {
  write("evaluations.jsonl", line(record(1)));
  study::Front front = study::make_front(spec, {record(1)});
  Json json = study::pareto_json(spec, front, nullptr, nullptr);
  json["spec_hash"] = "0123456789abcdef";
  json["designs"][0]["probability_feasible"] = 0.75;
  json["designs"][0]["objectives"][0]["estimate"] = 0.78;
  write("pareto.json", json.dump());
  const auto stored = study::load_study_folder(folder).front;
  ASSERT_TRUE(stored.has_value());
  EXPECT_EQ(stored->find("0001")->probability_feasible, 0.75);
  EXPECT_EQ(stored->find("0001")->objectives[0].median, 0.78);
  EXPECT_FALSE(stored->find("0001")->objectives[0].lower_95.has_value());
  EXPECT_EQ(stored->find("0002"), nullptr);
  EXPECT_EQ(stored->hypervolume, front.hypervolume);
  EXPECT_EQ(stored->history.size(), 1U);
  json["spec_hash"] = "fedcba9876543210";
  write("pareto.json", json.dump());
  EXPECT_FALSE(study::load_study_folder(folder).front.has_value());
  write("pareto.json", "{");
  EXPECT_FALSE(study::load_study_folder(folder).front.has_value());
}

TEST_F(StudyOnDisk, SaysWhichDesignsEndedAtTheStopTimeFromTheReportsOfAnOlderVersion) {
  write("evaluations.jsonl", line(record(1)));
  std::filesystem::create_directory(folder / "evaluations");
  write("evaluations/0001.json", R"({"simulation": {"stop_reason": "settled"}})");
  write("evaluations/0002.json", R"({"simulation": {"stop_reason": "end_time"}})");
  write("evaluations/0003-soft.json",
        R"({"details": {"simulation": {"stop_reason": "end_time"}}})");
  EXPECT_EQ(study::load_study_folder(folder).unsettled, (std::set<std::string>{"0002", "0003"}));
}

TEST_F(StudyOnDisk, SaysWhichDesignsEndedAtTheStopTimeFromTheLogAlone) {
  records::EvaluationRecord settled = record(1), late = record(2), late_event = record(3);
  settled.stop_reason = "settled";
  late.stop_reason = "end_time";
  late_event.scenarios = {{"usual", 0.5, true, "", late.metrics, 0.0, 0.0, 0.0, "settled", "", {}},
                          {"soft", 0.5, true, "", late.metrics, 0.0, 0.0, 0.0, "end_time", "", {}}};
  write("evaluations.jsonl", line(settled) + line(late) + line(late_event));
  EXPECT_EQ(study::load_study_folder(folder).unsettled, (std::set<std::string>{"0002", "0003"}));
}

}  // namespace
}  // namespace parapet::test
