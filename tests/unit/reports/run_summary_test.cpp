// What came of a run, in words and units.
#include "parapet/reports/run_summary.hpp"

#include <gtest/gtest.h>

namespace parapet::reports {
namespace {

using solver::Metric;
using solver::Result;

Metric known(std::string key, double value) {
  return {.key = std::move(key), .value = value, .absent_reason = ""};
}

Metric absent(std::string key, std::string reason) {
  return {.key = std::move(key),
          .value = std::nullopt,
          .absent_reason = std::move(reason),
          .uncertainty = std::nullopt,
          .absence = solver::Absence::does_not_exist};
}

Result one_barrier() {
  Result result;
  result.stop_reason = solver::StopReason::metrics_final;
  result.stop_time = 2.314;
  result.metrics = {known("retention_efficiency", 0.6134),
                    known("retention_efficiency_total", 0.6134),
                    known("launch_length_m", 0.3125),
                    known("impact_time_s", 1.251),
                    known("overflow_volume_m3_per_m", 0.00768),
                    known("front_velocity_m_s", 2.3),
                    known("arrival_time_s", 0.62),
                    known("barrier_1_design_force_n_per_m", 123.4),
                    known("barrier_1_design_moment_nm_per_m", 4.5),
                    known("barrier_1_run_up_height_m", 0.14)};
  return result;
}

TEST(RunSummary, SaysWhatCameOfItInWordsAndUnits) {
  EXPECT_EQ(
      run_summary(one_barrier()),
      "  ended             after 2.31 s of flow: nothing that is measured can change any more\n"
      "  approach          front of 2.3 m/s at 0.62 s\n"
      "  held back         61.3 % of the debris; 0.00768 m³/m went over the first\n"
      "  flight            landed 0.312 m beyond the first barrier at 1.25 s\n"
      "  load on barrier 1 123 N/m, moment about the foot 4.5 N m/m; the debris rose to 0.14 m\n");
}

TEST(RunSummary, AnUncertaintyStandsBesideItsValue) {
  Result result = one_barrier();
  result.metrics[0].uncertainty.emplace().expanded = 0.0123;
  result.metrics[7].uncertainty.emplace().expanded = 31.2;
  const std::string text = run_summary(result);
  EXPECT_NE(text.find("61.3 ± 1.2 % of the debris"), std::string::npos) << text;
  EXPECT_NE(text.find("123 ± 31 N/m"), std::string::npos) << text;
}

TEST(RunSummary, WhatDoesNotExistGivesItsReasonAndWarningsComeLast) {
  Result result = one_barrier();
  result.metrics[2] = absent("launch_length_m", "less than 0.5 % landed beyond");
  result.metrics[4].value = 0.0;
  result.warnings = {{.key = "density_error_max", .value = 0.2, .limit = 0.1, .text = "poor."}};
  const std::string text = run_summary(result);
  EXPECT_NE(text.find("  flight            none: less than 0.5 % landed beyond\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("went over"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("  warning           poor.\n")) << text;
}

TEST(RunSummary, SeveralBarriersEachHaveTheirLoad) {
  Result result = one_barrier();
  result.metrics[1].value = 0.97;
  result.metrics.push_back(known("barrier_2_retention_efficiency", 0.97));
  result.metrics.push_back(known("barrier_2_design_force_n_per_m", 1234.5));
  const std::string text = run_summary(result);
  EXPECT_NE(text.find("61.3 % of the debris by the first barrier, 97 % by all"), std::string::npos)
      << text;
  EXPECT_NE(text.find("  load on barrier 2 1234 N/m\n"), std::string::npos) << text;
}

TEST(RunSummary, AnOpenChannelHasFrontAndDepthAndAFailureItsReason) {
  Result result;
  result.status = solver::Status::failed;
  result.stop_time = 0.5;
  result.reason = "a particle's speed is 99 m/s";
  result.metrics = {known("front_velocity_m_s", 2.3), known("flow_depth_max_m", 0.041)};
  EXPECT_EQ(run_summary(result),
            "  FAILED            at 0.5 s of flow: a particle's speed is 99 m/s\n"
            "  approach          front of 2.3 m/s, 0.041 m deep\n");
}

}  // namespace
}  // namespace parapet::reports
