#include "findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace parapet::designs {

std::string child_pointer(const std::string& pointer, std::string_view key) {
  std::string result = pointer + '/';
  for (const char c : key) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

std::string child_pointer(const std::string& pointer, std::size_t index) {
  return pointer + '/' + std::to_string(index);
}

std::string short_text(const Json& value) {
  constexpr std::size_t longest = 60;
  std::string text = value.dump(-1, ' ', true);  // ASCII only: safe to cut anywhere
  if (text.size() > longest) text = text.substr(0, longest - 3) + "...";
  return text;
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

bool nearly_equal(double a, double b) {
  constexpr double tolerance = 4.0 * std::numeric_limits<double>::epsilon();
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

std::string joined(const std::vector<std::string>& words, std::string_view quote) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += ", ";
    text.append(quote).append(word).append(quote);
  }
  return text;
}

Findings::Findings(std::string file, const Json& document, std::string prefix)
    : file_(std::move(file)), document_(document), prefix_(std::move(prefix)) {}

void Findings::add(const std::string& pointer, std::string problem, std::string allowed) {
  const Json::json_pointer place(pointer);
  std::string value = document_.contains(place) ? short_text(document_.at(place)) : "";
  if (pointer.empty()) value.clear();  // the whole document says nothing
  issues_.push_back(
      {file_, prefix_ + pointer, std::move(value), std::move(problem), std::move(allowed)});
}

void Findings::append(const std::vector<InputIssue>& issues) {
  issues_.insert(issues_.end(), issues.begin(), issues.end());
}

void Findings::throw_if_any() const {
  if (!issues_.empty()) throw InputError(issues_);
}

}  // namespace parapet::designs
