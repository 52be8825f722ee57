#include <algorithm>
#include <cmath>
#include <cstdio>

#include "parapet/flow/geometry.hpp"
#include "parapet/solver/numerics.hpp"
#include "parapet/solver/scene.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::solver {
namespace {

// Collects sentences of one form: "<field> is <value> <unit>; allowed: <what>".
class Findings {
 public:
  void require(bool sound, const std::string& field, double value, const char* unit,
               const char* allowed) {
    if (sound && std::isfinite(value)) return;
    char number[32];
    std::snprintf(number, sizeof number, "%.9g", value);
    sentences_.push_back(field + " is " + number + (*unit ? " " : "") + unit +
                         "; allowed: " + allowed);
  }
  void add(std::string sentence) { sentences_.push_back(std::move(sentence)); }
  std::vector<std::string> take() { return std::move(sentences_); }

 private:
  std::vector<std::string> sentences_;
};

void check_material(Findings& f, const Material& m) {
  f.require(m.density > 0.0, "material density", m.density, "kg/m3", "more than 0");
  f.require(m.yield_stress >= 0.0, "yield stress", m.yield_stress, "Pa", "0 or more");
  f.require(m.consistency >= 0.0, "consistency", m.consistency, "Pa s^N", "0 or more");
  f.require(m.flow_index > 0.0, "flow index", m.flow_index, "", "more than 0");
  f.require(m.cutoff_shear_rate > 0.0, "cut-off shear rate", m.cutoff_shear_rate, "1/s",
            "more than 0");
  f.require(m.friction_angle >= 0.0 && m.friction_angle <= 1.2, "friction angle", m.friction_angle,
            "rad", "0 to 1.2");
}

void check_barrier(Findings& f, const Scene& scene, const Barrier& b, const std::string& name) {
  f.require(b.foot_x > scene.reservoir_length, name + " foot", b.foot_x, "m",
            "downstream of the reservoir");
  f.require(b.height > 0.0, name + " height", b.height, "m", "more than 0");
  f.require(b.thickness > 0.0, name + " thickness", b.thickness, "m", "more than 0");
  f.require(std::abs(scene.slope + b.stem_lean) < 1.2, name + " lean", b.stem_lean, "rad",
            "within 1.2 rad of the bed's normal");
  if (b.deflector) {
    f.require(b.deflector->length > 0.0, name + " deflector length", b.deflector->length, "m",
              "more than 0");
    // steeper than the stem it would fold over; lower than this it would fold into it
    const double against_stem = b.deflector->angle + b.stem_lean;
    f.require(against_stem >= -1.05 && against_stem <= 2.1, name + " deflector angle",
              b.deflector->angle, "rad", "-60 to 120 deg against the stem's normal");
  }
}

void check_outlines(Findings& f, const Scene& scene) {
  double clear_from = scene.reservoir_length;
  for (std::size_t k = 0; k < scene.barriers.size(); ++k) {
    const std::string name = "barrier " + std::to_string(k + 1);
    const auto outline = barrier_outline(scene, scene.barriers[k]);
    double lowest_tip = 1e9, left = 1e9, right = -1e9;
    for (std::size_t v = 0; v < outline.size(); ++v) {
      left = std::min(left, outline[v].x);
      right = std::max(right, outline[v].x);
      if (v != 0 && v + 1 != outline.size()) lowest_tip = std::min(lowest_tip, outline[v].z);
    }
    f.require(lowest_tip > 0.0, name + " lowest corner above the bed", lowest_tip, "m",
              "more than 0");
    f.require(left > clear_from, name + " reaches upstream to x", left, "m",
              "downstream of the reservoir and of the barrier before");
    f.require(right < scene.domain_length, name + " reaches downstream to x", right, "m",
              "inside the domain");
    clear_from = right;
  }
}

}  // namespace

std::vector<std::string> scene_errors(const Scene& scene) {
  Findings f;
  check_material(f, scene.material);
  f.require(std::abs(scene.slope) < 1.2, "slope", scene.slope, "rad", "less than 1.2 either way");
  f.require(scene.gravity > 0.0, "gravity", scene.gravity, "m/s2", "more than 0");
  f.require(scene.reservoir_length > 0.0, "reservoir length", scene.reservoir_length, "m",
            "more than 0");
  f.require(scene.reservoir_height > 0.0, "reservoir height", scene.reservoir_height, "m",
            "more than 0");
  f.require(scene.domain_length > scene.reservoir_length, "domain length", scene.domain_length, "m",
            "longer than the reservoir");
  f.require(scene.domain_height > scene.reservoir_height, "domain height", scene.domain_height, "m",
            "higher than the reservoir");
  for (std::size_t k = 0; k < scene.barriers.size(); ++k) {
    check_barrier(f, scene, scene.barriers[k], "barrier " + std::to_string(k + 1));
  }
  for (const SolidPolygon& solid : scene.solids) {
    double area = 0.0;
    for (std::size_t v = 0; v < solid.vertices.size(); ++v) {
      area += 0.5 * cross(solid.vertices[v], solid.vertices[(v + 1) % solid.vertices.size()]);
    }
    f.require(solid.vertices.size() >= 3 && area > 0.0, "a solid's signed area", area, "m2",
              "at least three vertices in counter-clockwise order");
  }
  auto sentences = f.take();
  if (!sentences.empty()) return sentences;
  Findings outlines;  // only meaningful once every number is sound
  check_outlines(outlines, scene);
  return outlines.take();
}

std::vector<std::string> numerics_errors(const Numerics& n) {
  Findings f;
  f.require(n.spacing > 0.0, "particle spacing", n.spacing, "m", "more than 0");
  f.require(n.smoothing_ratio >= 1.1 && n.smoothing_ratio <= 3.0, "smoothing ratio",
            n.smoothing_ratio, "", "1.1 to 3");
  f.require(n.sound_speed > 0.0, "sound speed", n.sound_speed, "m/s", "more than 0");
  f.require(n.sound_speed_floor > 0.0 && n.sound_speed_floor <= 1.0, "sound speed floor",
            n.sound_speed_floor, "", "more than 0 to 1");
  f.require(n.density_diffusion >= 0.0 && n.density_diffusion <= 0.3, "density diffusion",
            n.density_diffusion, "", "0 to 0.3");
  f.require(n.shifting_factor >= 0.0 && n.shifting_factor <= 2.0, "shifting factor",
            n.shifting_factor, "", "0 to 2");
  f.require(n.skin_ratio >= 0.02 && n.skin_ratio <= 1.0, "skin ratio", n.skin_ratio, "",
            "0.02 to 1");
  f.require(n.cfl_acoustic >= 0.0 && n.cfl_acoustic <= 1.5, "acoustic CFL number", n.cfl_acoustic,
            "", "0 (the integrator's own) to 1.5");
  f.require(n.cfl_force > 0.0 && n.cfl_force <= 1.0, "force CFL number", n.cfl_force, "",
            "more than 0 to 1");
  f.require(n.cfl_viscous > 0.0 && n.cfl_viscous <= 0.5, "viscous CFL number", n.cfl_viscous, "",
            "more than 0 to 0.5");
  f.require(n.cg_tolerance > 0.0, "viscous solve tolerance", n.cg_tolerance, "m/s2", "more than 0");
  f.require(n.steps_per_solve >= 1 && n.steps_per_solve <= 10, "steps per viscous solve",
            n.steps_per_solve, "", "1 to 10");
  f.require(n.cg_max_iterations >= 1, "viscous solve iterations", n.cg_max_iterations, "",
            "1 or more");
  f.require(n.lattice_jitter >= 0.0 && n.lattice_jitter <= 0.4, "lattice jitter", n.lattice_jitter,
            "of dx", "0 to 0.4");
  f.require(n.background_pressure >= 0.0, "background pressure", n.background_pressure, "Pa",
            "0 or more");
  f.require(n.background_pressure == 0.0 || n.scheme == Scheme::as_published, "background pressure",
            n.background_pressure, "Pa", "0 in the corrected scheme; as_published has it");
  return f.take();
}

std::vector<std::string> run_errors(const RunOptions& o) {
  Findings f;
  f.require(o.stop_time > 0.0, "stop time", o.stop_time, "s", "more than 0");
  f.require(o.series_interval > 0.0, "series interval", o.series_interval, "s", "more than 0");
  f.require(o.frame_interval >= 0.0, "frame interval", o.frame_interval, "s", "0 (none) or more");
  f.require(o.reading_time >= 0.0 && o.reading_time <= o.stop_time, "reading time", o.reading_time,
            "s", "0 (never) to the stop time");
  for (std::size_t k = 0; k < o.frame_times.size(); ++k) {
    const double least = k == 0 ? 0.0 : o.frame_times[k - 1];
    f.require(o.frame_times[k] >= least, "time of a frame", o.frame_times[k], "s",
              "0 or more, each after the one before");
  }
  for (const Approach& flow : o.approach) {
    const auto sound = [](const std::optional<double>& value) { return !value || *value > 0.0; };
    f.require(sound(flow.front_velocity), "velocity of the undisturbed front",
              flow.front_velocity.value_or(0.0), "m/s", "more than 0");
    f.require(sound(flow.depth), "depth of the undisturbed flow", flow.depth.value_or(0.0), "m",
              "more than 0");
  }
  f.require(o.threads >= 1, "threads", o.threads, "", "1 or more");
  f.require(o.settled.window > 0.0, "settled window", o.settled.window, "s", "more than 0");
  f.require(o.settled.retention_change > 0.0, "settled retention change",
            o.settled.retention_change, "", "more than 0");
  f.require(o.settled.kinetic_energy_share > 0.0, "settled kinetic energy share",
            o.settled.kinetic_energy_share, "", "more than 0");
  return f.take();
}

}  // namespace parapet::solver
