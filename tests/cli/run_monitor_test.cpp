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

// At 80 columns with two simulations side by side.
TEST(ProgressLine, KeepsTheBestAndTheTimeLeftOnANarrowTerminal) {
  const std::string line =
      progress_line("4 of 12 designs", "best retention_efficiency 0.8096 (0002)",
                    "at most 5 s left", "0005 at 1.10 of 3.00 s, 0006 at 0.43 of 3.00 s");
  EXPECT_EQ(cut_to_width(line, 80),
            "4 of 12 designs; best retention_efficiency 0.8096 (0002); at most 5 s left; 00…");
  EXPECT_EQ(progress_line("", "", "estimating", "H10-D45 at 0.1 of 3 s"),
            "estimating; H10-D45 at 0.1 of 3 s");
}

}  // namespace
}  // namespace parapet::cli
