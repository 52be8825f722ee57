/// Bad input: every finding at once, each naming file, place, value and what is allowed.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace parapet::designs {

/// One thing wrong in an input file.
struct InputIssue {
  std::string file;     ///< as the user gave it
  std::string pointer;  ///< JSON pointer, for example /barriers/0/height_m
  std::string value;    ///< what stands there, as JSON text; empty when something is missing
  std::string problem;  ///< one sentence: what is wrong
  std::string allowed;  ///< one phrase: what is allowed
};

/// "file: /pointer: value: problem; allowed: ...", on one line.
std::string to_string(const InputIssue& issue);

/// Thrown by everything that reads input; what() holds one line per issue.
class InputError : public std::runtime_error {
 public:
  /// @param issues at least one
  explicit InputError(std::vector<InputIssue> issues);
  /// Every finding, in the order of the file.
  const std::vector<InputIssue>& issues() const { return issues_; }

 private:
  std::vector<InputIssue> issues_;
};

}  // namespace parapet::designs
