#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "findings.hpp"
#include "parapet/designs/case_spec.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

constexpr int deepest_nesting = 64;

struct TooDeep : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Follows the parser and notes every key that stands twice in one object: the parser itself would
/// keep the last and lose the others in silence.
class DuplicateKeys {
 public:
  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (depth > deepest_nesting) throw TooDeep("nested too deeply");
    if (event == Event::key) {
      levels_.back().key = parsed.get<std::string>();
      if (!levels_.back().seen.insert(levels_.back().key).second) found_.push_back(pointer());
    } else if (event == Event::object_start || event == Event::array_start) {
      levels_.push_back({event == Event::array_start, 0, "", {}});
    } else {
      if (event != Event::value) levels_.pop_back();
      if (!levels_.empty() && levels_.back().is_array) ++levels_.back().index;
    }
    return true;
  }

  const std::vector<std::string>& found() const { return found_; }

 private:
  struct Level {
    bool is_array;
    std::size_t index;
    std::string key;
    std::set<std::string> seen;
  };

  std::string pointer() const {
    std::string text;
    for (const Level& level : levels_) {
      text = level.is_array ? child_pointer(text, level.index) : child_pointer(text, level.key);
    }
    return text;
  }

  std::vector<Level> levels_;
  std::vector<std::string> found_;
};

/// "line 3, column 5", counted from 1, of the byte (counted from 1 too) at which the parser
/// stopped. Its own count is one line off where a number ends a line.
std::string place_in(const std::string& text, std::size_t byte) {
  const std::size_t offset = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const std::size_t line_break = offset > 0 ? text.rfind('\n', offset - 1) : std::string::npos;
  const std::size_t column = line_break == std::string::npos ? offset + 1 : offset - line_break;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The library's message without its number and its own place.
std::string bare_message(const Json::exception& error) {
  const std::string text = error.what();
  for (const char* mark : {"syntax error ", "number overflow "}) {
    const std::size_t at = text.find(mark);
    if (at != std::string::npos) return text.substr(at);
  }
  return text;
}

}  // namespace

Json parse_json(const std::string& text, const std::string& file) {
  DuplicateKeys duplicates;
  const auto fail = [&](const std::string& problem) {
    return InputError({{file, "", "", problem, "a JSON document"}});
  };
  Json json;
  try {
    json = Json::parse(text, std::ref(duplicates));
  } catch (const Json::parse_error& error) {
    throw fail("is not JSON: " + place_in(text, error.byte) + ": " + bare_message(error));
  } catch (const Json::exception& error) {
    throw fail("is not JSON: " + bare_message(error));
  } catch (const TooDeep&) {
    throw fail("is nested more than " + std::to_string(deepest_nesting) + " levels deep");
  }
  std::vector<InputIssue> issues;
  for (const std::string& pointer : duplicates.found()) {
    issues.push_back({file, pointer, "", "stands twice", "each key once"});
  }
  if (!issues.empty()) throw InputError(issues);
  return json;
}

Json read_json(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (std::filesystem::is_directory(file)) {
    throw InputError({{name, "", "", "is a folder", "a JSON file"}});
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const std::string why = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    throw InputError({{name, "", "", "cannot be read" + why, "a JSON file"}});
  }
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return parse_json(text, name);
}

std::string document_format(const Json& json, const std::string& file) {
  const std::vector<std::string> known{"parapet-case/1", "parapet-study/1", "parapet-sweep/1"};
  const std::string allowed = "one of " + joined(known, "\"");
  if (!json.is_object()) {
    throw InputError({{file, "", "", "must be an object", "an object with the key format"}});
  }
  if (!json.contains("format")) throw InputError({{file, "/format", "", "is missing", allowed}});
  const Json& format = json.at("format");
  if (format.is_string()) {
    for (const std::string& one : known) {
      if (format == one) return one;
    }
  }
  const std::string meant =
      format.is_string() ? did_you_mean(format.get<std::string>(), known) : "";
  throw InputError({{file, "/format", short_text(format), "is not known" + meant, allowed}});
}

}  // namespace parapet::designs
