#include <algorithm>
#include <numbers>
#include <optional>

#include "case_parts.hpp"
#include "polygon.hpp"

namespace parapet::designs {
namespace {

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

double number(const Json& object, const char* key) {
  return object.at(key).get<double>();
}

/// A whole number may be written 30.0.
template <typename Integer>
Integer whole(const Json& object, const char* key) {
  return static_cast<Integer>(number(object, key));
}

/// The solver measures the angle from the world's horizontal.
double angle_from_horizontal(const Json& deflector, double slope, double stem_lean) {
  const double angle = radians(number(deflector, "angle_deg"));
  const std::string datum = deflector.at("datum").get<std::string>();
  if (datum == "stem") return angle - stem_lean;  // a lean upstream tilts the normal down
  if (datum == "bed") return angle + slope;       // upstream along the bed climbs by the slope
  return angle;
}

solver::Barrier read_barrier(const Json& json, double slope, double previous_foot) {
  solver::Barrier barrier;
  barrier.foot_x = json.contains("foot_x_m") ? number(json, "foot_x_m")
                                             : previous_foot + number(json, "spacing_m");
  barrier.height = number(json, "height_m");
  barrier.thickness = number(json, "thickness_m");
  if (json.contains("stem_lean_deg")) {
    barrier.stem_lean = radians(number(json, "stem_lean_deg"));
  } else {
    barrier.stem_lean = json.at("stem_inclination") == "bed_normal" ? -slope : 0.0;
  }
  const Json& deflector = json.at("deflector");
  if (!deflector.is_null()) {
    barrier.deflector = solver::Deflector{
        angle_from_horizontal(deflector, slope, barrier.stem_lean), number(deflector, "length_m")};
  }
  return barrier;
}

solver::SolidPolygon read_solid(const Json& json) {
  solver::SolidPolygon solid;
  for (const Json& corner : json.at("vertices_m")) {
    solid.vertices.push_back({corner[0].get<double>(), corner[1].get<double>()});
  }
  if (signed_area(solid.vertices) < 0.0) std::reverse(solid.vertices.begin(), solid.vertices.end());
  return solid;
}

}  // namespace

solver::Scene read_scene(const Json& resolved) {
  solver::Scene scene;
  const Json& channel = resolved.at("channel");
  scene.slope = radians(number(channel, "slope_deg"));
  scene.gravity = number(channel, "gravity_m_s2");
  scene.domain_length = number(channel, "length_m");
  scene.domain_height = number(channel, "height_m");
  scene.monitor_x = number(channel, "monitor_x_m");
  scene.wall_slip =
      channel.at("wall") == "free_slip" ? solver::WallSlip::free_slip : solver::WallSlip::no_slip;
  scene.reservoir_length = number(resolved.at("reservoir"), "length_m");
  scene.reservoir_height = number(resolved.at("reservoir"), "height_m");
  const Json& material = resolved.at("material");
  scene.material.density = number(material, "density_kg_m3");
  scene.material.yield_stress = number(material, "yield_stress_pa");
  scene.material.consistency = number(material, "consistency_pa_sn");
  scene.material.flow_index = number(material, "flow_index");
  scene.material.cutoff_shear_rate = number(material, "cutoff_shear_rate_per_s");
  scene.material.friction_angle = radians(number(material, "friction_angle_deg"));
  double previous_foot = 0.0;
  for (const Json& barrier : resolved.at("barriers")) {
    scene.barriers.push_back(read_barrier(barrier, scene.slope, previous_foot));
    previous_foot = scene.barriers.back().foot_x;
  }
  for (const Json& solid : resolved.at("solids")) scene.solids.push_back(read_solid(solid));
  return scene;
}

solver::Numerics read_numerics(const Json& resolved, const solver::Scene& scene) {
  const Json& json = resolved.at("numerics");
  solver::Numerics numerics;
  numerics.spacing = number(json, "spacing_m");
  numerics.smoothing_ratio = number(json, "smoothing_ratio");
  numerics.sound_speed = number(json, "sound_speed_m_s");
  if (numerics.sound_speed == 0.0) numerics.sound_speed = solver::usual_sound_speed(scene);
  numerics.sound_speed_floor = number(json, "sound_speed_floor");
  numerics.density_diffusion = number(json, "density_diffusion");
  numerics.shifting_factor = number(json, "shifting_factor");
  numerics.skin_ratio = number(json, "skin_ratio");
  numerics.cfl_acoustic = number(json, "cfl_acoustic");
  numerics.cfl_force = number(json, "cfl_force");
  numerics.cfl_viscous = number(json, "cfl_viscous");
  numerics.cg_tolerance = number(json, "cg_tolerance_m_s2");
  numerics.steps_per_solve = whole<int>(json, "steps_per_solve");
  numerics.cg_max_iterations = whole<int>(json, "cg_max_iterations");
  numerics.hydrostatic_start = json.at("hydrostatic_start").get<bool>();
  numerics.lattice_jitter = number(json, "lattice_jitter");
  numerics.lattice_seed = whole<unsigned>(json, "lattice_seed");
  numerics.integrator = json.at("integrator") == "rk4_explicit"
                            ? solver::Integrator::rk4_explicit
                            : solver::Integrator::implicit_viscosity;
  numerics.scheme = json.at("scheme") == "as_published" ? solver::Scheme::as_published
                                                        : solver::Scheme::corrected;
  numerics.background_pressure = number(json, "background_pressure_pa");
  numerics.thin_fluid = json.value("thin_fluid", "off") == "off" ? solver::ThinFluid::off
                                                                 : solver::ThinFluid::automatic;
  return numerics;
}

namespace {

solver::GaugeSettings read_gauges(const Json& json) {
  solver::GaugeSettings gauges;
  gauges.event_length = number(json, "event_length_m");
  gauges.front_mass_share = number(json, "front_mass_share");
  gauges.front_base_ratio = number(json, "front_base_ratio");
  gauges.front_clearance_ratio = number(json, "front_clearance_ratio");
  gauges.depth_window_ratio = number(json, "depth_window_ratio");
  gauges.energy_window_ratio = number(json, "energy_window_ratio");
  gauges.first_peak_time_ratio = number(json, "first_peak_time_ratio");
  gauges.arrival_mass_share = number(json, "arrival_mass_share");
  gauges.arrival_window_ratio = number(json, "arrival_window_ratio");
  gauges.run_up_mass_share = number(json, "run_up_mass_share");
  gauges.run_up_window_ratio = number(json, "run_up_window_ratio");
  gauges.impact_mass_share = number(json, "impact_mass_share");
  gauges.launch_mass_share = number(json, "launch_mass_share");
  gauges.landing_height_ratio = number(json, "landing_height_ratio");
  gauges.approach_height_ratio = number(json, "approach_height_ratio");
  gauges.discharge_time_ratio = number(json, "discharge_time_ratio");
  gauges.rest_speed_ratio = number(json, "rest_speed_ratio");
  gauges.dead_zone_window_ratio = number(json, "dead_zone_window_ratio");
  gauges.dead_zone_depth_factor = number(json, "dead_zone_depth_factor");
  gauges.dead_zone_least_depth_ratio = number(json, "dead_zone_least_depth_ratio");
  gauges.dead_zone_most_depth_ratio = number(json, "dead_zone_most_depth_ratio");
  gauges.design_load_time_ratio = number(json, "design_load_time_ratio");
  gauges.short_load_time_ratio = number(json, "short_load_time_ratio");
  gauges.slam_time_ratio = number(json, "slam_time_ratio");
  gauges.impulse_time_ratio = number(json, "impulse_time_ratio");
  gauges.ramp_near_ratio = number(json, "ramp_near_ratio");
  gauges.ramp_far_ratio = number(json, "ramp_far_ratio");
  gauges.ramp_column_ratio = number(json, "ramp_column_ratio");
  return gauges;
}

}  // namespace

namespace {

std::optional<double> number_or_none(const Json& object, const char* key) {
  return object.at(key).is_null() ? std::nullopt : std::optional(number(object, key));
}

}  // namespace

Json approach_json(const solver::Approach& flow) {
  const auto json = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  return {{"front_velocity_m_s", json(flow.front_velocity)},
          {"flow_depth_max_m", json(flow.depth)}};
}

solver::Approach approach_from_json(const Json& json) {
  return {number_or_none(json, "front_velocity_m_s"), number_or_none(json, "flow_depth_max_m")};
}

void set_approach(CaseSpec& spec, const solver::ApproachProfile& profile) {
  spec.run.approach.clear();
  Json flows = Json::array();
  for (const solver::Barrier& barrier : spec.scene.barriers) {
    spec.run.approach.push_back(profile.at(barrier.foot_x));
    flows.push_back(approach_json(spec.run.approach.back()));
  }
  // where a case that is read has it: the order of the keys is part of its hash
  Json resolved = Json::object();
  for (const auto& [key, value] : spec.resolved.items()) {
    if (key == "approach") continue;
    if (key == "gauges") resolved["approach"] = flows;
    resolved[key] = value;
  }
  spec.resolved = std::move(resolved);
}

solver::RunOptions read_run(const Json& resolved) {
  const Json& json = resolved.at("run");
  solver::RunOptions run;
  run.stop_time = number(json, "stop_time_s");
  run.series_interval = number(json, "series_interval_s");
  run.frame_interval = number(json, "frame_interval_s");
  run.reading_time = number(json, "reading_time_s");
  run.until_rest = json.at("until_rest").get<bool>();
  const Json& settled = json.at("settled");
  run.settled.enabled = settled.at("enabled").get<bool>();
  run.settled.window = number(settled, "window_s");
  run.settled.retention_change = number(settled, "retention_change");
  run.settled.kinetic_energy_share = number(settled, "kinetic_energy_share");
  run.settled.earliest_time = number(settled, "earliest_time_s");
  run.gauges = read_gauges(resolved.at("gauges"));
  if (resolved.contains("approach")) {
    for (const Json& flow : resolved.at("approach")) {
      run.approach.push_back(approach_from_json(flow));
    }
  }
  return run;
}

}  // namespace parapet::designs
