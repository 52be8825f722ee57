#include "tiny_specs.hpp"

namespace parapet::test {

using designs::Json;

Json tiny_case() {
  return Json::parse(R"({
    "format": "parapet-case/1",
    "name": "tiny",
    "channel": {"length_m": 1.2},
    "reservoir": {"length_m": 0.2, "height_m": 0.1},
    "barriers": [{"foot_x_m": 0.4, "height_m": 0.06,
                  "deflector": {"angle_deg": 30, "length_m": 0.04}}],
    "numerics": {"spacing_m": 0.02},
    "run": {"stop_time_s": 0.5}
  })");
}

void make_unsolvable(Json& case_json) {
  case_json["numerics"]["cg_max_iterations"] = 1;
  case_json["numerics"]["cg_tolerance_m_s2"] = 1e-8;
}

Json tiny_study() {
  Json study = Json::parse(R"({
    "format": "parapet-study/1",
    "name": "tiny",
    "variables": {
      "deflector_angle_deg": {"lower": 0, "upper": 60},
      "upstream_height_m": {"lower": 0.04, "upper": 0.1}
    },
    "objectives": [{"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize", "scale": 100}],
    "constraints": [
      {"name": "stem", "expression": "upstream_height_m + deflector_angle_deg / 1000", "upper": 0.13},
      {"metric": "retention_efficiency", "lower": 0.2}
    ],
    "method": {
      "algorithm": "COBYLA", "max_evaluations": 16, "start_count": 3, "relative_tolerance": 0.01,
      "starts": [{"deflector_angle_deg": 30, "upstream_height_m": 0.06}]
    }
  })");
  study["case"] = tiny_case();
  study["case"].erase("format");
  return study;
}

Json tiny_search() {
  Json study = tiny_study();
  study["objectives"] = Json::parse(R"([
    {"metric": "barrier_1_slam_force_n_per_m", "goal": "minimize", "statistic": "worst"},
    {"name": "plate_m", "expression": "upstream_height_m + 0.04", "goal": "minimize"}])");
  study["scenarios"] = Json::parse(R"([
    {"name": "runny", "weight": 0.25, "set": {"yield_stress_pa": 40}},
    {"name": "usual", "weight": 0.5, "set": {"yield_stress_pa": 90}},
    {"name": "stiff", "weight": 0.25, "set": {"yield_stress_pa": 150}}])");
  study["method"] = Json::parse(R"({"algorithm": "BAYESIAN", "max_evaluations": 12, "seed": 1,
    "starts": [{"deflector_angle_deg": 30, "upstream_height_m": 0.06}]})");
  return study;
}

Json tiny_sweep() {
  Json sweep = Json::parse(R"({
    "format": "parapet-sweep/1",
    "name": "tiny",
    "source": "nobody",
    "rows": [
      {"id": "bare", "changes": {"barriers": [{"foot_x_m": 0.4, "height_m": 0.06}]}},
      {"id": "lifted"},
      {"id": "flat", "changes": {"barriers": [
        {"foot_x_m": 0.4, "height_m": 0.06, "deflector": {"angle_deg": 0, "length_m": 0.04}}]}}
    ]
  })");
  sweep["case"] = tiny_case();
  sweep["case"].erase("format");
  return sweep;
}

}  // namespace parapet::test
