/// One mistake in an otherwise sound document, and the one issue it must give.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {

struct WrongInput {
  const char* name;     ///< of the test
  const char* patch;    ///< JSON patch (RFC 6902) that makes the mistake
  const char* pointer;  ///< of the issue
  const char* problem;  ///< part of it
  const char* allowed;  ///< part of it
};

inline void PrintTo(const WrongInput& wrong, std::ostream* out) {
  *out << wrong.patch;
}

inline std::string wrong_input_name(const testing::TestParamInfo<WrongInput>& info) {
  return info.param.name;
}

/// Applies the mistake and expects exactly one issue, at its place, in its words, on one line.
template <typename Parse>
void expect_one_issue(const Json& sound, const WrongInput& wrong, Parse parse) {
  ASSERT_NO_THROW(parse(sound, "file.json")) << "the document must be sound before the mistake";
  const Json document = sound.patch(Json::parse(wrong.patch));
  try {
    parse(document, "file.json");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.issues().size(), 1U) << error.what();
    const InputIssue& issue = error.issues().front();
    EXPECT_EQ(issue.file, "file.json");
    EXPECT_EQ(issue.pointer, wrong.pointer) << error.what();
    EXPECT_NE(issue.problem.find(wrong.problem), std::string::npos) << error.what();
    EXPECT_NE(issue.allowed.find(wrong.allowed), std::string::npos) << error.what();
    EXPECT_FALSE(issue.allowed.empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    // A value is named wherever one stands.
    const Json::json_pointer place(issue.pointer);
    if (!issue.pointer.empty() && document.contains(place)) {
      EXPECT_FALSE(issue.value.empty());
    }
  }
}

}  // namespace parapet::designs
