#include "words.hpp"

#include <gtest/gtest.h>

namespace parapet::designs {
namespace {

TEST(Words, UnitsOfKeys) {
  EXPECT_EQ(unit_suffix("deflector_angle_deg"), "_deg");
  EXPECT_EQ(unit_suffix("sound_speed_m_s"), "_m_s");
  EXPECT_EQ(unit_suffix("gravity_m_s2"), "_m_s2");
  EXPECT_EQ(unit_suffix("cutoff_shear_rate_per_s"), "_per_s");
  EXPECT_EQ(unit_suffix("consistency_pa_sn"), "_pa_sn");
  EXPECT_EQ(unit_suffix("flow_index"), "");
  EXPECT_EQ(unit_symbol("density_kg_m3"), "kg/m3");
}

TEST(Words, LastKeySkipsIndices) {
  EXPECT_EQ(last_key("/solids/0/vertices_m/2/1"), "vertices_m");
  EXPECT_EQ(last_key("/barriers/0/height_m"), "height_m");
  EXPECT_EQ(last_key(""), "");
}

TEST(Words, NearestWord) {
  const std::vector<std::string> keys{"height_m", "thickness_m", "foot_x_m"};
  EXPECT_EQ(nearest_word("heigth_m", keys), "height_m");  // swapped letters
  EXPECT_EQ(nearest_word("height", keys), "height_m");    // unit forgotten
  EXPECT_EQ(nearest_word("thickness_mm", keys), "thickness_m");
  EXPECT_EQ(nearest_word("retention", {"retention_change_share", "retention_efficiency"}),
            "retention_efficiency");  // only the beginning
  EXPECT_EQ(nearest_word("colour", keys), "");
  EXPECT_EQ(nearest_word("x", keys), "");
}

}  // namespace
}  // namespace parapet::designs
