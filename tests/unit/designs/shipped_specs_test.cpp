#include <gtest/gtest.h>

#include <numbers>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {
namespace {

Json shipped(const std::string& name) {
  const char* text = embedded_spec(name);
  if (text == nullptr) throw std::runtime_error("not shipped: " + name);
  return parse_json(text, name);
}

// Whatever is shipped can be read, as what it says it is.
TEST(ShippedSpecs, AllParse) {
  EXPECT_EQ(embedded_spec_names().size(), 8U);
  for (const std::string& name : embedded_spec_names()) {
    const Json json = shipped(name);
    const std::string format = document_format(json, name);
    if (format == "parapet-case/1") {
      EXPECT_NO_THROW(parse_case(json, name)) << name;
    } else if (format == "parapet-study/1") {
      EXPECT_NO_THROW(parse_study(json, name)) << name;
    } else {
      EXPECT_NO_THROW(parse_sweep(json, name)) << name;
    }
    EXPECT_EQ(json.at("name"), name);
  }
  EXPECT_EQ(embedded_spec("no such spec"), nullptr);
  EXPECT_EQ(embedded_spec("case.schema"), nullptr);
  for (const char* kind : {"case", "study", "sweep"}) {
    ASSERT_NE(embedded_schema(kind), nullptr);
    EXPECT_NO_THROW(parse_json(embedded_schema(kind), kind));
  }
  EXPECT_EQ(embedded_schema("quickstart"), nullptr);
}

/// Expects a possible scene for a design in every event at every spacing.
void expect_scenes(const StudySpec& study, const Design& design) {
  std::vector<const Scenario*> events;
  for (const Scenario& scenario : study.scenarios) events.push_back(&scenario);
  if (events.empty()) events.push_back(nullptr);
  for (const FidelityLevel& level : study.fidelity) {
    for (const Scenario* event : events) {
      EXPECT_NO_THROW(design_case(study, design, event, level.spacing))
          << study.name << " " << Json(design).dump() << " in "
          << (event == nullptr ? "the case" : event->name) << " at " << level.spacing;
    }
  }
}

/// Whether the constraints that need no simulation allow a design.
bool is_allowed(const StudySpec& study, const Design& design) {
  for (const Constraint& constraint : study.constraints) {
    if (constraint.expression.empty()) continue;
    const double value = evaluate_expression(study, constraint.expression, design);
    if (constraint.lower && value < *constraint.lower) return false;
    if (constraint.upper && value > *constraint.upper) return false;
  }
  return true;
}

// Both ends and the middle of every variable, in all combinations that the study's own expressions
// allow, are possible scenes in every event at every spacing: no evaluation of a shipped study may
// be lost to a corner of its bounds.
TEST(ShippedSpecs, EveryAllowedCornerOfTheStudiesIsAScene) {
  int studies = 0;
  for (const std::string& name : embedded_spec_names()) {
    if (document_format(shipped(name), name) != "parapet-study/1") continue;
    ++studies;
    const StudySpec study = parse_study(shipped(name), name);
    std::size_t corners = 1, tried = 0;
    for (std::size_t i = 0; i < study.variables.size(); ++i) corners *= 3;
    for (std::size_t corner = 0; corner < corners; ++corner) {
      Design design;
      std::size_t digits = corner;
      for (const Variable& variable : study.variables) {
        const double share = 0.5 * static_cast<double>(digits % 3);
        digits /= 3;
        design[variable.name] = variable.lower + share * (variable.upper - variable.lower);
      }
      if (!is_allowed(study, design)) continue;
      ++tried;
      expect_scenes(study, design);
    }
    EXPECT_GT(tried, corners / 4) << name;  // the expressions leave something to search
  }
  EXPECT_EQ(studies, 6);
}

// A shipped study reads back the same from what it resolves to.
TEST(ShippedSpecs, ResolvedReadsBackTheSame) {
  for (const std::string& name : embedded_spec_names()) {
    if (document_format(shipped(name), name) != "parapet-study/1") continue;
    const StudySpec study = parse_study(shipped(name), name);
    EXPECT_EQ(parse_study(study.resolved, name).resolved.dump(), study.resolved.dump()) << name;
  }
}

struct Table3Row {
  const char* id;
  double angle_deg;   // negative: no deflector
  double upstream_m;  // 0: no barrier
  double spacing_m;   // 0: no downstream barrier
  double downstream_m;
};

// Table 3 of the source, column by column.
constexpr Table3Row table3[] = {{"H0-WD", -1, 0, 0, 0},
                                {"H10-WD1", -1, 0.25, 0, 0},
                                {"H10-WD2", -1, 0.1, 0, 0},
                                {"H10-D0", 0, 0.1, 0, 0},
                                {"H10-D30", 30, 0.1, 0, 0},
                                {"H10-D45", 45, 0.1, 0, 0},
                                {"H10-D60", 60, 0.1, 0, 0},
                                {"H10-D0-H25", 0, 0.1, 0.7, 0.25},
                                {"H10-D30-H25", 30, 0.1, 0.7, 0.25},
                                {"H10-D45-H25", 45, 0.1, 0.7, 0.25},
                                {"H10-D60-H25", 60, 0.1, 0.7, 0.25},
                                {"H10-WD1-H25", -1, 0.1, 0.7, 0.25},
                                {"H10-WD-H18", -1, 0.1, 0.7, 0.18},
                                {"H10-WD2-H25", -1, 0.1, 0.4, 0.25},
                                {"H18-WD-H25", -1, 0.18, 0.4, 0.25}};

TEST(ShippedSpecs, Table3IsTheTable) {
  const SweepSpec sweep = parse_sweep(shipped("table3"), "table3.json");
  ASSERT_EQ(sweep.rows.size(), std::size(table3));
  for (std::size_t k = 0; k < sweep.rows.size(); ++k) {
    const Table3Row& expected = table3[k];
    const SweepRow& row = sweep.rows[k];
    const auto& barriers = row.spec.scene.barriers;
    EXPECT_EQ(row.id, expected.id);
    EXPECT_EQ(row.spec.name, expected.id);
    EXPECT_EQ(row.spec.numerics.spacing, 0.005);
    EXPECT_EQ(row.spec.scene.domain_length, 3.0);
    const std::size_t n = expected.upstream_m == 0 ? 0 : expected.spacing_m == 0 ? 1 : 2;
    ASSERT_EQ(barriers.size(), n) << row.id;
    if (n == 0) continue;
    EXPECT_EQ(barriers[0].foot_x, 1.1);
    EXPECT_EQ(barriers[0].height, expected.upstream_m);
    EXPECT_EQ(barriers[0].stem_lean, 0.0);
    ASSERT_EQ(barriers[0].deflector.has_value(), expected.angle_deg >= 0) << row.id;
    if (barriers[0].deflector) {
      EXPECT_EQ(barriers[0].deflector->length, 0.065);
      EXPECT_DOUBLE_EQ(barriers[0].deflector->angle, expected.angle_deg * std::numbers::pi / 180);
    }
    if (n == 1) continue;
    EXPECT_DOUBLE_EQ(barriers[1].foot_x, 1.1 + expected.spacing_m);
    EXPECT_EQ(barriers[1].height, expected.downstream_m);
    EXPECT_FALSE(barriers[1].deflector) << row.id;
  }
}

// Every published figure names its place.
TEST(ShippedSpecs, Table3StatesItsSources) {
  int statements = 0;
  for (const SweepRow& row : parse_sweep(shipped("table3"), "table3.json").rows) {
    if (!row.published.is_object()) continue;
    for (const auto& [key, entry] : row.published.items()) {
      EXPECT_FALSE(entry.at("source").get<std::string>().empty()) << row.id << " " << key;
      ++statements;
    }
  }
  EXPECT_GE(statements, 25);
}

}  // namespace
}  // namespace parapet::designs
