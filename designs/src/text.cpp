#include "parapet/designs/text.hpp"

#include <cstdint>

#include "findings.hpp"

namespace parapet::designs {
namespace {

struct Character {
  char32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;
};

/// The first character of a text, which must not be empty (RFC 3629).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {.code = lead, .bytes = 1, .valid = true};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  char32_t code = lead & (0xFFU >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return {};
    code = (code << 6) | (byte(k) & 0x3FU);
  }
  const bool too_long = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (too_long || surrogate || code > 0x10FFFF) return {};
  return {.code = code, .bytes = bytes, .valid = true};
}

bool acts(char32_t code) {
  const bool control = code < 0x20 || (code >= 0x7F && code <= 0x9F);
  const bool separator = code == 0x2028 || code == 0x2029;
  const bool turns = code == 0x061C || code == 0x200E || code == 0x200F ||
                     (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return control || separator || turns;
}

std::string hexadecimal(std::uint32_t number, std::size_t length) {
  std::string text(length, '0');
  for (std::size_t k = 0; k < length; ++k) {
    text[length - 1 - k] = "0123456789abcdef"[(number >> (4 * k)) & 0xFU];
  }
  return text;
}

std::string visible(std::string_view text, bool several_lines) {
  std::string result;
  while (!text.empty()) {
    const Character character = first_character(text);
    if (!character.valid) {
      result += "\\x" + hexadecimal(static_cast<unsigned char>(text.front()), 2);
    } else if (acts(character.code) && !(several_lines && character.code == U'\n')) {
      result += "\\u" + hexadecimal(static_cast<std::uint32_t>(character.code), 4);
    } else {
      result += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes);
  }
  return result;
}

/// Walks over a document with the pointer of each place.
void find_controls(const Json& value, const std::string& pointer, const std::string& file,
                   std::vector<InputIssue>& issues) {
  const auto add = [&](const std::string& place, const std::string& text, const char* what) {
    issues.push_back({.file = file,
                      .pointer = visible_text(place),
                      .value = Json(text).dump(-1, ' ', true),
                      .problem = std::string(what) + " a control character",
                      .allowed = "characters that can be shown, on one line"});
  };
  if (value.is_string() && has_control_character(value.get_ref<const std::string&>())) {
    add(pointer, value.get<std::string>(), "holds");
  }
  if (value.is_array()) {
    for (std::size_t k = 0; k < value.size(); ++k) {
      find_controls(value[k], child_pointer(pointer, k), file, issues);
    }
  }
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) {
      const std::string place = child_pointer(pointer, key);
      if (has_control_character(key)) add(place, key, "the key holds");
      find_controls(item, place, file, issues);
    }
  }
}

}  // namespace

bool has_control_character(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (!character.valid || acts(character.code)) return true;
    text.remove_prefix(character.bytes);
  }
  return false;
}

std::string visible_text(std::string_view text) {
  return visible(text, false);
}

std::string visible_lines(std::string_view text) {
  return visible(text, true);
}

std::vector<InputIssue> control_character_issues(const Json& document, const std::string& file) {
  std::vector<InputIssue> issues;
  find_controls(document, "", file, issues);
  return issues;
}

Json with_visible_texts(Json document) {
  if (document.is_string()) return visible_text(document.get_ref<const std::string&>());
  if (document.is_structured()) {
    for (Json& item : document) item = with_visible_texts(std::move(item));
  }
  return document;
}

}  // namespace parapet::designs
