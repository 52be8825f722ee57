#include "schema.hpp"

#include <map>
#include <stdexcept>

#include "embedded.hpp"
#include "findings.hpp"
#include "parapet/math/units.hpp"

namespace parapet::designs {
namespace {

std::map<std::string, Json> parsed_schemas() {
  std::map<std::string, Json> schemas;
  for (const EmbeddedFile& file : embedded_files()) {
    const std::string name = file.name;
    if (name.ends_with(".schema.json")) schemas[name] = Json::parse(file.text);
  }
  return schemas;
}

std::string with_unit(std::string text, const std::string& key) {
  const std::string_view unit = math::unit_of(key).plain;
  if (!unit.empty()) text.append(" [").append(unit).append("]");
  return text;
}

std::string range_text(const Json& node, const std::string& kind) {
  const auto bound = [&](const char* key) { return node.at(key).dump(); };
  std::string text = kind;
  if (node.contains("minimum") && node.contains("maximum")) {
    return text + " from " + bound("minimum") + " to " + bound("maximum");
  }
  if (node.contains("minimum")) text += " from " + bound("minimum");
  if (node.contains("exclusiveMinimum")) text += " above " + bound("exclusiveMinimum");
  if (node.contains("maximum")) text += " up to " + bound("maximum");
  return text;
}

std::string size_text(const Json& node) {
  const auto entries = [&](const char* key) {
    const int n = node.at(key).get<int>();
    return std::to_string(n) + (n == 1 ? " entry" : " entries");
  };
  if (node.contains("minItems") && node.contains("maxItems")) {
    if (node.at("minItems") == node.at("maxItems")) return "a list of " + entries("minItems");
    return "a list of " + node.at("minItems").dump() + " to " + entries("maxItems");
  }
  if (node.contains("minItems")) return "a list of at least " + entries("minItems");
  if (node.contains("maxItems")) return "a list of at most " + entries("maxItems");
  return "a list";
}

std::string allowed_type(SchemaNode schema, const std::string& type, const std::string& key) {
  if (type == "number") return with_unit(range_text(*schema, "a number"), key);
  if (type == "integer") return with_unit(range_text(*schema, "a whole number"), key);
  if (type == "boolean") return "true or false";
  if (type == "null") return "null";
  if (type == "array") return size_text(*schema);
  if (type == "string") {
    std::string text = schema->contains("minLength") ? "a text that is not empty" : "a text";
    if (schema->contains("maxLength")) {
      text += (schema->contains("minLength") ? " and" : " of");
      text += " at most " + schema->at("maxLength").dump() +
              (schema->contains("minLength") ? " bytes long" : " bytes");
    }
    return text;
  }
  const std::vector<std::string> names = property_names(schema);
  return names.empty() ? "an object" : "an object with the keys " + joined(names);
}

}  // namespace

SchemaNode schema_document(const std::string& file_name) {
  static const std::map<std::string, Json> schemas = parsed_schemas();
  const auto found = schemas.find(file_name);
  if (found == schemas.end()) throw std::logic_error("no schema " + file_name);
  return {&found->second, &found->second};
}

SchemaNode follow_reference(SchemaNode schema) {
  while (schema->contains("$ref")) {
    const std::string reference = schema->at("$ref").get<std::string>();
    const std::size_t hash = reference.find('#');
    const std::string file = reference.substr(0, hash);
    const Json* document = file.empty() ? schema.document : schema_document(file).document;
    schema = {document, &document->at(Json::json_pointer(reference.substr(hash + 1)))};
  }
  return schema;
}

std::optional<SchemaNode> schema_at(SchemaNode schema, const std::string& pointer) {
  schema = follow_reference(schema);
  if (pointer.empty()) return schema;
  if (schema->contains("allOf")) {
    for (const Json& part : schema->at("allOf")) {
      if (const auto found = schema_at({schema.document, &part}, pointer)) return found;
    }
    return std::nullopt;
  }
  const std::size_t slash = pointer.find('/', 1);
  const std::string token = pointer.substr(1, slash == std::string::npos ? slash : slash - 1);
  const std::string rest = slash == std::string::npos ? "" : pointer.substr(slash);
  if (schema->contains("properties") && schema->at("properties").contains(token)) {
    return schema_at({schema.document, &schema->at("properties").at(token)}, rest);
  }
  const bool is_index =
      !token.empty() && token.find_first_not_of("0123456789") == std::string::npos;
  if (is_index && schema->contains("items")) {
    return schema_at({schema.document, &schema->at("items")}, rest);
  }
  return std::nullopt;
}

namespace {

/// A number that is beyond a bound by its last digits only becomes the bound.
Json within_bounds(const Json& schema, const Json& value) {
  if (!value.is_number_float()) return value;
  const double number = value.get<double>();
  for (const char* key : {"minimum", "maximum"}) {
    if (!schema.contains(key)) continue;
    const double bound = schema.at(key).get<double>();
    const bool beyond = std::string_view(key) == "minimum" ? number < bound : number > bound;
    if (beyond && nearly_equal(number, bound)) return bound;
  }
  return value;
}

}  // namespace

Json with_defaults(SchemaNode schema, const Json& value) {
  schema = follow_reference(schema);
  if (schema->contains("allOf")) {
    Json result = value;
    for (const Json& part : schema->at("allOf")) {
      result = with_defaults({schema.document, &part}, result);
    }
    return result;
  }
  if (value.is_array() && schema->contains("items")) {
    Json result = Json::array();
    for (const Json& item : value) {
      result.push_back(with_defaults({schema.document, &schema->at("items")}, item));
    }
    return result;
  }
  if (!value.is_object() || !schema->contains("properties")) {
    if (value.is_object() && schema->contains("additionalProperties") &&
        schema->at("additionalProperties").is_object()) {
      Json result = Json::object();
      for (const auto& [key, item] : value.items()) {
        result[key] = with_defaults({schema.document, &schema->at("additionalProperties")}, item);
      }
      return result;
    }
    return within_bounds(*schema, value);
  }
  Json result = Json::object();
  for (const auto& [key, part] : schema->at("properties").items()) {
    const SchemaNode node = follow_reference({schema.document, &part});
    if (value.contains(key)) {
      result[key] = with_defaults(node, value.at(key));
    } else if (node->contains("default")) {
      result[key] = with_defaults(node, node->at("default"));
    }
  }
  return result;
}

std::string allowed_by(SchemaNode schema, const std::string& key) {
  schema = follow_reference(schema);
  if (schema->contains("const")) return schema->at("const").dump();
  if (schema->contains("enum")) {
    std::vector<std::string> words;
    for (const Json& word : schema->at("enum")) words.push_back(word.dump());
    return "one of " + joined(words);
  }
  if (!schema->contains("type")) return "";
  const Json& type = schema->at("type");
  if (type.is_string()) return allowed_type(schema, type.get<std::string>(), key);
  std::string text;
  for (const Json& one : type) {
    if (!text.empty()) text += ", or ";
    text += allowed_type(schema, one.get<std::string>(), key);
  }
  return text;
}

std::vector<std::string> property_names(SchemaNode schema) {
  schema = follow_reference(schema);
  std::vector<std::string> names;
  if (!schema->contains("properties")) return names;
  for (const auto& [key, part] : schema->at("properties").items()) {
    if (key != "$schema") names.push_back(key);
  }
  return names;
}

}  // namespace parapet::designs
