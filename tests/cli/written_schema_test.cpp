// records/schema/outputs.schema.json under an independent validator: whatever the program writes is
// in it, and nothing of it is missing there.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "parapet/records/flow_recording.hpp"
#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

namespace fs = std::filesystem;
using Plain = nlohmann::json;

/// Where a schema lists keys, no others: the published one lets later versions add some.
void make_strict(Plain& schema) {
  if (schema.is_object() && schema.contains("properties") &&
      !schema.contains("additionalProperties")) {
    schema["additionalProperties"] = false;
  }
  for (Plain& part : schema) {
    if (part.is_structured()) make_strict(part);
  }
}

/// One definition of the schema, strict.
class Definition {
 public:
  explicit Definition(const std::string& name) {
    Plain document = Plain::parse(file_text(PARAPET_WRITTEN_SCHEMA));
    if (!document.at("definitions").contains(name)) {
      throw std::runtime_error("no definition " + name);
    }
    make_strict(document["definitions"]);
    document.erase("anyOf");
    document.erase("$id");
    document["allOf"] = {{{"$ref", "#/definitions/" + name}}};
    valijson::SchemaParser parser;
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }

  /// What is wrong with a document; empty when it agrees.
  std::string wrong_with(const Plain& json) const {
    valijson::Validator validator;
    valijson::ValidationResults results;
    const valijson::adapters::NlohmannJsonAdapter target(json);
    if (validator.validate(schema_, target, &results)) return {};
    std::string text;
    valijson::ValidationResults::Error error;
    while (results.popError(error)) {
      for (const std::string& part : error.context) text += part;
      text += ": " + error.description + "\n";
    }
    return text;
  }

 private:
  valijson::Schema schema_;
};

class WrittenSchema : public ::testing::Test {
 protected:
  void expect(const std::string& definition, const Plain& json, const std::string& file) {
    auto found = definitions_.find(definition);
    if (found == definitions_.end()) {
      found = definitions_.try_emplace(definition, definition).first;
    }
    const std::string wrong = found->second.wrong_with(json);
    EXPECT_TRUE(wrong.empty()) << file << " as " << definition << ":\n" << wrong;
    ++checked_[definition];
  }

  void expect_line(const Plain& line, const std::string& file) {
    expect(line.at("status") == "refused" ? "refused_line" : "log_line", line, file);
  }

  /// Every JSON file of a folder by its format; one without a format is a scorecard.
  void expect_folder(const fs::path& folder) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path& file = entry.path();
      const std::string name = file.filename().string();
      if (!entry.is_regular_file()) continue;
      if (file.extension() == ".jsonl") {
        std::istringstream lines(file_text(file));
        for (std::string line; std::getline(lines, line);) expect_line(Plain::parse(line), name);
      } else if (file.extension() == ".json" || name == ".parapet") {
        const Plain json = Plain::parse(file_text(file));
        expect(by_format(json.value("format", "")), json, file.string());
      } else if (file.extension() == ".flow") {
        expect("recording_header", Plain::parse(records::recording_header(file_text(file)).dump()),
               name);
      } else if (name == "report.html") {
        const std::string html = file_text(file), begin = "id=\"page-data\">";
        const std::size_t at = html.find(begin) + begin.size();
        expect("page", Plain::parse(html.substr(at, html.find("</script>", at) - at)), name);
      }
    }
  }

  static std::string by_format(const std::string& format) {
    static const std::map<std::string, std::string> names{
        {"", "scorecard"},
        {"parapet-result/1", "result"},
        {"parapet-sweep-result/1", "sweep_result"},
        {"parapet-folder/1", "folder"},
        {"parapet-study-state/1", "study_state"},
        {"parapet-study-state/2", "study_state"},
        {"parapet-evaluation/1", "evaluation"},
        {"parapet-simulation/1", "simulation"},
        {"parapet-study-summary/1", "summary"},
        {"parapet-pareto/1", "pareto"},
        {"parapet-surrogates/1", "surrogates"},
        {"parapet-sensitivity/1", "sensitivity"},
        {"parapet-recommendation/1", "recommendation"},
        {"parapet-approach/1", "approach"}};
    const auto found = names.find(format);
    return found == names.end() ? "no definition for " + format : found->second;
  }

  void run(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(folder_.path(), arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  TemporaryFolder folder_;
  std::map<std::string, Definition> definitions_;
  std::map<std::string, int> checked_;
};

TEST_F(WrittenSchema, HoldsASimulationWithEverything) {
  folder_.write("case.json", tiny_case().dump());
  run({"simulate", "case.json", "--out", "out", "--record"});
  run({"simulate", "case.json", "--out", "sure", "--uncertainty", "--jobs", "2"});
  run({"simulate", "case.json", "--out", "profile", "--profile"});
  run({"approach", "case.json", "--out", "approach"});
  run({"simulate", "case.json", "--out", "open", "--approach"});
  for (const char* name : {"out", "sure", "profile", "approach", "open"}) {
    expect_folder(folder_ / name);
  }
  EXPECT_GE(checked_["result"], 4);
  EXPECT_EQ(checked_["approach"], 2);
  EXPECT_EQ(checked_["recording_header"], 1);
  EXPECT_GE(checked_["page"], 3);
  EXPECT_GE(checked_["folder"], 3);
}

TEST_F(WrittenSchema, HoldsAFailedRun) {
  Plain spec = Plain::parse(tiny_case().dump());
  spec["numerics"]["cg_max_iterations"] = 1;
  spec["numerics"]["cg_tolerance_m_s2"] = 1e-8;
  folder_.write("case.json", spec.dump());
  EXPECT_EQ(run_program(folder_.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 1);
  expect_folder(folder_ / "out");
  EXPECT_EQ(checked_["result"], 1);
}

TEST_F(WrittenSchema, HoldsASearchAndItsRecommendation) {
  designs::Json spec = tiny_search();
  spec["terms"]["half_height_m"] = "upstream_height_m / 2";
  spec["terms"]["reach_m"] = {{"expression", "2 * launch_length_m"},
                              {"values_when_absent", {{"launch_length_m", 0}}}};
  folder_.write("study.json", spec.dump());
  run({"optimize", "study.json", "--out", "out"});
  run({"recommend", "out"});
  expect_folder(folder_ / "out");
  for (const char* name : {"study_state", "log_line", "evaluation", "summary", "pareto",
                           "surrogates", "sensitivity", "recommendation", "page"}) {
    EXPECT_GE(checked_[name], 1) << name;
  }
  // The terms of the spec stand wherever a design does.
  std::istringstream log(file_text(folder_ / "out/evaluations.jsonl"));
  std::string line;
  std::getline(log, line);
  const Plain first = Plain::parse(line);
  EXPECT_DOUBLE_EQ(first["terms"]["half_height_m"].get<double>(),
                   first["design"]["upstream_height_m"].get<double>() / 2.0);
  EXPECT_TRUE(first["terms"].contains("reach_m"));
  const Plain advice = Plain::parse(file_text(folder_ / "out/recommendation.json"));
  EXPECT_TRUE(advice.dump().find("\"terms\":{\"half_height_m\"") != std::string::npos);
  EXPECT_NE(file_text(folder_ / "out/designs.csv").find("term.half_height_m"), std::string::npos);
}

TEST_F(WrittenSchema, HoldsRefusedDesignsAndWhatEvaluatePrints) {
  designs::Json spec = tiny_study();
  folder_.write("study.json", spec.dump());
  run({"optimize", "study.json", "--out", "out"});
  expect_folder(folder_ / "out");
  const Outcome outcome =
      run_program(folder_.path(), {"evaluate", "study.json", "--design",
                                   R"({"deflector_angle_deg": 30, "upstream_height_m": 0.06})"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_line(Plain::parse(outcome.out), "evaluate");
  const Outcome refused =
      run_program(folder_.path(), {"evaluate", "study.json", "--design",
                                   R"({"deflector_angle_deg": 60, "upstream_height_m": 0.1})"});
  expect_line(Plain::parse(refused.out), "evaluate");
  EXPECT_GE(checked_["log_line"], 2);
}

TEST_F(WrittenSchema, HoldsASweep) {
  folder_.write("sweep.json", tiny_sweep().dump());
  run({"table3", "sweep.json", "--out", "out"});
  expect_folder(folder_ / "out");
  EXPECT_EQ(checked_["sweep_result"], 1);
  EXPECT_EQ(checked_["result"], 3);
}

TEST_F(WrittenSchema, HoldsTheCommittedResults) {
  expect_folder(PARAPET_REPORTS);
  expect_folder(PARAPET_SCORECARDS);
  EXPECT_EQ(checked_["recommendation"], 3);
  EXPECT_GE(checked_["scorecard"], 18);
  EXPECT_GE(checked_["log_line"], 100);
}

// What the test would not see if it let everything pass.
TEST_F(WrittenSchema, RefusesWhatIsNotListed) {
  const Definition folder("folder");
  EXPECT_EQ(folder.wrong_with(Plain::parse(R"({"format": "parapet-folder/1", "holds": "sweep"})")),
            "");
  for (const char* text :
       {R"({"format": "parapet-folder/1", "holds": "else"})", R"({"holds": "sweep"})",
        R"({"format": "parapet-folder/2", "holds": "sweep"})",
        R"({"format": "parapet-folder/1", "holds": "sweep", "more": 1})"}) {
    EXPECT_NE(folder.wrong_with(Plain::parse(text)), "") << text;
  }
}

}  // namespace
}  // namespace parapet::test
