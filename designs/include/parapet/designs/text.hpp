/// Text of strangers: what could act where it is shown is found, or made visible.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::designs {

/// Whether a text holds a character that acts instead of being shown: the control characters C0
/// (line ends and tabs among them), DEL and C1, line and paragraph separators, and those that turn
/// the direction of writing.
bool has_control_character(std::string_view text);

/// The text with each such character written as \\uXXXX, as JSON does, and each byte that is not of
/// UTF-8 as \\xNN. Safe for a terminal, and always one line.
std::string visible_text(std::string_view text);

/// The same for a text of several lines: line ends stay.
std::string visible_lines(std::string_view text);

/// An issue for each key or text in a document that holds such a character.
std::vector<InputIssue> control_character_issues(const Json& document, const std::string& file);

/// The document with visible_text in place of every text that is a value. For documents that were
/// stored: whoever wrote them need not have checked them.
Json with_visible_texts(Json document);

}  // namespace parapet::designs
