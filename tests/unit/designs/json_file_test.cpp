#include <gtest/gtest.h>

#include <filesystem>

#include "parapet/designs/case_spec.hpp"

namespace parapet::designs {
namespace {

std::string message_of(const std::string& text) {
  try {
    parse_json(text, "file.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// A syntax error names line and column.
TEST(JsonText, SyntaxErrorsNameLineAndColumn) {
  const std::string message = message_of("{\n  \"a\": 1,\n  \"b\" 2\n}");
  EXPECT_EQ(message.find("file.json: is not JSON: line 3, column 7"), 0U) << message;
  EXPECT_NE(message_of("").find("is not JSON: line 1, column 1"), std::string::npos);
  EXPECT_NE(message_of("{\"a\": 1").find("is not JSON"), std::string::npos);
  EXPECT_NE(message_of("{\"a\": 1} x").find("is not JSON"), std::string::npos);
}

// A number too large for a double must not become an infinity.
TEST(JsonText, NumbersOutOfRangeAreRefused) {
  EXPECT_EQ(message_of("{\"a\": 1e999}").find("file.json: /a: 1e999: is beyond every number"), 0U)
      << message_of("{\"a\": 1e999}");
  EXPECT_EQ(message_of(R"({"b": [0, {"x": 1, "y": -1e400}]})").find("file.json: /b/1/y: -1e400: "),
            0U)
      << message_of(R"({"b": [0, {"x": 1, "y": -1e400}]})");
  EXPECT_EQ(message_of("[1, 2, 1e309]").find("file.json: /2: 1e309: "), 0U);
  EXPECT_EQ(message_of("1e400").find("file.json: 1e400: "), 0U) << message_of("1e400");
  EXPECT_EQ(message_of("[1e308, 1e-400]"), "accepted");
}

// Each key is looked up in its object: without a limit, 400,000 of them took a minute.
TEST(JsonText, ManyKeysAreRefusedAtOnce) {
  const auto with_keys = [](int count) {
    std::string text = "{\"format\": \"f\", \"inner\": {";
    for (int k = 0; k < count; ++k) text += (k ? ",\"k" : "\"k") + std::to_string(k) + "\":1";
    return text + "}}";
  };
  EXPECT_EQ(message_of(with_keys(5000)), "accepted");
  EXPECT_EQ(
      message_of(with_keys(400000)),
      "file.json: /inner: holds more than 5000 keys; allowed: at most 5000 keys in one object");
  std::string repeated = "{\"a\":1";
  for (int k = 0; k < 400000; ++k) repeated += ",\"a\":1";
  EXPECT_LT(message_of(repeated + "}").size(), 10000U) << "said a hundred times at most";
}

// A device never ends.
TEST(JsonText, EndlessFilesAreRefused) {
  if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "no such device here";
  try {
    read_json("/dev/zero");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/zero: is larger than"), std::string::npos);
  }
}

// Keeping the last of two equal keys would lose the other in silence.
TEST(JsonText, DuplicateKeysAreNamed) {
  EXPECT_EQ(message_of(R"({"a": [{}, {"b": 1, "c": {"b": 0}, "b": 2}], "d": 1})"),
            "file.json: /a/1/b: stands twice; allowed: each key once");
  EXPECT_EQ(message_of(R"({"a": {"x": 1}, "b": {"x": 1}, "c": [{"x": 1}, {"x": 1}]})"), "accepted");
}

// Recursion through a hostile document must not end the program.
TEST(JsonText, DeepNestingIsRefused) {
  EXPECT_NE(message_of(std::string(100000, '[')).find("nested more than 64 levels"),
            std::string::npos);
}

TEST(JsonText, MissingFilesAndFoldersAreNamed) {
  try {
    read_json("no_such_folder/no_such_file.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what())
                  .find("no_such_folder/no_such_file.json: cannot be read: No such file"),
              0U)
        << error.what();
  }
  EXPECT_THROW(read_json(std::filesystem::temp_directory_path()), InputError);
}

TEST(DocumentFormat, IsNamedOrRefused) {
  EXPECT_EQ(document_format(Json::parse(R"({"format": "parapet-study/1"})"), "f"),
            "parapet-study/1");
  EXPECT_THROW(document_format(Json::parse("[]"), "f"), InputError);
  EXPECT_THROW(document_format(Json::parse("{}"), "f"), InputError);
  try {
    document_format(Json::parse(R"({"format": "parapet-studie/1"})"), "f");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"parapet-study/1\"?"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace parapet::designs
