#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "findings.hpp"
#include "schema.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

std::string type_name(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  if (value.is_string()) return "a text";
  if (value.is_boolean()) return "true or false";
  if (value.is_null()) return "null";
  return value.is_number_integer() ? "a whole number" : "a number";
}

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  if (type == "number") return value.is_number();
  // Draft-07: a whole number may be written 30.0.
  return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
}

bool has_any_type(const Json& value, const Json& type) {
  if (type.is_string()) return has_type(value, type.get<std::string>());
  return std::any_of(type.begin(), type.end(),
                     [&](const Json& one) { return has_type(value, one.get<std::string>()); });
}

/// "must not be a text"; of a number where only a whole one is allowed, that it is not whole.
std::string type_problem(const Json& value, const Json& type) {
  const bool whole_wanted =
      type == "integer" ||
      (type.is_array() && std::find(type.begin(), type.end(), "integer") != type.end());
  if (value.is_number() && whole_wanted) return "is not a whole number";
  return "must not be " + type_name(value);
}

/// Whether a number is beyond a bound by more than the last digits, which a calculation loses.
bool is_below(double number, double bound) {
  return number < bound && !nearly_equal(number, bound);
}

/// Whether a text is of the form that a node's maxLength and pattern ask for.
bool has_form(const Json& node, const std::string& text) {
  // The length first: the pattern search recurses with every character.
  if (node.contains("maxLength") && text.size() > node.at("maxLength").get<std::size_t>()) {
    return false;
  }
  return !node.contains("pattern") ||
         std::regex_search(text, std::regex(node.at("pattern").get<std::string>()));
}

/// One walk over a document beside its schema.
class Walk {
 public:
  Walk(const std::string& file, const std::string& prefix) : file_(file), prefix_(prefix) {}

  void visit(SchemaNode schema, const Json& value, const std::string& pointer) {
    schema = follow_reference(schema);
    if (schema->contains("type") && !has_any_type(value, schema->at("type"))) {
      add(schema, value, pointer, type_problem(value, schema->at("type")));
      return;
    }
    if (schema->contains("const") && value != schema->at("const")) {
      add(schema, value, pointer, "is not what this file should be");
      return;
    }
    if (schema->contains("enum") && !visit_word(schema, value, pointer)) return;
    if (value.is_number()) visit_number(schema, value, pointer);
    if (value.is_string()) visit_text(schema, value, pointer);
    if (value.is_array()) visit_list(schema, value, pointer);
    if (value.is_object()) visit_object(schema, value, pointer);
    if (schema->contains("allOf")) {
      for (const Json& part : schema->at("allOf")) visit({schema.document, &part}, value, pointer);
    }
  }

  /// A misspelt key that was required is one mistake, not two.
  std::vector<InputIssue> issues() && {
    std::erase_if(issues_, [&](const InputIssue& issue) {
      return issue.value.empty() && meant_.contains(issue.pointer);
    });
    return std::move(issues_);
  }

 private:
  void add(SchemaNode schema, const Json& value, const std::string& pointer,
           const std::string& problem) {
    const std::string text = pointer.empty() ? "" : short_text(value);
    issues_.push_back(
        {file_, prefix_ + pointer, text, problem, allowed_by(schema, last_key(pointer))});
  }

  bool visit_word(SchemaNode schema, const Json& value, const std::string& pointer) {
    const Json& words = schema->at("enum");
    if (std::find(words.begin(), words.end(), value) != words.end()) return true;
    std::string meant;
    if (value.is_string()) {
      meant = did_you_mean(value.get<std::string>(), words.get<std::vector<std::string>>());
    }
    add(schema, value, pointer, "is not known" + meant);
    return false;
  }

  void visit_number(SchemaNode schema, const Json& value, const std::string& pointer) {
    const double number = value.get<double>();
    const auto bound = [&](const char* key) { return schema->at(key).get<double>(); };
    if (!std::isfinite(number)) {
      add(schema, value, pointer, "is not a finite number");
    } else if ((schema->contains("minimum") && is_below(number, bound("minimum"))) ||
               (schema->contains("exclusiveMinimum") && number <= bound("exclusiveMinimum"))) {
      add(schema, value, pointer, "is too small");
    } else if (schema->contains("maximum") && is_below(bound("maximum"), number)) {
      add(schema, value, pointer, "is too large");
    }
  }

  void visit_text(SchemaNode schema, const Json& value, const std::string& pointer) {
    const std::string& text = value.get_ref<const std::string&>();
    if (schema->contains("minLength") && text.size() < schema->at("minLength").get<std::size_t>()) {
      add(schema, value, pointer, "is empty");
    } else if (schema->contains("maxLength") && !schema->contains("pattern") &&
               text.size() > schema->at("maxLength").get<std::size_t>()) {
      add(schema, value, pointer, "is " + std::to_string(text.size()) + " bytes long");
    } else if (!has_form(*schema, text)) {
      issues_.push_back({file_, prefix_ + pointer, short_text(value), "is not a name of this form",
                         schema->at("description").get<std::string>()});
    }
  }

  void visit_list(SchemaNode schema, const Json& value, const std::string& pointer) {
    if ((schema->contains("minItems") &&
         value.size() < schema->at("minItems").get<std::size_t>()) ||
        (schema->contains("maxItems") &&
         value.size() > schema->at("maxItems").get<std::size_t>())) {
      const std::string entries = value.size() == 1 ? " entry" : " entries";
      add(schema, value, pointer, "has " + std::to_string(value.size()) + entries);
      return;
    }
    if (!schema->contains("items")) return;
    for (std::size_t i = 0; i < value.size(); ++i) {
      visit({schema.document, &schema->at("items")}, value[i], child_pointer(pointer, i));
    }
  }

  void visit_object(SchemaNode schema, const Json& value, const std::string& pointer) {
    if (schema->contains("minProperties") &&
        value.size() < schema->at("minProperties").get<std::size_t>()) {
      const bool one = schema->at("minProperties") == 1;
      issues_.push_back(
          {file_, prefix_ + pointer, short_text(value),
           value.empty() ? "is empty" : "has " + std::to_string(value.size()) + " entry",
           "at least " + schema->at("minProperties").dump() + (one ? " entry" : " entries")});
    }
    for (const auto& [key, item] : value.items()) {
      visit_member(schema, key, item, child_pointer(pointer, key));
    }
    if (!schema->contains("required")) return;
    for (const Json& key : schema->at("required")) {
      const std::string name = key.get<std::string>();
      if (value.contains(name)) continue;
      const auto node = schema_at(schema, child_pointer("", name));
      issues_.push_back({file_, prefix_ + child_pointer(pointer, name), "", "is missing",
                         node ? allowed_by(*node, name) : ""});
    }
  }

  void visit_member(SchemaNode schema, const std::string& key, const Json& item,
                    const std::string& pointer) {
    if (schema->contains("properties") && schema->at("properties").contains(key)) {
      visit({schema.document, &schema->at("properties").at(key)}, item, pointer);
      return;
    }
    if (schema->contains("propertyNames")) {
      const Json& names = schema->at("propertyNames");
      if (!has_form(names, key)) {
        issues_.push_back({file_, prefix_ + pointer, short_text(item),
                           "\"" + key + "\" is not a name of this form",
                           names.at("description").get<std::string>()});
        return;
      }
    }
    if (!schema->contains("additionalProperties")) return;
    const Json& additional = schema->at("additionalProperties");
    if (additional.is_object()) {
      visit({schema.document, &additional}, item, pointer);
    } else if (additional == false) {
      const std::vector<std::string> names = property_names(schema);
      const std::string meant = nearest_word(key, names);
      const std::size_t parent = pointer.rfind('/');
      if (!meant.empty()) {
        meant_.insert(prefix_ + child_pointer(pointer.substr(0, parent), meant));
      }
      issues_.push_back({file_, prefix_ + pointer, short_text(item),
                         "unknown key" + did_you_mean(key, names), "the keys " + joined(names)});
    }
  }

  const std::string& file_;
  const std::string& prefix_;
  std::vector<InputIssue> issues_;
  std::set<std::string> meant_;  ///< pointers that misspelt keys most likely stand for
};

}  // namespace

std::vector<InputIssue> schema_issues(SchemaNode schema, const Json& value, const std::string& file,
                                      const std::string& prefix) {
  Walk walk(file, prefix);
  walk.visit(schema, value, "");
  return std::move(walk).issues();
}

}  // namespace parapet::designs
