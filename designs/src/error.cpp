#include "parapet/designs/error.hpp"

#include <utility>

namespace parapet::designs {
namespace {

std::string one_line_each(const std::vector<InputIssue>& issues) {
  std::string text;
  for (const InputIssue& issue : issues) {
    if (!text.empty()) text += '\n';
    text += to_string(issue);
  }
  return text;
}

}  // namespace

std::string to_string(const InputIssue& issue) {
  std::string text;
  for (const std::string* part : {&issue.file, &issue.pointer, &issue.value, &issue.problem}) {
    if (part->empty()) continue;
    if (!text.empty()) text += ": ";
    text += *part;
  }
  if (!issue.allowed.empty()) text += "; allowed: " + issue.allowed;
  return text;
}

InputError::InputError(std::vector<InputIssue> issues)
    : std::runtime_error(one_line_each(issues)), issues_(std::move(issues)) {}

}  // namespace parapet::designs
