#include "markdown.hpp"

#include <fmt/format.h>

#include "key_text.hpp"

namespace parapet::reports {

std::optional<double> value_of(const designs::Json& json) {
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

std::string text_of(const designs::Json& json) {
  return json.is_string() ? json.get<std::string>() : "";
}

std::string signed_text(const designs::Json& value) {
  if (!value.is_number()) return "-";
  return fmt::format("{}{}", value.get<double>() > 0.0 ? "+" : "",
                     number_text(value.get<double>()));
}

std::string percent_text(const designs::Json& value) {
  return value.is_number() ? fmt::format("{:+.1f} %", value.get<double>()) : "-";
}

std::string cell_text(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|') safe += '\\';
    safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& alignment) {
  std::string text;
  for (std::size_t line = 0; line < rows.size(); ++line) {
    for (const std::string& cell : rows[line]) text += "| " + cell_text(cell) + " ";
    text += "|\n";
    if (line > 0) continue;
    for (const char side : alignment) text += side == 'r' ? "|---:" : "|---";
    text += "|\n";
  }
  return text + "\n";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    text += k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ";
    text += parts[k];
  }
  return text;
}

}  // namespace parapet::reports
