/// Pieces of Markdown.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parapet::reports {

/// "+0.1", "-0.1", or "-" when there is no number.
std::string signed_text(const std::optional<double>& value);

/// "+12.0 %", or "-" when there is no number.
std::string percent_text(const std::optional<double>& value);

/// Text that is shown as it is written, wherever it stands in a line: no HTML, link, picture,
/// emphasis or code begins in it, and it is one line.
std::string markdown_text(std::string_view text);

/// Text between two backticks that cannot end there.
std::string code_text(std::string_view text);

/// Text that cannot break a table's cell.
std::string cell_text(const std::string& text);

/// A table; the first row is the heading.
/// @param alignment one of l and r per column
std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& alignment);

/// "a, b and c".
std::string joined(const std::vector<std::string>& parts);

}  // namespace parapet::reports
