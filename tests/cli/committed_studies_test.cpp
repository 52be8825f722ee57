// The committed recommendations follow from the committed logs, by this program.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "parapet/designs/case_spec.hpp"
#include "program_runner.hpp"

namespace parapet::test {
namespace {

using designs::Json;

/// Where two documents differ, as JSON pointers; numbers that agree to a millionth are equal: the
/// surrogates' estimates go through libraries whose last digits depend on the compiler.
void differences(const Json& a, const Json& b, const std::string& at,
                 std::vector<std::string>& found) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>(), y = b.get<double>();
    if (std::abs(x - y) > 1e-6 * std::max(std::abs(x), std::abs(y)) + 1e-12) found.push_back(at);
  } else if (a.is_structured() && a.type() == b.type() && a.size() == b.size()) {
    for (const auto& [key, value] : a.items()) {
      const Json& other = a.is_array() ? b[std::stoul(key)] : (b.contains(key) ? b[key] : Json());
      std::string place = at;
      differences(value, other, place.append("/").append(key), found);
    }
  } else if (a != b) {
    found.push_back(at);
  }
}

class CommittedStudy : public ::testing::TestWithParam<const char*> {};

// A third party needs only the files of the folder: study.json, the two logs, pareto.json and
// surrogates.json.
TEST_P(CommittedStudy, GivesTheCommittedRecommendation) {
  const std::filesystem::path committed =
      std::filesystem::path(PARAPET_REPORTS) / "recommendations" / GetParam();
  const TemporaryFolder folder;
  const std::filesystem::path copy = folder / "runs" / GetParam();
  std::filesystem::create_directories(copy);
  for (const char* file : {"study.json", "evaluations.jsonl", "confirmations.jsonl", "pareto.json",
                           "surrogates.json"}) {
    ASSERT_TRUE(std::filesystem::exists(committed / file)) << file;
    std::filesystem::copy_file(committed / file, copy / file);
  }
  const std::string name = std::string("runs/") + GetParam();
  const Outcome outcome =
      run_program(folder.path(), {"recommend", name, "--no-confirm", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json ours = Json::parse(file_text(copy / "recommendation.json"));
  const Json theirs = Json::parse(file_text(committed / "recommendation.json"));
  std::vector<std::string> found;
  differences(theirs, ours, "", found);
  EXPECT_TRUE(found.empty()) << found.size() << " differences, the first at " << found.front();
  EXPECT_EQ(file_text(copy / "recommendation.md"), file_text(committed / "recommendation.md"));
}

INSTANTIATE_TEST_SUITE_P(Shipped, CommittedStudy,
                         ::testing::Values("single_deflector", "dual_deflector",
                                           "robust_dual_deflector"),
                         [](const auto& study) { return std::string(study.param); });

// The committed sweep and the committed scorecard were made by two programs (table3, validate),
// which must say the same of a row. The scorecard keeps six digits.
TEST(CommittedTable3, HasTheValuesOfTheCommittedScorecard) {
  std::map<std::string, Json> rows;
  const Json sweep =
      Json::parse(file_text(std::filesystem::path(PARAPET_REPORTS) / "table3" / "table3.json"));
  for (const Json& row : sweep["rows"]) rows[row["id"].get<std::string>()] = row;
  EXPECT_EQ(rows.size(), 15U);
  const Json scorecard = Json::parse(file_text(PARAPET_TABLE3_SCORECARD));
  int compared = 0;
  for (const Json& measure : scorecard["measures"]) {
    const auto key = measure["key"].get<std::string>();  // ID_METRIC
    const auto end = key.find('_');
    const auto row = rows.find(key.substr(0, end));
    if (row == rows.end()) continue;
    const Json value = row->second.value(key.substr(end + 1), Json());
    if (!value.is_number() || !measure["value"].is_number()) continue;
    const double scale = measure.value("unit", "") == "mm" ? 1000.0 : 1.0;
    const double stated = measure["value"].get<double>();
    EXPECT_NEAR(scale * value.get<double>(), stated, 1e-5 * std::abs(stated)) << key;
    ++compared;
  }
  EXPECT_GE(compared, 30);
}

}  // namespace
}  // namespace parapet::test
