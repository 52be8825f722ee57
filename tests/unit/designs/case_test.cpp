#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "parapet/designs/case_spec.hpp"
#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {
namespace {

CaseSpec case_with(const char* sections) {
  Json json = Json::parse(R"({"format": "parapet-case/1", "name": "test"})");
  json.update(Json::parse(sections));
  return parse_case(json, "test.json");
}

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

// What a task carries to another machine: the case there has the text, and so the hash, of the one
// here.
TEST(CaseApproach, SetOrReadIsTheSameCase) {
  CaseSpec spec = case_with(R"({"barriers": [{}, {"foot_x_m": 1.6}]})");
  solver::ApproachProfile profile;
  profile.x = {1.0, 1.5};  // not as far as the second barrier
  profile.places = {{1.9, 0.05}, {1.7, 0.04}};
  set_approach(spec, profile);
  const CaseSpec read = parse_case(spec.resolved, "test.json");
  EXPECT_EQ(read.resolved.dump(), spec.resolved.dump());
  EXPECT_EQ(read.run.approach, spec.run.approach);
  ASSERT_EQ(read.run.approach.size(), 2U);
  EXPECT_TRUE(read.run.approach[0].depth);
  EXPECT_FALSE(read.run.approach[1].depth);
  set_approach(spec, profile);
  EXPECT_EQ(read.resolved.dump(), spec.resolved.dump()) << "set again";
}

// The schema's defaults are the solver's own, to the bit: nothing may be changed in one place only.
TEST(CaseDefaults, AreTheSceneDefaults) {
  const solver::Scene scene = case_with("{}").scene, expected;
  EXPECT_EQ(scene.slope, expected.slope);
  EXPECT_EQ(scene.gravity, expected.gravity);
  EXPECT_EQ(scene.domain_length, expected.domain_length);
  EXPECT_EQ(scene.domain_height, expected.domain_height);
  EXPECT_EQ(scene.reservoir_length, expected.reservoir_length);
  EXPECT_EQ(scene.reservoir_height, expected.reservoir_height);
  EXPECT_EQ(scene.monitor_x, expected.monitor_x);
  EXPECT_EQ(scene.wall_slip, expected.wall_slip);
  EXPECT_EQ(scene.material.density, expected.material.density);
  EXPECT_EQ(scene.material.yield_stress, expected.material.yield_stress);
  EXPECT_EQ(scene.material.consistency, expected.material.consistency);
  EXPECT_EQ(scene.material.flow_index, expected.material.flow_index);
  EXPECT_EQ(scene.material.cutoff_shear_rate, expected.material.cutoff_shear_rate);
  EXPECT_EQ(scene.material.friction_angle, expected.material.friction_angle);
  EXPECT_EQ(scene.barriers.size(), expected.barriers.size());
  EXPECT_EQ(scene.solids.size(), expected.solids.size());
}

TEST(CaseDefaults, AreTheBarrierDefaults) {
  const CaseSpec spec = case_with(R"({"barriers": [{"deflector": {}}]})");
  const solver::Barrier& barrier = spec.scene.barriers.at(0);
  const solver::Barrier expected;
  EXPECT_EQ(barrier.foot_x, expected.foot_x);
  EXPECT_EQ(barrier.height, expected.height);
  EXPECT_EQ(barrier.thickness, expected.thickness);
  EXPECT_EQ(barrier.stem_lean, expected.stem_lean);
  ASSERT_TRUE(barrier.deflector);
  EXPECT_EQ(barrier.deflector->angle, solver::Deflector{}.angle);
  EXPECT_EQ(barrier.deflector->length, solver::Deflector{}.length);
  EXPECT_FALSE(case_with(R"({"barriers": [{}]})").scene.barriers[0].deflector);
}

TEST(CaseDefaults, AreTheNumericsDefaults) {
  const solver::Numerics numerics = case_with("{}").numerics, expected;
  EXPECT_EQ(numerics.spacing, expected.spacing);
  EXPECT_EQ(numerics.scheme, expected.scheme);
  EXPECT_EQ(numerics.background_pressure, expected.background_pressure);
  EXPECT_EQ(numerics.smoothing_ratio, expected.smoothing_ratio);
  EXPECT_EQ(numerics.sound_speed, solver::usual_sound_speed(solver::Scene{}));
  EXPECT_NEAR(numerics.sound_speed, expected.sound_speed, 0.01);
  EXPECT_EQ(numerics.sound_speed_floor, expected.sound_speed_floor);
  EXPECT_EQ(numerics.density_diffusion, expected.density_diffusion);
  EXPECT_EQ(numerics.shifting_factor, expected.shifting_factor);
  EXPECT_EQ(numerics.skin_ratio, expected.skin_ratio);
  EXPECT_EQ(numerics.cfl_acoustic, expected.cfl_acoustic);
  EXPECT_EQ(numerics.cfl_force, expected.cfl_force);
  EXPECT_EQ(numerics.cfl_viscous, expected.cfl_viscous);
  EXPECT_EQ(numerics.cg_tolerance, expected.cg_tolerance);
  EXPECT_EQ(numerics.steps_per_solve, expected.steps_per_solve);
  EXPECT_EQ(numerics.cg_max_iterations, expected.cg_max_iterations);
  EXPECT_EQ(numerics.hydrostatic_start, expected.hydrostatic_start);
  EXPECT_EQ(numerics.lattice_jitter, expected.lattice_jitter);
  EXPECT_EQ(numerics.lattice_seed, expected.lattice_seed);
  EXPECT_EQ(numerics.integrator, expected.integrator);
  EXPECT_EQ(numerics.thin_fluid, expected.thin_fluid);
}

TEST(CaseDefaults, AreTheRunDefaults) {
  const solver::RunOptions run = case_with("{}").run, expected;
  EXPECT_EQ(run.stop_time, expected.stop_time);
  EXPECT_EQ(run.series_interval, expected.series_interval);
  EXPECT_EQ(run.frame_interval, expected.frame_interval);
  EXPECT_EQ(run.threads, expected.threads);
  EXPECT_EQ(run.until_rest, expected.until_rest);
  EXPECT_EQ(run.settled.enabled, expected.settled.enabled);
  EXPECT_EQ(run.settled.window, expected.settled.window);
  EXPECT_EQ(run.settled.retention_change, expected.settled.retention_change);
  EXPECT_EQ(run.settled.kinetic_energy_share, expected.settled.kinetic_energy_share);
  EXPECT_EQ(run.settled.earliest_time, expected.settled.earliest_time);
}

// A copy of a channel at another scale, lengths x s and speeds x sqrt(s), has the sound speed x
// sqrt(s); it counts to the first barrier, else to the gauge, and a slope that rises adds nothing.
TEST(CaseDefaults, TheSoundSpeedFollowsFromTheCase) {
  const double flume = case_with("{}").numerics.sound_speed;
  EXPECT_NEAR(case_with(R"({"channel": {"length_m": 60, "height_m": 30, "monitor_x_m": 22},
                            "reservoir": {"length_m": 6, "height_m": 4},
                            "numerics": {"spacing_m": 0.1}})")
                  .numerics.sound_speed,
              std::sqrt(20.0) * flume, 1e-9);
  const auto with_foot = [](const char* foot) {
    return case_with((std::string(R"({"barriers": [{"foot_x_m": )") + foot + "}]}").c_str())
        .numerics;
  };
  EXPECT_EQ(with_foot("1.1").sound_speed, flume);
  EXPECT_GT(with_foot("1.5").sound_speed, flume);
  const double level = case_with(R"({"channel": {"slope_deg": 0}})").numerics.sound_speed;
  EXPECT_NEAR(level, 9.71 * std::sqrt(2.0 * 9.81 * 0.2), 1e-9);
}

// Every value that is given arrives in its field, in SI units.
TEST(CaseSpec, ValuesReachTheirFields) {
  const CaseSpec spec = case_with(R"({
    "description": "all of it",
    "channel": {"slope_deg": 30, "length_m": 4, "height_m": 2, "monitor_x_m": 1.2,
                "gravity_m_s2": 9.8, "wall": "free_slip"},
    "reservoir": {"length_m": 0.4, "height_m": 0.25},
    "material": {"density_kg_m3": 1500, "yield_stress_pa": 10, "consistency_pa_sn": 2,
                 "flow_index": 0.9, "cutoff_shear_rate_per_s": 0.2, "friction_angle_deg": 12},
    "numerics": {"spacing_m": 0.02, "smoothing_ratio": 1.5, "sound_speed_m_s": 50, "sound_speed_floor": 0.75,
                 "density_diffusion": 0.2, "shifting_factor": 0.5, "skin_ratio": 0.3,
                 "cfl_acoustic": 0.4, "cfl_force": 0.2, "cfl_viscous": 0.1,
                 "cg_tolerance_m_s2": 0.001, "steps_per_solve": 2, "cg_max_iterations": 7.0,
                 "hydrostatic_start": false, "lattice_jitter": 0.1, "lattice_seed": 9,
                 "integrator": "rk4_explicit", "scheme": "as_published",
                 "background_pressure_pa": 200, "thin_fluid": "auto"},
    "run": {"stop_time_s": 3, "series_interval_s": 0.01, "frame_interval_s": 0.05,
            "until_rest": true, "reading_time_s": 2.5,
            "settled": {"enabled": false, "window_s": 0.3, "retention_change": 0.01,
                        "kinetic_energy_share": 0.02, "earliest_time_s": 1}}})");
  EXPECT_EQ(spec.name, "test");
  EXPECT_EQ(spec.description, "all of it");
  EXPECT_DOUBLE_EQ(spec.scene.slope, radians(30));
  EXPECT_EQ(spec.scene.domain_length, 4.0);
  EXPECT_EQ(spec.scene.domain_height, 2.0);
  EXPECT_EQ(spec.scene.monitor_x, 1.2);
  EXPECT_EQ(spec.scene.gravity, 9.8);
  EXPECT_EQ(spec.scene.wall_slip, solver::WallSlip::free_slip);
  EXPECT_EQ(spec.scene.reservoir_length, 0.4);
  EXPECT_EQ(spec.scene.reservoir_height, 0.25);
  EXPECT_EQ(spec.scene.material.density, 1500.0);
  EXPECT_EQ(spec.scene.material.yield_stress, 10.0);
  EXPECT_EQ(spec.scene.material.consistency, 2.0);
  EXPECT_EQ(spec.scene.material.flow_index, 0.9);
  EXPECT_EQ(spec.scene.material.cutoff_shear_rate, 0.2);
  EXPECT_EQ(spec.numerics.spacing, 0.02);
  EXPECT_EQ(spec.numerics.smoothing_ratio, 1.5);
  EXPECT_EQ(spec.numerics.sound_speed, 50.0);
  EXPECT_EQ(spec.numerics.sound_speed_floor, 0.75);
  EXPECT_EQ(spec.numerics.density_diffusion, 0.2);
  EXPECT_EQ(spec.numerics.shifting_factor, 0.5);
  EXPECT_EQ(spec.numerics.skin_ratio, 0.3);
  EXPECT_EQ(spec.numerics.cfl_acoustic, 0.4);
  EXPECT_EQ(spec.numerics.cfl_force, 0.2);
  EXPECT_EQ(spec.numerics.cfl_viscous, 0.1);
  EXPECT_EQ(spec.numerics.cg_tolerance, 0.001);
  EXPECT_EQ(spec.numerics.steps_per_solve, 2);
  EXPECT_EQ(spec.numerics.cg_max_iterations, 7);
  EXPECT_FALSE(spec.numerics.hydrostatic_start);
  EXPECT_EQ(spec.numerics.lattice_jitter, 0.1);
  EXPECT_EQ(spec.numerics.lattice_seed, 9U);
  EXPECT_EQ(spec.numerics.integrator, solver::Integrator::rk4_explicit);
  EXPECT_EQ(spec.numerics.scheme, solver::Scheme::as_published);
  EXPECT_EQ(spec.numerics.background_pressure, 200.0);
  EXPECT_EQ(spec.numerics.thin_fluid, solver::ThinFluid::automatic);
  EXPECT_DOUBLE_EQ(spec.scene.material.friction_angle, radians(12));
  EXPECT_EQ(spec.run.stop_time, 3.0);
  EXPECT_EQ(spec.run.series_interval, 0.01);
  EXPECT_EQ(spec.run.frame_interval, 0.05);
  EXPECT_TRUE(spec.run.until_rest);
  EXPECT_EQ(spec.run.reading_time, 2.5);
  EXPECT_FALSE(spec.run.settled.enabled);
  EXPECT_EQ(spec.run.settled.window, 0.3);
  EXPECT_EQ(spec.run.settled.retention_change, 0.01);
  EXPECT_EQ(spec.run.settled.kinetic_energy_share, 0.02);
  EXPECT_EQ(spec.run.settled.earliest_time, 1.0);
}

// A later barrier's foot counts from the previous one's.
TEST(CaseSpec, SpacingCountsFromThePreviousFoot) {
  const CaseSpec spec = case_with(R"({"channel": {"length_m": 5},
      "barriers": [{"foot_x_m": 1.0}, {"spacing_m": 0.5}, {"foot_x_m": 2.5}, {"spacing_m": 0.75}]})");
  ASSERT_EQ(spec.scene.barriers.size(), 4U);
  EXPECT_DOUBLE_EQ(spec.scene.barriers[1].foot_x, 1.5);
  EXPECT_DOUBLE_EQ(spec.scene.barriers[2].foot_x, 2.5);
  EXPECT_DOUBLE_EQ(spec.scene.barriers[3].foot_x, 3.25);
}

// A stem normal to the bed leans back by the slope; any lean can be given instead.
TEST(CaseSpec, StemInclination) {
  const CaseSpec normal = case_with(R"({"barriers": [{"stem_inclination": "bed_normal"}]})");
  EXPECT_DOUBLE_EQ(normal.scene.barriers[0].stem_lean, -radians(26));
  const solver::Vec2 stem = solver::stem_direction(normal.scene, normal.scene.barriers[0]);
  EXPECT_NEAR(stem.x, 0.0, 1e-15);  // rounding of one sine
  EXPECT_NEAR(stem.z, 1.0, 1e-15);
  const CaseSpec leaning = case_with(R"({"barriers": [{"stem_lean_deg": -10}]})");
  EXPECT_DOUBLE_EQ(leaning.scene.barriers[0].stem_lean, -radians(10));
}

// The three zeros of the deflector's angle, seen as directions: upstream along the bed is (-1, 0)
// in channel axes; the stem's upstream normal is at a right angle to it.
TEST(CaseSpec, DeflectorDatum) {
  const CaseSpec bed = case_with(R"({"barriers": [{"deflector": {"datum": "bed"}}]})");
  solver::Vec2 plate = solver::deflector_direction(bed.scene, *bed.scene.barriers[0].deflector);
  EXPECT_NEAR(plate.x, -1.0, 1e-15);
  EXPECT_NEAR(plate.z, 0.0, 1e-15);

  const CaseSpec stem =
      case_with(R"({"barriers": [{"stem_lean_deg": -12, "deflector": {"datum": "stem"}}]})");
  plate = solver::deflector_direction(stem.scene, *stem.scene.barriers[0].deflector);
  const solver::Vec2 along = solver::stem_direction(stem.scene, stem.scene.barriers[0]);
  EXPECT_NEAR(solver::dot(plate, along), 0.0, 1e-15);
  EXPECT_LT(plate.x, 0.0);

  const CaseSpec horizontal =
      case_with(R"({"barriers": [{"stem_lean_deg": -12, "deflector": {"angle_deg": 30}}]})");
  EXPECT_DOUBLE_EQ(horizontal.scene.barriers[0].deflector->angle, radians(30));
}

// A positive angle lifts the tip, whatever it is measured from.
TEST(CaseSpec, PositiveAnglesLiftTheTip) {
  for (const char* datum : {"horizontal", "stem", "bed"}) {
    Json json = Json::parse(R"({"format": "parapet-case/1", "name": "t",
        "barriers": [{"deflector": {"angle_deg": 0}}]})");
    json["barriers"][0]["deflector"]["datum"] = datum;
    const double flat = parse_case(json, "t").scene.barriers[0].deflector->angle;
    json["barriers"][0]["deflector"]["angle_deg"] = 20;
    const double lifted = parse_case(json, "t").scene.barriers[0].deflector->angle;
    EXPECT_NEAR(lifted - flat, radians(20), 1e-15) << datum;
  }
}

// Bodies may be given either way round; the solver gets them counter-clockwise.
TEST(CaseSpec, SolidsAreTurnedCounterClockwise) {
  const char* either[] = {R"({"solids": [{"vertices_m": [[2, 0], [2.2, 0], [2.2, 0.1]]}]})",
                          R"({"solids": [{"vertices_m": [[2.2, 0.1], [2.2, 0], [2, 0]]}]})"};
  for (const char* json : either) {
    const auto vertices = case_with(json).scene.solids.at(0).vertices;
    ASSERT_EQ(vertices.size(), 3U);
    EXPECT_GT(solver::cross(vertices[1] - vertices[0], vertices[2] - vertices[0]), 0.0) << json;
  }
}

// Reading the resolved case again gives the same case to the bit, for awkward angles too: the
// document keeps the degrees as given.
TEST(CaseSpec, ResolvedReadsBackToTheBit) {
  for (double angle = -15.0; angle < 90.0; angle += 0.7) {
    Json json = Json::parse(R"({"format": "parapet-case/1", "name": "t",
        "channel": {"slope_deg": 25.3}, "solids": [{"vertices_m": [[2.5, 0], [2.7, 0], [2.7, 0.1]]}],
        "barriers": [{"stem_lean_deg": -3.1, "deflector": {"datum": "stem"}}, {"spacing_m": 0.7}]})");
    json["barriers"][0]["deflector"]["angle_deg"] = angle;
    const CaseSpec first = parse_case(json, "t");
    const CaseSpec again = parse_case(Json::parse(first.resolved.dump()), "t");
    EXPECT_EQ(first.resolved.dump(), again.resolved.dump());
    EXPECT_EQ(first.resolved["barriers"][0]["deflector"]["angle_deg"].get<double>(), angle);
    EXPECT_EQ(first.scene.slope, again.scene.slope);
    EXPECT_EQ(first.scene.barriers[0].stem_lean, again.scene.barriers[0].stem_lean);
    EXPECT_EQ(first.scene.barriers[0].deflector->angle, again.scene.barriers[0].deflector->angle);
    EXPECT_EQ(first.scene.barriers[1].foot_x, again.scene.barriers[1].foot_x);
    EXPECT_EQ(first.scene.solids[0].vertices, again.scene.solids[0].vertices);
  }
}

// Defaults that belong to the size of the event grow with it; what is given stays.
TEST(CaseSpec, DefaultsGrowWithTheEvent) {
  const char* barrier = R"(, "barriers": [{"deflector": {}}, {"spacing_m": 40, "thickness_m": 1}])";
  const CaseSpec flume = case_with(
      R"({"reservoir": {"length_m": 0.3, "height_m": 0.2}, "barriers": [{"deflector": {}}]})");
  EXPECT_EQ(flume.resolved.at("/gauges/event_length_m"_json_pointer), 0.2);
  EXPECT_EQ(flume.run.stop_time, 6.0) << "to the bit";
  EXPECT_EQ(flume.run.series_interval, 0.005);
  EXPECT_EQ(flume.scene.domain_length, 3.0);
  EXPECT_EQ(flume.scene.barriers[0].foot_x, 1.1);
  // 16 times as large, in a longer block
  const std::string sections =
      std::string(
          R"({"reservoir": {"length_m": 20, "height_m": 3.2}, "channel": {"length_m": 80})") +
      barrier + "}";
  const CaseSpec valley = case_with(sections.c_str());
  EXPECT_EQ(valley.run.gauges.event_length, 3.2);
  EXPECT_DOUBLE_EQ(valley.run.stop_time, 24.0);
  EXPECT_DOUBLE_EQ(valley.run.settled.window, 1.0);
  EXPECT_EQ(valley.scene.domain_length, 80.0);
  EXPECT_DOUBLE_EQ(valley.scene.domain_height, 24.0);
  EXPECT_DOUBLE_EQ(valley.scene.monitor_x, 20.0 + 12.8);
  EXPECT_DOUBLE_EQ(valley.scene.barriers[0].foot_x, 20.0 + 12.8);
  EXPECT_DOUBLE_EQ(valley.scene.barriers[0].thickness, 0.24);
  EXPECT_DOUBLE_EQ(valley.scene.barriers[0].deflector->length, 1.04);
  EXPECT_EQ(valley.scene.barriers[1].thickness, 1.0);
  EXPECT_DOUBLE_EQ(valley.numerics.spacing, 0.08);
  EXPECT_EQ(valley.numerics.cg_tolerance, 0.5) << "gravity is the same";
  // heavier by 4: half as long
  const CaseSpec fast = case_with(R"({"channel": {"gravity_m_s2": 39.24}})");
  EXPECT_DOUBLE_EQ(fast.run.stop_time, 3.0);
  EXPECT_DOUBLE_EQ(fast.numerics.cg_tolerance, 2.0);
  // the units of another event
  const CaseSpec base =
      case_with(R"({"reservoir": {"height_m": 0.1}, "gauges": {"event_length_m": 0.2}})");
  EXPECT_EQ(base.run.stop_time, 6.0);
  EXPECT_EQ(base.run.gauges.event_length, 0.2);
}

// Every section and default is written out.
TEST(CaseSpec, ResolvedHoldsEveryDefault) {
  const Json resolved =
      case_with(R"({"barriers": [{"deflector": {}}, {"spacing_m": 1}]})").resolved;
  EXPECT_EQ(resolved.at("/channel/slope_deg"_json_pointer), 26);
  EXPECT_EQ(resolved.at("/numerics/spacing_m"_json_pointer), 0.005);
  EXPECT_EQ(resolved.at("/run/settled/window_s"_json_pointer), 0.25);
  EXPECT_EQ(resolved.at("/barriers/0/foot_x_m"_json_pointer), 1.1);
  EXPECT_EQ(resolved.at("/barriers/0/deflector/datum"_json_pointer), "horizontal");
  EXPECT_FALSE(resolved.at("/barriers/1"_json_pointer).contains("foot_x_m"));
  EXPECT_TRUE(resolved.at("/barriers/1/deflector"_json_pointer).is_null());
}

// The value for "{}" is worked out by hand from the definition of FNV-1a (64 bits). The hash of a
// spec must never change: studies are resumed by it.
TEST(SpecHash, IsStable) {
  EXPECT_EQ(spec_hash(Json::object()), "08f44b07b5901a25");
  EXPECT_EQ(spec_hash(Json::parse(R"({"a":1})")), spec_hash(Json::parse(R"( { "a" : 1 } )")));
  EXPECT_NE(spec_hash(Json::parse(R"({"a":1})")), spec_hash(Json::parse(R"({"a":2})")));
  EXPECT_EQ(spec_hash(Json::object()).size(), 16U);
}

}  // namespace
}  // namespace parapet::designs
