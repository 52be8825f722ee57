/// A sound study of two barriers, to be changed by the tests.
#pragma once

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {

inline Json sound_study() {
  return Json::parse(R"({
    "format": "parapet-study/1", "name": "study",
    "case": {
      "barriers": [
        {"foot_x_m": 1.1, "height_m": 0.1, "deflector": {"angle_deg": 45, "length_m": 0.065}},
        {"spacing_m": 0.7, "height_m": 0.25}],
      "numerics": {"spacing_m": 0.01}},
    "variables": {
      "deflector_angle_deg": {"lower": 0, "upper": 75},
      "upstream_height_m": {"lower": 0.06, "upper": 0.16},
      "plate_m": {"lower": 0.03, "upper": 0.1, "target": "/barriers/0/deflector/length_m"}},
    "objectives": [
      {"metric": "retention_efficiency"},
      {"metric": "launch_length_m", "goal": "minimize", "weight": 0.5, "scale": 0.4,
       "value_when_absent": 0}],
    "constraints": [
      {"name": "material", "expression": "upstream_height_m + plate_m", "upper": 0.19},
      {"metric": "barrier_2_slam_force_n_per_m", "lower": 0, "upper": 400}],
    "method": {"algorithm": "COBYLA", "max_evaluations": 20, "start_count": 3,
      "starts": [{"deflector_angle_deg": 10, "upstream_height_m": 0.1, "plate_m": 0.05}]}})");
}

/// One, two or three barriers, the first bare or with a deflector.
inline Json choice_study() {
  return Json::parse(R"({
    "format": "parapet-study/1", "name": "choices",
    "case": {
      "channel": {"length_m": 3.5},
      "barriers": [
        {"foot_x_m": 1.1, "height_m": 0.1, "deflector": {"angle_deg": 45, "length_m": 0.065}},
        {"spacing_m": 0.7, "height_m": 0.2},
        {"spacing_m": 0.5, "height_m": 0.25}],
      "numerics": {"spacing_m": 0.01}},
    "variables": {
      "barriers": {"options": {
        "one": {"remove": ["/barriers/2", "/barriers/1"]},
        "two": {"remove": ["/barriers/2"]},
        "three": {}}},
      "deflector": {"options": {
        "none": {"remove": ["/barriers/0/deflector"]},
        "plate": {},
        "big": {"set": {"/barriers/0/deflector/length_m": 0.1}}}},
      "deflector_length_m": {"lower": 0.03, "upper": 0.09, "active_when": {"deflector": "plate"}},
      "deflector_angle_deg": {"lower": 0, "upper": 75, "type": "integer",
                              "active_when": {"deflector": ["plate", "big"]}},
      "downstream_height_m": {"lower": 0.1, "upper": 0.25,
                              "active_when": {"barriers": ["two", "three"]}},
      "upstream_height_m": {"lower": 0.08, "upper": 0.16}},
    "objectives": [
      {"metric": "retention_efficiency_total"},
      {"name": "plate_m", "expression": "upstream_height_m + downstream_height_m + deflector_length_m",
       "goal": "minimize"}],
    "method": {"starts": [
      {"barriers": "two", "deflector": "none", "downstream_height_m": 0.2,
       "upstream_height_m": 0.1}]}})");
}

}  // namespace parapet::designs
