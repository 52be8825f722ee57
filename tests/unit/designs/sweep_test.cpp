#include <gtest/gtest.h>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {
namespace {

Json sound_sweep() {
  return Json::parse(R"({
    "format": "parapet-sweep/1", "name": "sweep", "source": "a paper",
    "case": {"barriers": [{"height_m": 0.1, "deflector": {"angle_deg": 20}}],
             "numerics": {"spacing_m": 0.01}},
    "rows": [
      {"id": "base"},
      {"id": "steep", "description": "a steep channel", "changes": {"channel": {"slope_deg": 30}},
       "published": {"retention_efficiency": {"lower": 0.5, "source": "p. 3"}}},
      {"id": "bare", "changes": {"barriers": [{"height_m": 0.2}]}}]})");
}

// A row is the base with its changes; lists are replaced whole.
TEST(SweepSpec, RowsChangeTheBase) {
  const SweepSpec sweep = parse_sweep(sound_sweep(), "sweep.json");
  EXPECT_EQ(sweep.name, "sweep");
  EXPECT_EQ(sweep.source, "a paper");
  ASSERT_EQ(sweep.rows.size(), 3U);
  EXPECT_EQ(sweep.rows[0].spec.resolved["channel"]["slope_deg"], 26);
  EXPECT_TRUE(sweep.rows[0].published.is_null());
  EXPECT_EQ(sweep.rows[1].spec.resolved["channel"]["slope_deg"], 30);
  EXPECT_EQ(sweep.rows[1].spec.numerics.spacing, 0.01);
  EXPECT_EQ(sweep.rows[1].spec.description, "a steep channel");
  EXPECT_EQ(sweep.rows[1].published["retention_efficiency"]["lower"], 0.5);
  EXPECT_EQ(sweep.rows[2].spec.scene.barriers.at(0).height, 0.2);
  EXPECT_FALSE(sweep.rows[2].spec.scene.barriers.at(0).deflector);
}

TEST(SweepSpec, ResolvedReadsBackTheSame) {
  const SweepSpec sweep = parse_sweep(sound_sweep(), "sweep.json");
  const SweepSpec again = parse_sweep(Json::parse(sweep.resolved.dump()), "sweep.json");
  EXPECT_EQ(sweep.resolved.dump(), again.resolved.dump());
  for (std::size_t k = 0; k < sweep.rows.size(); ++k) {
    EXPECT_EQ(sweep.rows[k].spec.resolved.dump(), again.rows[k].spec.resolved.dump());
  }
}

}  // namespace
}  // namespace parapet::designs
