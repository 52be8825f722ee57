// Page one of a recommendation: short, the same in every form, and no surer than the data.
#include "parapet/reports/page_one.hpp"

#include <algorithm>

#include "parapet/reports/recommendation_json.hpp"
#include "parapet/reports/recommendation_text.hpp"
#include "taught_study.hpp"
#include "trade_off.hpp"

namespace parapet::reports {
namespace {

namespace stage = study::confirmation_stage;

/// Lines of Markdown before the annex; all when there is none.
long first_page_lines(const Recommendation& advice) {
  const std::string text = recommendation_text(advice);
  const std::string page = text.substr(0, text.find("# Annex\n"));
  return std::ranges::count(page, '\n');
}

/// The better design all but breaks its limit; repeats scatter about it.
test::TaughtStudy narrow_study() {
  test::TaughtStudy taught({0.01}, 0.1);
  const std::string id = taught.add(0.07, 30.0, 0.01, 0.90, 0.0987);
  taught.confirm(id, "near-1", stage::near, 0.01, 0.88, 0.0820);
  taught.confirm(id, "near-2", stage::near, 0.01, 0.92, 0.0990);
  return taught;
}

TEST(PageOne, IsAMeanWithItsUncertaintyNotTheLuckiestRun) {
  const Recommendation advice = recommend(narrow_study().study);
  const PageOne page = page_one(advice);
  ASSERT_EQ(page.performance.size(), 1U);
  EXPECT_EQ(page.performance[0].label, "retention efficiency");
  // Mean 0.90 of 0.90, 0.88, 0.92; 4.303 x 0.02 sqrt(4 / 3) is 0.099; no share is above 1.
  EXPECT_EQ(page.performance[0].text, "0.900 ± 0.099");
  ASSERT_EQ(page.limits.size(), 1U);
  EXPECT_EQ(page.limits[0].asked, "at most 0.1 m");
  EXPECT_NEAR(page.probability.value(), 0.70, 0.01) << "not 100 %: see repeat_test";
  EXPECT_EQ(page.verdict, "narrow") << page.verdict_words;
  ASSERT_EQ(page.loads.size(), 2U);
  EXPECT_EQ(page.loads[1].label, "design moment on barrier 1");
  EXPECT_NE(page.grid.find("not known"), std::string::npos) << page.grid;
  ASSERT_EQ(page.sketch.size(), 4U);
  EXPECT_NE(page.sketch[1].find("| stem 70 mm"), std::string::npos) << page.sketch[1];
}

TEST(PageOne, MarkdownAndJsonAreTheSamePage) {
  const Recommendation advice = recommend(narrow_study().study);
  const PageOne page = page_one(advice);
  const designs::Json json = recommendation_json(advice)["page_one"];
  const std::string text = recommendation_text(advice);
  for (const auto& [key, words] : {std::pair{"chosen", page.chosen},
                                   {"ties", page.ties},
                                   {"bounds", page.bounds},
                                   {"grid", page.grid},
                                   {"probability_words", page.probability_words}}) {
    EXPECT_EQ(json[key], words);
    EXPECT_NE(text.find("- " + words + "\n"), std::string::npos) << key << "\n" << text;
  }
  EXPECT_EQ(json["performance"][0]["text"], page.performance[0].text);
  EXPECT_NE(text.find("**" + page.performance[0].text + "**"), std::string::npos);
  EXPECT_EQ(json["verdict"], "narrow");
}

class ShortPage : public test::TradeOff {};

TEST_F(ShortPage, HasAtMost25LinesWhateverIsAsked) {
  EXPECT_LE(first_page_lines(recommend(narrow_study().study)), page_one_lines);
  add_front();
  EXPECT_LE(first_page_lines(recommend(study_)), page_one_lines);
  estimate({{"0001", 0.9}, {"0002", 0.9}});
  confirm("0002", "near-1", stage::near, 0.92, 0.14, 60.0);
  confirm("0002", "near-2", stage::near, 0.92, 0.14, 60.0);
  EXPECT_LE(first_page_lines(recommend(study_)), page_one_lines);
  // Every item there is, many times over.
  Recommendation all = recommend(narrow_study().study);
  std::vector<study::Expectation>& repeat = all.recommended->repeat;
  const std::vector<study::Expectation> once = repeat;
  for (int k = 0; k < 9; ++k) repeat.insert(repeat.end(), once.begin(), once.end());
  EXPECT_LE(first_page_lines(all), page_one_lines);
}

TEST_F(ShortPage, OneRunHasNoUncertainty) {
  add_front();
  const PageOne page = page_one(recommend(study_));
  EXPECT_NE(page.performance[0].text.find("not known"), std::string::npos);
  EXPECT_FALSE(page.performance[0].lower_95.has_value());
  EXPECT_FALSE(page.probability.has_value());
  EXPECT_EQ(page.verdict, "untested");
  EXPECT_NE(page.ties.find("not known"), std::string::npos);
}

TEST_F(ShortPage, NothingFeasibleSaysWhy) {
  add(0.16, 35.0, 0.99, 0.01, 150.0);
  add(0.16, 35.0, 0.99, 0.01, 150.0, 0.02);
  const PageOne page = page_one(recommend(study_));
  EXPECT_EQ(page.verdict, "none");
  EXPECT_EQ(page.design, "0001");
  EXPECT_NE(page.instead.find("None of the 1 designs simulated at 10 mm"), std::string::npos)
      << "the coarse one does not count: " << page.instead;
}

TEST(Counts, DoNotMixSpacings) {
  test::TaughtStudy taught({0.01, 0.02}, 0.3);
  taught.add(0.07, 30.0, 0.01, 0.90, 0.2);
  taught.add(0.08, 30.0, 0.02, 0.90, 0.2);
  taught.add(0.09, 30.0, 0.02, 0.90, 0.4);
  const Recommendation advice = recommend(taught.study);
  ASSERT_EQ(advice.study.spacings.size(), 2U);
  EXPECT_EQ(advice.study.spacings[0].feasible, 1);
  EXPECT_EQ(advice.study.spacings[1].designs, 2);
  EXPECT_EQ(advice.study.spacings[1].feasible, 1);
  EXPECT_NE(recommendation_text(advice).find("2 designs at 20 mm (1 meet every constraint"),
            std::string::npos);
}

TEST(Spreads, HoldRunsOfOneSpacing) {
  test::TaughtStudy taught({0.01, 0.02}, 0.3);
  const std::string id = taught.add(0.07, 30.0, 0.02, 0.50, 0.2);
  taught.confirm(id, "finest", stage::finest, 0.01, 0.90, 0.2);
  taught.confirm(id, "near-1", stage::near, 0.01, 0.92, 0.2);
  const Confirmation confirmation = recommend(taught.study).confirmation.value();
  ASSERT_FALSE(confirmation.spread.empty());
  EXPECT_EQ(confirmation.spread[0].runs, 2);
  EXPECT_EQ(confirmation.spread[0].least, 0.90) << "0.50 is of coarse particles";
}

TEST(Verdicts, FormulasAreNotCalledConfirmed) {
  test::TaughtStudy taught = narrow_study();
  taught.study.spec.constraints.clear();
  for (auto* list : {&taught.study.designs, &taught.study.confirmations}) {
    for (records::EvaluationRecord& one : *list) one.constraints.clear();
  }
  const Recommendation advice = recommend(taught.study);
  const PageOne page = page_one(advice);
  EXPECT_EQ(page.verdict, "untested");
  EXPECT_EQ(page.verdict_words.find("onfirmed"), std::string::npos) << page.verdict_words;
}

TEST(Verdicts, ARunWorseThanPredictedIsNamed) {
  test::TaughtStudy taught({0.01}, 0.3, 0.005, 0.005);
  for (int k = 0; k < 12; ++k) {
    const double s = k / 11.0;
    taught.add(0.04 + 0.06 * s, 60.0 * (7 * k % 12) / 11.0, 0.01, 0.6 + 0.2 * s, 0.1);
  }
  taught.teach();
  for (const char* role : {"near-1", "near-2"}) {
    taught.confirm("0012", role, stage::near, 0.01, 0.60, 0.1);
  }
  const Recommendation advice = recommend(taught.study);
  ASSERT_EQ(advice.confirmation->refuted.size(), 1U);
  EXPECT_EQ(advice.confirmation->refuted[0].id, "0012");
  EXPECT_EQ(advice.confirmation->refuted[0].worse,
            std::vector<std::string>{"retention_efficiency"});
  EXPECT_NE(recommendation_text(advice).find("retention_efficiency was worse than predicted"),
            std::string::npos);
}

}  // namespace
}  // namespace parapet::reports
