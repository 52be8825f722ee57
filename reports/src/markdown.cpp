#include "markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "key_text.hpp"
#include "parapet/designs/text.hpp"

namespace parapet::reports {

std::string signed_text(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "-";
  return fmt::format("{}{}", *value > 0.0 ? "+" : "", number_text(value));
}

std::string percent_text(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:+.1f} %", *value) : "-";
}

std::string markdown_text(std::string_view text) {
  const std::string line = designs::visible_text(text);
  const auto in_word = [&](std::size_t k) {
    const auto c = static_cast<unsigned char>(k < line.size() ? line[k] : ' ');
    return std::isalnum(c) != 0 || c >= 0x80;
  };
  std::string safe;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    const std::string_view rest = std::string_view(line).substr(k);
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '_' && !(k > 0 && in_word(k - 1) && in_word(k + 1))) {
      safe += "&#95;";  // within a word it is only a letter
    } else if (rest.starts_with("](")) {
      safe +=
          "]&#40;";  // the bracket that opens is escaped; this is for readers that do not know it
      ++k;
    } else if (rest.starts_with("://")) {
      safe += "&#58;";  // some readers make a link of every address
    } else if (rest.starts_with("www.")) {
      safe += "www&#46;";
      k += 3;
    } else {
      if (std::string_view("\\`*[~$").find(c) != std::string_view::npos) safe += '\\';
      safe += c;
    }
  }
  return safe;
}

std::string code_text(std::string_view text) {
  std::string safe = designs::visible_text(text);
  std::replace(safe.begin(), safe.end(), '`', '\'');
  return safe;
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
