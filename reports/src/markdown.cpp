#include "markdown.hpp"

#include <fmt/format.h>

#include <cmath>

#include "key_text.hpp"

namespace parapet::reports {

std::string signed_text(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "-";
  return fmt::format("{}{}", *value > 0.0 ? "+" : "", number_text(value));
}

std::string percent_text(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:+.1f} %", *value) : "-";
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
