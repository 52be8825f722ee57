/// Collects what is wrong in one JSON document, so that all of it is reported at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::designs {

/// The JSON pointer of a member or element below another.
std::string child_pointer(const std::string& pointer, std::string_view key);
std::string child_pointer(const std::string& pointer, std::size_t index);

/// The value as JSON text on one line, shortened when long.
std::string short_text(const Json& value);

/// Four significant digits, for messages.
std::string rounded(double value);

/// Whether two numbers differ by no more than four units in the last place of the larger: what a
/// sum or a conversion of units loses, and nobody means.
bool nearly_equal(double a, double b);

/// "a, b, c" with each word between `quote`s.
std::string joined(const std::vector<std::string>& words, std::string_view quote = "");

/// Findings about one document; pointers are given relative to it and reported below `prefix`.
class Findings {
 public:
  Findings(std::string file, const Json& document, std::string prefix = "");

  /// Adds an issue; its value is what the document holds at `pointer`.
  void add(const std::string& pointer, std::string problem, std::string allowed);
  void append(const std::vector<InputIssue>& issues);
  /// Empty findings about the same document.
  Findings of_its_own() const { return {file_, document_, prefix_}; }

  bool empty() const { return issues_.empty(); }
  std::size_t size() const { return issues_.size(); }
  const std::vector<InputIssue>& issues() const { return issues_; }
  const std::string& file() const { return file_; }
  /// @throws InputError when there is any finding.
  void throw_if_any() const;

 private:
  std::string file_;
  const Json& document_;
  std::string prefix_;
  std::vector<InputIssue> issues_;
};

}  // namespace parapet::designs
