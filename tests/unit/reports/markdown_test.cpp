// Text in Markdown is shown as it is written.
#include "markdown.hpp"

#include <gtest/gtest.h>

namespace parapet::reports {
namespace {

TEST(MarkdownText, LeavesPlainNamesAlone) {
  for (const char* text : {"dual_deflector", "launch_length_m, highest", "45°", "a (b): c; d - e",
                           "upstream height 0.1 m", "R² 0.98 + x"}) {
    EXPECT_EQ(markdown_text(text), text);
  }
}

TEST(MarkdownText, EscapesWhatActs) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"<b>", "&lt;b&gt;"},         {"&lt;", "&amp;lt;"},
      {"*a*", "\\*a\\*"},           {"_a_", "&#95;a&#95;"},
      {"`a`", "\\`a\\`"},           {"[a](javascript:b)", "\\[a]&#40;javascript:b)"},
      {"![a](b)", "!\\[a]&#40;b)"}, {"http://a", "http&#58;//a"},
      {"www.a", "www&#46;a"},       {"~~a~~", "\\~\\~a\\~\\~"},
      {"$a$", "\\$a\\$"},           {"a\\", "a\\\\"},
      {"a\n# b", "a\\\\u000a# b"}};
  for (const auto& [text, safe] : cases) EXPECT_EQ(markdown_text(text), safe);
}

TEST(MarkdownText, InATableStaysInItsCell) {
  EXPECT_EQ(cell_text(markdown_text("a|b")), "a\\|b");
  EXPECT_EQ(cell_text(markdown_text("a\\|b")), "a\\\\\\|b");
}

TEST(CodeText, CannotEndItsCode) {
  EXPECT_EQ(code_text("a ` b\n"), "a ' b\\u000a");
  EXPECT_EQ(code_text("height_m * 2 < 1"), "height_m * 2 < 1");
}

}  // namespace
}  // namespace parapet::reports
