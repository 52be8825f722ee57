#include "parapet/reports/sweep_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "parapet/study/sweep_result.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

records::SweepRowResult row(const std::string& id, const char* published = "null") {
  records::SweepRowResult result;
  result.id = id;
  result.metrics["retention_efficiency"] = 0.593;
  result.metrics["launch_length_m"] = std::nullopt;
  result.metrics_absent["launch_length_m"] = "nothing overflowed";
  result.stop_time = 3.2;
  result.stop_reason = "settled";
  result.steps = 12345;
  result.wall_time = 9.5;
  result.published = Json::parse(published);
  return result;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

std::string line_of(const std::string& text, const std::string& start) {
  for (const std::string& line : lines(text)) {
    if (line.starts_with(start)) return line;
  }
  return "";
}

TEST(Compare, ARangeGivesAVerdictAndASignedDistance) {
  const Json range = Json::parse(R"({"lower": 0.5, "upper": 0.7})");
  EXPECT_EQ(study::compare(0.6, range).verdict, study::Agreement::Verdict::agrees);
  EXPECT_EQ(study::compare(0.5, range).verdict, study::Agreement::Verdict::agrees);
  EXPECT_EQ(study::compare(0.4, range).verdict, study::Agreement::Verdict::misses);
  EXPECT_DOUBLE_EQ(study::compare(0.45, range).distance, 0.45 - 0.5);
  EXPECT_DOUBLE_EQ(study::compare(0.75, range).distance, 0.75 - 0.7);
}

TEST(Compare, AHalfOpenRangeBindsOnOneSide) {
  const Json at_least = Json::parse(R"({"lower": 0.97})");
  EXPECT_EQ(study::compare(5.0, at_least).verdict, study::Agreement::Verdict::agrees);
  EXPECT_EQ(study::compare(0.9, at_least).verdict, study::Agreement::Verdict::misses);
}

TEST(Compare, ABareValueGivesNoVerdict) {
  const study::Agreement agreement = study::compare(1.5, Json::parse(R"({"value": 1.845})"));
  EXPECT_EQ(agreement.verdict, study::Agreement::Verdict::none);
  EXPECT_EQ(agreement.published, 1.845);
}

TEST(Compare, ARangeWithoutAComputedValueIsAMiss) {
  EXPECT_EQ(study::compare(std::nullopt, Json::parse(R"({"lower": 0.97})")).verdict,
            study::Agreement::Verdict::misses);
  EXPECT_EQ(study::compare(std::nullopt, nullptr).verdict, study::Agreement::Verdict::none);
}

TEST(SweepTable, MarksAgreementMissesAndDeviations) {
  records::SweepRowResult agrees =
      row("A", R"({"retention_efficiency": {"lower": 0.52, "upper": 0.68}})");
  records::SweepRowResult misses = row("B", R"({"retention_efficiency": {"lower": 0.76}})");
  records::SweepRowResult value = row("C", R"({"impact_x_m": {"value": 1.845}})");
  value.metrics["impact_x_m"] = 1.52;
  records::SweepRowResult none = row("D", R"({"launch_length_m": {"lower": 0.4, "upper": 0.5}})");
  const std::string text = sweep_table_text({agrees, misses, value, none}, 0.005);
  EXPECT_NE(line_of(text, "A ").find("0.593 (0.52..0.68 ok)"), std::string::npos) << text;
  EXPECT_NE(line_of(text, "B ").find("0.593 (>=0.76 -0.17)"), std::string::npos) << text;
  EXPECT_NE(line_of(text, "C ").find("1.520 (1.845 -18 %)"), std::string::npos) << text;
  EXPECT_NE(line_of(text, "D ").find("- (0.4..0.5 none)"), std::string::npos) << text;
  EXPECT_NE(text.find("Published ranges met: 1 of 3."), std::string::npos) << text;
  EXPECT_NE(text.find("spacing 5 mm"), std::string::npos);
}

TEST(SweepTable, ColumnsAreAligned) {
  const std::string text =
      sweep_table_text({row("H0-WD"), row("H10-D45-H25", R"({"retention_efficiency":
          {"lower": 0.52, "upper": 0.68}})")},
                       0.01);
  const std::vector<std::string> all = lines(text);
  const std::size_t status = line_of(text, "ID").find("status");
  EXPECT_EQ(line_of(text, "H0-WD").find("ok"), status);
  EXPECT_EQ(line_of(text, "H10-D45").find("ok"), status);
  const std::size_t stopped = line_of(text, "ID").find("stopped by");
  EXPECT_EQ(line_of(text, "H0-WD").find("settled"), stopped);
  EXPECT_EQ(line_of(text, "H10-D45").find("settled"), stopped);
  // Numbers of a column end in the same place, beside a note or not.
  EXPECT_EQ(line_of(text, "H0-WD").find("0.593"), line_of(text, "H10-D45").find("0.593"));
}

TEST(SweepTable, ShowsAbsentValuesAndFailures) {
  records::SweepRowResult failed = row("H18-WD-H25");
  failed.status = solver::Status::failed;
  failed.reason = "a speed of 41 m/s";
  failed.metrics.clear();
  const std::string text = sweep_table_text({failed}, 0.005);
  EXPECT_NE(text.find("H18-WD-H25 failed: a speed of 41 m/s"), std::string::npos) << text;
  EXPECT_EQ(line_of(text, "H18").find("0.000"), std::string::npos) << "an absent value is no zero";
  EXPECT_NE(text.find("-            no value"), std::string::npos)
      << "the legend says what - means";
}

TEST(SweepTable, ListsPublishedFiguresWithoutAColumn) {
  records::SweepRowResult result = row("H0-WD", R"({"flow_depth_max_time_s": {"value": 0.625}})");
  result.metrics["flow_depth_max_time_s"] = 0.6;
  EXPECT_NE(
      sweep_table_text({result}, 0.005).find("H0-WD: flow_depth_max_time_s = 0.6 (0.625 -4 %)"),
      std::string::npos);
}

TEST(SweepJson, HoldsMetricsFlatWithTheSourceBesideThem) {
  const char* published =
      R"({"retention_efficiency": {"lower": 0.6, "source": "Fig. 17"}, "impact_x_m": {"value": 2}})";
  const Json json = study::sweep_json("table3", "Huang et al. 2024", 0.005, {row("A", published)});
  EXPECT_EQ(json["format"], "parapet-sweep-result/1");
  EXPECT_EQ(json["spacing_m"], 0.005);
  const Json& entry = json["rows"][0];
  EXPECT_EQ(entry["id"], "A");
  EXPECT_EQ(entry["status"], "ok");
  EXPECT_EQ(entry["retention_efficiency"], 0.593);
  EXPECT_TRUE(entry["launch_length_m"].is_null());
  EXPECT_EQ(entry["metrics_absent"]["launch_length_m"], "nothing overflowed");
  EXPECT_EQ(entry["steps"], 12345);
  EXPECT_EQ(entry["simulated_time_s"], 3.2);
  EXPECT_EQ(entry["wall_time_s"], 9.5);
  EXPECT_EQ(entry["paper"]["retention_efficiency"]["source"], "Fig. 17");
  EXPECT_EQ(entry["agreement"]["retention_efficiency"]["verdict"], "misses");
  EXPECT_NEAR(entry["agreement"]["retention_efficiency"]["distance"].get<double>(), -0.007, 1e-12);
  EXPECT_FALSE(entry["agreement"].contains("impact_x_m"));
  EXPECT_FALSE(json.contains("provenance"));
}

TEST(SweepJson, KeepsTheCataloguesOrder) {
  records::SweepRowResult result = row("A");
  result.metrics["barrier_1_slam_force_n_per_m"] = 800.0;
  const Json entry = study::sweep_json("s", "", 0.005, {result})["rows"][0];
  std::vector<std::string> keys;
  for (const auto& item : entry.items()) keys.push_back(item.key());
  const auto place = [&](const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) - keys.begin();
  };
  EXPECT_LT(place("retention_efficiency"), place("launch_length_m"));
  EXPECT_LT(place("launch_length_m"), place("barrier_1_slam_force_n_per_m"));
}

TEST(SweepRowResult, TakesOverAResult) {
  designs::SweepRow spec;
  spec.id = "H10-D45";
  spec.published = Json::parse(R"({"retention_efficiency": {"lower": 0.76}})");
  solver::Result result;
  result.stop_reason = solver::StopReason::settled;
  result.stop_time = 2.5;
  result.statistics.steps = 77;
  result.metrics = {{"retention_efficiency", 0.8, ""}, {"impact_x_m", std::nullopt, "no overflow"}};
  const records::SweepRowResult out = records::make_sweep_row_result(spec, result);
  EXPECT_EQ(out.id, "H10-D45");
  EXPECT_EQ(out.stop_reason, "settled");
  EXPECT_EQ(out.steps, 77);
  EXPECT_EQ(out.metric("retention_efficiency"), 0.8);
  EXPECT_EQ(out.metric("impact_x_m"), std::nullopt);
  EXPECT_EQ(out.metric("unknown"), std::nullopt);
  EXPECT_EQ(out.metrics_absent.at("impact_x_m"), "no overflow");
  EXPECT_EQ(out.published, spec.published);
}

}  // namespace
}  // namespace parapet::reports
