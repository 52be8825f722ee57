#include "key_text.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "parapet/math/units.hpp"
#include "parapet/solver/metric_catalog.hpp"

namespace parapet::reports {
namespace {

TEST(KeyText, SpellsAKeyOut) {
  EXPECT_EQ(key_words("landing_speed_m_s"), "landing speed");
  EXPECT_EQ(key_words("retention_efficiency"), "retention efficiency");
  EXPECT_EQ(key_label("launch_length_m"), "launch length [m]");
  EXPECT_EQ(key_label("deflector_angle_deg"), "deflector angle [°]");
  EXPECT_EQ(key_label("retention_efficiency"), "retention efficiency");
}

/// The suffix of a key and the table of metrics name the same unit.
TEST(KeyText, KnowsTheUnitOfEveryMetric) {
  for (const solver::MetricInfo& info : solver::metric_catalog(2)) {
    EXPECT_EQ(math::unit_of(info.key).plain, info.unit) << info.key;
    EXPECT_EQ(bracketed_unit(info.key).empty(), info.unit.empty()) << info.key;
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
