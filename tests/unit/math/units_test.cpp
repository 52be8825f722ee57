#include "parapet/math/units.hpp"

#include <gtest/gtest.h>

namespace parapet::math {
namespace {

TEST(Units, EveryPartOfTheProgramFindsItsOwn) {
  EXPECT_EQ(unit_of("deflector_angle_deg").suffix, "_deg");
  EXPECT_EQ(unit_of("gravity_m_s2").suffix, "_m_s2");
  EXPECT_EQ(unit_of("cutoff_shear_rate_per_s").suffix, "_per_s");
  EXPECT_EQ(unit_of("consistency_pa_sn").suffix, "_pa_sn");
  EXPECT_EQ(unit_of("left_mass_kg_per_m").suffix, "_kg_per_m");
  EXPECT_EQ(unit_of("slope_percent").suffix, "_percent");
}

TEST(Units, TheLongestSuffixWins) {
  EXPECT_EQ(unit_of("landing_speed_m_s").plain, "m/s");                // not s
  EXPECT_EQ(unit_of("peak_overflow_discharge_m2_s").plain, "m2/s");    // not s
  EXPECT_EQ(unit_of("slam_moment_nm_per_m").plain, "N m/m");           // not m
  EXPECT_EQ(unit_of("peak_moment_n_m_per_m").plain, "N m/m");          // not m
  EXPECT_EQ(unit_of("overflow_volume_m3_per_m").suffix, "_m3_per_m");  // not _m
  EXPECT_EQ(unit_of("shear_rate_per_s").plain, "1/s");                 // not s
  EXPECT_EQ(unit_of("viscosity_pa_s").plain, "Pa s");                  // not s
}

TEST(Units, AreSpeltForMessagesAndForReports) {
  const Unit volume = unit_of("overflow_volume_m3_per_m");
  EXPECT_EQ(volume.plain, "m3/m");
  EXPECT_EQ(volume.typographic, "m³/m");
  const Unit angle = unit_of("deflector_angle_deg");
  EXPECT_EQ(angle.plain, "deg");
  EXPECT_EQ(angle.typographic, "°");
  EXPECT_EQ(unit_of("density_kg_m3").plain, "kg/m3");
  EXPECT_EQ(unit_of("density_kg_m3").typographic, "kg/m³");
}

TEST(Units, APureNumberHasNone) {
  for (const char* key : {"retention_efficiency", "flow_index", "particles", "", "_m"}) {
    EXPECT_EQ(unit_of(key).suffix, "") << key;
    EXPECT_EQ(unit_of(key).plain, "") << key;
    EXPECT_EQ(unit_of(key).typographic, "") << key;
    EXPECT_EQ(without_unit(key), key);
  }
}

TEST(Units, KeysWithoutThem) {
  EXPECT_EQ(without_unit("launch_length_m"), "launch_length");
  EXPECT_EQ(without_unit("barrier_1_slam_force_n_per_m"), "barrier_1_slam_force");
}

}  // namespace
}  // namespace parapet::math
