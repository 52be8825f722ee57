#include "words.hpp"

#include <gtest/gtest.h>

namespace parapet::designs {
namespace {

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
