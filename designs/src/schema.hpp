/// The JSON schemas at work: what they find in a document, and the defaults they add.
///
/// The schemas are draft-07 and hold every type, range, word list and default once. They are
/// applied by a compact validator of the few keywords they use (a unit test keeps them to those,
/// and compares every verdict with an independent validator). A general validator answers with
/// "could not be validated against schema 0 of allOf" and one line per level; here each mistake
/// must give one sentence with the value, the allowed range with its unit and the nearest key.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/case_spec.hpp"

namespace parapet::designs {

/// A place in a schema: the node, and the document that its local references belong to.
struct SchemaNode {
  const Json* document = nullptr;
  const Json* node = nullptr;

  const Json& operator*() const { return *node; }
  const Json* operator->() const { return node; }
};

/// An embedded schema document by file name, for example "case.schema.json".
SchemaNode schema_document(const std::string& file_name);

/// The node itself, or the one that its $ref names.
SchemaNode follow_reference(SchemaNode schema);

/// The node that a JSON pointer into a document leads to, when the schema knows that place.
std::optional<SchemaNode> schema_at(SchemaNode schema, const std::string& pointer);

/// Everything that the schema finds; pointers are reported below `prefix`.
std::vector<InputIssue> schema_issues(SchemaNode schema, const Json& value, const std::string& file,
                                      const std::string& prefix = "");

/// The value with every default written out, keys in the schema's order.
/// Precondition: schema_issues found nothing.
Json with_defaults(SchemaNode schema, const Json& value);

/// What a node allows, as a phrase: "a number from 0.001 to 100 [m]". The key gives the unit.
std::string allowed_by(SchemaNode schema, const std::string& key);

/// Keys of an object node, in the schema's order.
std::vector<std::string> property_names(SchemaNode schema);

}  // namespace parapet::designs
