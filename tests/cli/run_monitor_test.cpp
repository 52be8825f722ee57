// The line that shows how far a run is.
#include "run_monitor.hpp"

#include <gtest/gtest.h>

namespace parapet::cli {
namespace {

TEST(CutToWidth, LeavesTheLastColumnFree) {
  EXPECT_EQ(cut_to_width("abcdefghij", 11), "abcdefghij");
  EXPECT_EQ(cut_to_width("abcdefghij", 10), "abcdefgh…");
  EXPECT_EQ(cut_to_width("abcdefghij", 5), "abc…");
  EXPECT_EQ(cut_to_width("", 80), "");
}

TEST(CutToWidth, CountsCharactersAndSplitsNone) {
  EXPECT_EQ(cut_to_width("äöüäöüäöüä", 11), "äöüäöüäöüä");
  EXPECT_EQ(cut_to_width("äöüäöüäöüä", 6), "äöüä…");
  EXPECT_EQ(cut_to_width("°°°", 3), "°…");
}

}  // namespace
}  // namespace parapet::cli
