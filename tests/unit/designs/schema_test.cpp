#include "schema.hpp"

#include <gtest/gtest.h>

#include <set>

#include "parapet/designs/study_spec.hpp"
#include "parapet/math/units.hpp"

namespace parapet::designs {
namespace {

constexpr const char* documents[] = {"case.schema.json", "metrics.schema.json", "study.schema.json",
                                     "sweep.schema.json"};

// What the walk over the schemas understands. A keyword beyond these would be ignored in silence.
const std::set<std::string> keywords{"$schema",
                                     "$id",
                                     "title",
                                     "description",
                                     "$ref",
                                     "allOf",
                                     "type",
                                     "const",
                                     "enum",
                                     "default",
                                     "x-scales-with",  // see event_defaults.cpp
                                     "examples",       // for editors
                                     "minimum",
                                     "maximum",
                                     "exclusiveMinimum",
                                     "minLength",
                                     "maxLength",
                                     "pattern",
                                     "minItems",
                                     "maxItems",
                                     "items",
                                     "minProperties",
                                     "propertyNames",
                                     "properties",
                                     "required",
                                     "additionalProperties",
                                     "definitions"};

/// Calls visit(node, pointer) for every schema node of a document.
template <typename Visit>
void for_each_node(const Json& node, const std::string& pointer, Visit visit) {
  visit(node, pointer);
  for (const char* map : {"properties", "definitions"}) {
    if (!node.contains(map)) continue;
    for (const auto& [key, part] : node.at(map).items()) {
      std::string place = pointer;
      place.append("/").append(map).append("/").append(key);
      for_each_node(part, place, visit);
    }
  }
  for (const char* one : {"items", "additionalProperties", "propertyNames"}) {
    if (node.contains(one) && node.at(one).is_object()) {
      for_each_node(node.at(one), pointer + "/" + one, visit);
    }
  }
  if (node.contains("allOf")) {
    for (const Json& part : node.at("allOf")) for_each_node(part, pointer + "/allOf", visit);
  }
}

TEST(Schema, UsesOnlyKeywordsThatAreUnderstood) {
  for (const char* name : documents) {
    const SchemaNode document = schema_document(name);
    for_each_node(*document, "", [&](const Json& node, const std::string& pointer) {
      for (const auto& [keyword, value] : node.items()) {
        EXPECT_TRUE(keywords.contains(keyword)) << name << pointer << " uses " << keyword;
      }
      if (node.contains("$ref")) {
        EXPECT_EQ(node.size(), 1U) << name << pointer << ": draft-07 ignores what stands beside";
        EXPECT_NO_THROW(follow_reference({document.document, &node})) << name << pointer;
      }
    });
  }
}

// Every input says what it is, and every default is allowed by its own node.
TEST(Schema, EveryInputIsDescribedAndEveryDefaultIsSound) {
  for (const char* name : documents) {
    const SchemaNode document = schema_document(name);
    for_each_node(*document, "", [&](const Json& node, const std::string& pointer) {
      if (node.contains("default")) {
        EXPECT_TRUE(schema_issues({document.document, &node}, node.at("default"), "").empty())
            << name << pointer;
      }
      if (!node.contains("properties")) return;
      for (const auto& [key, part] : node.at("properties").items()) {
        const SchemaNode input = follow_reference({document.document, &part});
        if (key == "case") continue;  // described by its own schema
        EXPECT_TRUE(input->contains("description")) << name << pointer << "/" << key;
      }
    });
  }
}

// House rule: a key that carries a quantity carries its unit. These have none.
TEST(Schema, NumbersCarryTheirUnit) {
  const std::set<std::string> pure{
      "flow_index",       "smoothing_ratio",      "density_diffusion", "shifting_factor",
      "skin_ratio",       "cfl_acoustic",         "cfl_force",         "cfl_viscous",
      "steps_per_solve",  "cg_max_iterations",    "lattice_jitter",    "lattice_seed",
      "retention_change", "kinetic_energy_share", "sound_speed_floor"};
  const SchemaNode document = schema_document("case.schema.json");
  for_each_node(*document, "", [&](const Json& node, const std::string&) {
    if (!node.contains("properties")) return;
    for (const auto& [key, part] : node.at("properties").items()) {
      const Json type = part.value("type", Json());
      if (type != "number" && type != "integer") continue;
      // the gauges count in units of the event, and their keys say so
      const bool is_pure = pure.contains(key) || key.ends_with("_ratio") ||
                           key.ends_with("_mass_share") || key.ends_with("_factor");
      EXPECT_EQ(math::unit_of(key).suffix.empty(), is_pure) << key;
    }
  });
}

// A pattern is only searched in texts of a bounded length: the search recurses.
TEST(Schema, PatternsComeWithALengthLimit) {
  for (const char* name : documents) {
    for_each_node(*schema_document(name), "", [&](const Json& node, const std::string& pointer) {
      EXPECT_TRUE(!node.contains("pattern") || node.contains("maxLength")) << name << pointer;
    });
  }
  const Json sweep = {{"format", "parapet-sweep/1"},
                      {"name", "s"},
                      {"case", Json::object()},
                      {"rows", {{{"id", std::string(1000000, 'a')}}}}};
  const auto issues = schema_issues(schema_document("sweep.schema.json"), sweep, "");
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues[0].pointer, "/rows/0/id");
  EXPECT_LT(to_string(issues[0]).size(), 300U);  // the value is shortened
}

TEST(Schema, FindsPlacesThroughReferencesAndLists) {
  const SchemaNode document = schema_document("study.schema.json");
  const auto angle = schema_at(document, "/case/barriers/3/deflector/angle_deg");
  ASSERT_TRUE(angle);
  EXPECT_EQ((*angle)->at("maximum"), 90);
  EXPECT_EQ(allowed_by(*angle, "angle_deg"), "a number from -90 to 90 [deg]");
  EXPECT_FALSE(schema_at(document, "/case/barriers/3/colour"));
}

}  // namespace
}  // namespace parapet::designs
