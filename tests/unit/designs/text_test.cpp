// Texts that act are found and made visible.
#include "parapet/designs/text.hpp"

#include <gtest/gtest.h>

namespace parapet::test {
namespace {

using designs::has_control_character;
using designs::visible_text;

TEST(Text, ThatOnlyShowsIsLeftAlone) {
  for (const char* text :
       {"", "plain", "Murgang-Sperre Ü, 45°", "日本", "🙂", "a\\b \"c\" <d>"}) {
    EXPECT_FALSE(has_control_character(text)) << text;
    EXPECT_EQ(visible_text(text), text);
  }
}

TEST(Text, ThatActsIsFoundAndMadeVisible) {
  const std::vector<std::pair<std::string, std::string>> cases{{"\x1b[2J", "\\u001b[2J"},
                                                               {"a\nb", "a\\u000ab"},
                                                               {"\t", "\\u0009"},
                                                               {"\x7f", "\\u007f"},
                                                               {"\xc2\x80", "\\u0080"},
                                                               {"\xc2\x9b", "\\u009b"},
                                                               {"\xe2\x80\xae", "\\u202e"},
                                                               {"\xe2\x81\xa9", "\\u2069"},
                                                               {"\xd8\x9c", "\\u061c"},
                                                               {"\xe2\x80\xa9", "\\u2029"},
                                                               {std::string("\0", 1), "\\u0000"}};
  for (const auto& [text, shown] : cases) {
    EXPECT_TRUE(has_control_character("a" + text)) << shown;
    EXPECT_EQ(visible_text("a" + text + "b"), "a" + shown + "b");
  }
  EXPECT_EQ(designs::visible_lines("a\nb\x1b\n"), "a\nb\\u001b\n");
}

TEST(Text, BytesThatAreNoUtf8AreMadeVisible) {
  EXPECT_EQ(visible_text("a\x9b"
                         "b"),
            "a\\x9bb");                               // C1 in Latin-1
  EXPECT_EQ(visible_text("\xc3"), "\\xc3");           // cut short
  EXPECT_EQ(visible_text("\xc0\x9b"), "\\xc0\\x9b");  // too long a form
  EXPECT_EQ(visible_text("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");
  EXPECT_EQ(visible_text("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(visible_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(Text, OfADocumentIsNamedByItsPointer) {
  const designs::Json json = designs::Json::parse(
      R"({"name": "a\u001b", "list": ["b", "c\u0007"], "k\u0000": 1, "fine": "ü"})");
  const auto issues = designs::control_character_issues(json, "file");
  ASSERT_EQ(issues.size(), 3U);
  EXPECT_EQ(issues[0].pointer, "/name");
  EXPECT_EQ(issues[0].value, "\"a\\u001b\"");
  EXPECT_EQ(issues[1].pointer, "/list/1");
  EXPECT_EQ(issues[2].pointer, "/k\\u0000");
  const designs::Json visible = designs::with_visible_texts(json);
  EXPECT_EQ(visible["name"], "a\\u001b");
  EXPECT_EQ(visible["list"][1], "c\\u0007");
  EXPECT_EQ(visible["fine"], "ü");
}

}  // namespace
}  // namespace parapet::test
