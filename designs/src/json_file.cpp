#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "findings.hpp"
#include "parapet/designs/case_spec.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

constexpr int deepest_nesting = 64;

/// Of one object. Looking a key up takes a walk over its object, so without a limit a file of
/// hundreds of thousands of keys would keep the program busy for minutes.
constexpr std::size_t most_keys = 5000;

/// More of the same need not be said.
constexpr std::size_t most_repeated = 100;

/// Beyond it a file is not one of ours; a device such as /dev/zero never ends.
constexpr std::size_t most_bytes = 256UL << 20U;

struct TooDeep : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct TooManyKeys : std::runtime_error {
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
      if (levels_.back().seen.size() >= most_keys) throw TooManyKeys("too many keys");
      levels_.back().key = parsed.get<std::string>();
      if (!levels_.back().seen.insert(levels_.back().key).second && found_.size() < most_repeated) {
        found_.push_back(pointer());
      }
    } else if (event == Event::object_start || event == Event::array_start) {
      levels_.push_back({event == Event::array_start, 0, "", {}});
    } else {
      if (event != Event::value) levels_.pop_back();
      if (!levels_.empty() && levels_.back().is_array) ++levels_.back().index;
    }
    return true;
  }

  const std::vector<std::string>& found() const { return found_; }

  /// Where the parser is.
  std::string pointer() const { return pointer_to(levels_.size()); }
  /// The object or list that it is in.
  std::string parent_pointer() const {
    return pointer_to(levels_.empty() ? 0 : levels_.size() - 1);
  }

 private:
  struct Level {
    bool is_array;
    std::size_t index;
    std::string key;
    std::set<std::string> seen;
  };

  std::string pointer_to(std::size_t depth) const {
    std::string text;
    for (std::size_t k = 0; k < depth; ++k) {
      const Level& level = levels_[k];
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

/// "[json.exception.type_error.302] type must be ..." without the number in brackets.
std::string without_number(const std::string& text) {
  const std::size_t end = text.starts_with("[json.exception") ? text.find("] ") : std::string::npos;
  return end == std::string::npos ? text : text.substr(end + 2);
}

/// The library's message without its number and its own place.
std::string bare_message(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t at = text.find("syntax error ");
  return at == std::string::npos ? without_number(text) : text.substr(at);
}

/// The number that the library's message quotes.
std::string overflowing_number(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t from = text.find('\''), to = text.rfind('\'');
  if (from == std::string::npos || to <= from) return "";
  const std::string number = text.substr(from + 1, to - from - 1);
  return number.size() > 60 ? number.substr(0, 57) + "..." : number;
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
  } catch (const Json::out_of_range& error) {
    throw InputError({{file, duplicates.pointer(), overflowing_number(error),
                       "is beyond every number that the program can hold",
                       "a number between -1.7e308 and 1.7e308"}});
  } catch (const Json::exception& error) {
    throw fail("is not JSON: " + bare_message(error));
  } catch (const TooManyKeys&) {
    throw InputError({{file, duplicates.parent_pointer(), "",
                       "holds more than " + std::to_string(most_keys) + " keys",
                       "at most " + std::to_string(most_keys) + " keys in one object"}});
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
    const std::string why =
        errno != 0 ? std::string(": ") + std::generic_category().message(errno) : "";
    throw InputError({{name, "", "", "cannot be read" + why, "a JSON file"}});
  }
  std::string text;
  std::vector<char> part(1U << 16U);
  while (stream) {
    stream.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most_bytes) {
      throw InputError(
          {{name, "", "", "is larger than " + std::to_string(most_bytes >> 20U) + " MiB",
            "a JSON file of at most that size"}});
    }
  }
  return parse_json(text, name);
}

void throw_misread(const std::filesystem::path& file, const Json::exception& error) {
  throw InputError(
      {{file.string(), "", "", "does not hold what it should: " + without_number(error.what()),
        "the file as Parapet wrote it"}});
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
