// The schemas under an independent draft-07 validator: they are what they claim to be, and the
// walk that writes Parapet's messages gives the same verdict.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "parapet/designs/study_spec.hpp"
#include "schema.hpp"

namespace parapet::designs {
namespace {

/// One document without references to others: their definitions join the outer ones.
nlohmann::json bundled(const std::string& kind) {
  std::string text = embedded_schema(kind);
  for (const std::string other : {"case", "metrics"}) {
    const std::string outer = other + ".schema.json#/definitions";
    for (std::size_t at = text.find(outer); at != std::string::npos; at = text.find(outer)) {
      text.replace(at, outer.size(), "#/definitions");
    }
  }
  nlohmann::json schema = nlohmann::json::parse(text);
  for (const char* other : {"case", "metrics"}) {
    const auto inner = nlohmann::json::parse(embedded_schema(other));
    for (const auto& [key, definition] : inner.at("definitions").items()) {
      if (kind != other) schema["definitions"][key] = definition;
    }
  }
  schema.erase("$id");
  return schema;
}

/// Verdicts of the independent validator.
class Independent {
 public:
  explicit Independent(const std::string& kind) {
    const nlohmann::json document = bundled(kind);
    valijson::SchemaParser parser;
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document), schema_);
  }

  bool accepts(const Json& json) const {
    const nlohmann::json plain = nlohmann::json::parse(json.dump());
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(plain), nullptr);
  }

 private:
  valijson::Schema schema_;
};

/// Every place in a document, as JSON pointers.
std::vector<std::string> places(const Json& json) {
  std::vector<std::string> pointers;
  const Json flat = json.flatten();
  for (const auto& [pointer, value] : flat.items()) pointers.push_back(pointer);
  return pointers;
}

// (1.0 for a whole number is left out: draft-07 allows it, valijson does not.)
// Each value of the shipped specs replaced in turn by values of every kind: the verdicts agree.
TEST(SchemaCrossCheck, VerdictsAgree) {
  const Json replacements = Json::parse(
      R"([null, true, "", "no_slip", "parapet-case/1", -1000000000, -0.5, 0, 1, 1.5, 1000000000, [], [1, 2], {},
          {"unknown": 1}])");
  int refused = 0, accepted = 0;
  for (const std::string& name : embedded_spec_names()) {
    Json json = Json::parse(embedded_spec(name));
    if (name == "table3") {  // the other rows are of the same form
      json["rows"].erase(json["rows"].begin() + 4, json["rows"].end());
    }
    const std::string format = document_format(json, name);
    const std::string kind = format.substr(8, format.find('/') - 8);
    const Independent independent(kind);
    const SchemaNode schema = schema_document(kind + ".schema.json");
    ASSERT_TRUE(independent.accepts(json)) << name;
    for (const std::string& pointer : places(json)) {
      for (const Json& replacement : replacements) {
        Json changed = json;
        changed.at(Json::json_pointer(pointer)) = replacement;
        const bool accepts = schema_issues(schema, changed, name).empty();
        EXPECT_EQ(accepts, independent.accepts(changed))
            << name << pointer << " = " << replacement.dump();
        ++(accepts ? accepted : refused);
      }
    }
  }
  EXPECT_GT(refused, 500);  // both verdicts occur often enough to mean something
  EXPECT_GT(accepted, 100);
}

// Keys taken away or added: the verdicts agree.
TEST(SchemaCrossCheck, VerdictsAgreeOnMissingAndUnknownKeys) {
  for (const std::string& name : embedded_spec_names()) {
    const Json json = Json::parse(embedded_spec(name));
    const std::string format = document_format(json, name);
    const std::string kind = format.substr(8, format.find('/') - 8);
    const Independent independent(kind);
    const SchemaNode schema = schema_document(kind + ".schema.json");
    for (const auto& [key, value] : json.items()) {
      Json without = json;
      without.erase(key);
      EXPECT_EQ(schema_issues(schema, without, name).empty(), independent.accepts(without)) << key;
      Json with = json;
      with[key + "_"] = value;
      EXPECT_FALSE(independent.accepts(with)) << key;
      EXPECT_EQ(schema_issues(schema, with, name).size(), 1U) << key;
    }
  }
}

}  // namespace
}  // namespace parapet::designs
