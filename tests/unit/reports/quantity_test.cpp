#include "quantity.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "parapet/solver/result.hpp"

namespace parapet::reports {
namespace {

TEST(Quantity, SplitsTheUnitOffAKey) {
  EXPECT_EQ(quantity("launch_length_m").words, "launch length");
  EXPECT_EQ(quantity("launch_length_m").unit, "m");
  EXPECT_EQ(quantity("landing_speed_m_s").unit, "m/s");
  EXPECT_EQ(quantity("landing_speed_m_s").words, "landing speed");
  EXPECT_EQ(quantity("deflector_angle_deg").unit, "°");
  EXPECT_EQ(quantity("retention_efficiency").unit, "-");
  EXPECT_EQ(quantity("retention_efficiency").words, "retention efficiency");
}

/// A key whose unit is not known would be printed as a pure number.
TEST(Quantity, KnowsTheUnitOfEveryMetricWithOne) {
  for (const solver::MetricInfo& info : solver::metric_catalog(2)) {
    const bool pure = info.key.ends_with("efficiency") || info.key.ends_with("efficiency_total") ||
                      info.key.ends_with("ratio") || info.key.ends_with("number") ||
                      info.key.ends_with("dead_zone_length");
    EXPECT_EQ(quantity(info.key).unit == "-", pure) << info.key;
  }
}

TEST(NumberText, HasFourDigitsAndNoExponentInTheThousands) {
  EXPECT_EQ(number_text(0.123456), "0.1235");
  EXPECT_EQ(number_text(1234.56), "1235");
  EXPECT_EQ(number_text(123456.0), "123456");
  EXPECT_EQ(number_text(-0.5), "-0.5");
}

TEST(NumberText, ShowsADashWhereThereIsNoValue) {
  EXPECT_EQ(number_text(std::nullopt), "-");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(with_unit(std::nullopt, "launch_length_m"), "-");
}

TEST(NumberText, CarriesTheUnitOfTheKey) {
  EXPECT_EQ(with_unit(0.25, "launch_length_m"), "0.25 m");
  EXPECT_EQ(with_unit(45.0, "deflector_angle_deg"), "45°");
  EXPECT_EQ(with_unit(0.8, "retention_efficiency"), "0.8");
}

}  // namespace
}  // namespace parapet::reports
