// The quick versions of the validation suite's cases: each must be carried out and meet its limits,
// but for those whose miss is explained. And the committed pages must be what the committed
// scorecards say.
#include "parapet/validation/suite.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "parapet/records/atomic_file.hpp"

namespace parapet::validation {
namespace {

std::filesystem::path scratch_folder(const std::string& name) {
  return std::filesystem::temp_directory_path() /
         ("parapet-suite-" + name + "-" + std::to_string(getpid()));
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const CaseInfo& c : list_cases()) names.push_back(c.name);
  return names;
}

class QuickSuite : public testing::TestWithParam<std::string> {};

TEST_P(QuickSuite, MeetsItsLimits) {
  SuiteOptions options;
  options.folder = scratch_folder(GetParam());
  options.only = {GetParam()};
  options.full = false;
  const SuiteOutcome outcome = run_suite(options);
  std::filesystem::remove_all(options.folder);
  ASSERT_EQ(outcome.cards.size(), 1u);
  const Scorecard& card = outcome.cards.front();
  EXPECT_EQ(card.failure, "");
  std::printf("%s", scorecard_text(outcome.cards).c_str());
  for (const Measure& m : card.measures) {
    EXPECT_TRUE(m.verdict() != Verdict::missed || !m.explanation.empty())
        << m.what << ": " << value_text(m.value, m.unit) << ", " << limit_text(m);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, QuickSuite, testing::ValuesIn(case_names()),
                         [](const auto& test) { return test.param; });

TEST(Pages, AreWhatTheScorecardsSay) {
  const std::filesystem::path folder = PARAPET_DOCS_VALIDATION;
  for (const Page& page : pages(folder)) {
    EXPECT_EQ(records::read_file(folder / page.file), page.text)
        << "mend with: parapet validate --pages-only";
  }
}

TEST(Pages, EveryFigureOfTheScorecardsIsThere) {
  const std::filesystem::path folder = PARAPET_DOCS_VALIDATION;
  for (const std::string& name : case_names()) {
    if (!std::filesystem::exists(folder / (name + ".json"))) continue;  // the page says: not run
    const auto json = nlohmann::ordered_json::parse(records::read_file(folder / (name + ".json")));
    const Scorecard card = scorecard_from_json(json);
    EXPECT_TRUE(card.full) << name;
    EXPECT_EQ(card.failure, "") << name;
    for (const std::string& figure : card.figures) {
      EXPECT_TRUE(std::filesystem::exists(folder / figure)) << figure;
    }
  }
}

}  // namespace
}  // namespace parapet::validation
