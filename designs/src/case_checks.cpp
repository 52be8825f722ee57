#include <algorithm>
#include <cmath>
#include <numbers>

#include "case_parts.hpp"
#include "polygon.hpp"

namespace parapet::designs {
namespace {

using solver::Vec2;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
constexpr double fewest_particles_across = 4.0;  // of the block: fewer is no flow
constexpr double most_particles = 5e6;           // beyond it a run is a mistake, not a plan
constexpr double lowest_speed_ratio = 5.0;       // sound over free fall: density within 4 %
constexpr double smallest_opening_deg = 30.0;    // between stem and deflector
constexpr double largest_lean_deg = 68.0;        // of a stem from the bed's normal

Polygon reservoir(const solver::Scene& scene) {
  const double length = scene.reservoir_length, height = scene.reservoir_height;
  return {{0.0, 0.0}, {length, 0.0}, {length, height}, {0.0, height}};
}

std::string barrier_pointer(std::size_t k) {
  return child_pointer("/barriers", k);
}

/// The key that places a barrier along the bed.
std::string place_pointer(const CaseSpec& spec, std::size_t k) {
  const bool by_foot = spec.resolved.at("barriers")[k].contains("foot_x_m");
  return barrier_pointer(k) + (by_foot ? "/foot_x_m" : "/spacing_m");
}

void check_reservoir(const solver::Scene& scene, Findings& findings) {
  if (scene.reservoir_length >= scene.domain_length) {
    findings.add("/reservoir/length_m", "the block is not shorter than the channel",
                 "less than /channel/length_m, " + rounded(scene.domain_length) + " [m]");
  }
  if (scene.reservoir_height >= scene.domain_height) {
    findings.add("/reservoir/height_m", "the block is not lower than the channel",
                 "less than /channel/height_m, " + rounded(scene.domain_height) + " [m]");
  }
  if (scene.barriers.empty() && scene.monitor_x > scene.domain_length) {
    findings.add("/channel/monitor_x_m", "the gauge stands beyond the channel's end",
                 "at most /channel/length_m, " + rounded(scene.domain_length) + " [m]");
  }
}

void check_resolution(const CaseSpec& spec, Findings& findings) {
  const solver::Scene& scene = spec.scene;
  const double spacing = spec.numerics.spacing;
  const double across = std::min(scene.reservoir_length, scene.reservoir_height);
  if (spacing > across / fewest_particles_across * (1.0 + 1e-9)) {
    findings.add("/numerics/spacing_m",
                 "is too coarse: the reservoir is only " + rounded(across) + " m across",
                 "at most " + rounded(across / fewest_particles_across) +
                     " [m], so that four particles fit into it");
    return;
  }
  const double area = scene.reservoir_length * scene.reservoir_height;
  const double particles = area / (spacing * spacing);
  if (particles > most_particles) {
    findings.add("/numerics/spacing_m",
                 "is too fine: the reservoir would hold " + rounded(particles) + " particles",
                 "at least " + rounded(std::sqrt(area / most_particles)) + " [m]");
  }
  for (std::size_t k = 0; k < scene.barriers.size(); ++k) {
    const solver::Barrier& barrier = scene.barriers[k];
    if (barrier.height < 2.0 * spacing) {
      findings.add(barrier_pointer(k) + "/height_m", "is too low to be resolved",
                   "at least two particle spacings, " + rounded(2.0 * spacing) + " [m]");
    }
    if (barrier.deflector && barrier.deflector->length < spacing) {
      findings.add(barrier_pointer(k) + "/deflector/length_m", "is too short to be resolved",
                   "at least one particle spacing, " + rounded(spacing) + " [m], or no deflector");
    }
  }
}

void check_sound_speed(const CaseSpec& spec, Findings& findings) {
  const double drop = solver::drop_to_gauge(spec.scene);
  const double fall_speed = std::sqrt(2.0 * spec.scene.gravity * drop);
  if (spec.numerics.sound_speed >= lowest_speed_ratio * fall_speed) return;
  findings.add(
      "/numerics/sound_speed_m_s",
      "is too low: falling " + rounded(drop) + " m to the gauge, debris may reach " +
          rounded(fall_speed) + " m/s",
      "at least five times that speed, " + rounded(lowest_speed_ratio * fall_speed) + " [m/s]");
}

void check_run(const solver::RunOptions& run, Findings& findings) {
  if (run.series_interval > run.stop_time) {
    findings.add("/run/series_interval_s", "is longer than the run",
                 "at most /run/stop_time_s, " + rounded(run.stop_time) + " [s]");
  }
  if (run.reading_time > run.stop_time) {
    findings.add("/run/reading_time_s", "is after the end of the run",
                 "at most /run/stop_time_s, " + rounded(run.stop_time) + " [s]");
  }
  if (run.settled.enabled && run.settled.window < run.series_interval) {
    findings.add("/run/settled/window_s", "is shorter than the interval of the time series",
                 "at least /run/series_interval_s, " + rounded(run.series_interval) + " [s]");
  }
}

void check_approach(const CaseSpec& spec, Findings& findings) {
  const std::size_t given = spec.run.approach.size(), barriers = spec.scene.barriers.size();
  if (given == 0 || given == barriers) return;
  findings.add("/approach", "has " + std::to_string(given) + " places",
               "one for each of the " + std::to_string(barriers) + " barriers, or no such key");
}

/// False when the stem lies on the bed rather than standing on it.
bool check_stem(const CaseSpec& spec, std::size_t k, Findings& findings) {
  const double lean = (spec.scene.slope + spec.scene.barriers[k].stem_lean) * degrees_per_radian;
  if (std::abs(lean) <= largest_lean_deg) return true;
  findings.add(barrier_pointer(k) + "/stem_lean_deg",
               "the stem leans " + rounded(lean) + " deg from the normal of the bed",
               "a stem within " + rounded(largest_lean_deg) + " deg of the bed's normal");
  return false;
}

/// Deflector against its own stem and the bed. False when it is impossible.
bool check_deflector(const CaseSpec& spec, std::size_t k, Findings& findings) {
  const solver::Barrier& barrier = spec.scene.barriers[k];
  if (!barrier.deflector) return true;
  const std::string angle_pointer = barrier_pointer(k) + "/deflector/angle_deg";
  const double from_normal = (barrier.deflector->angle + barrier.stem_lean) * degrees_per_radian;
  if (from_normal > 90.0 + 1e-9 || from_normal < smallest_opening_deg - 90.0 - 1e-9) {
    findings.add(angle_pointer,
                 from_normal > 0.0 ? "the deflector points downstream of its stem"
                                   : "the deflector folds onto its stem",
                 "from -60 to 90 [deg] above the upstream normal of the stem (here " +
                     rounded(from_normal) + ")");
    return false;
  }
  const Vec2 crest =
      Vec2{barrier.foot_x, 0.0} + barrier.height * solver::stem_direction(spec.scene, barrier);
  const Vec2 tip = crest + barrier.deflector->length *
                               solver::deflector_direction(spec.scene, *barrier.deflector);
  if (tip.z < spec.numerics.spacing) {
    findings.add(angle_pointer,
                 "the deflector's tip is too close to the bed: " + rounded(tip.z) + " m above it",
                 "an angle, length and stem height that keep the tip at least one particle "
                 "spacing, " +
                     rounded(spec.numerics.spacing) + " m, above the bed");
    return false;
  }
  return true;
}

/// Where a barrier reaches: along the bed and above it [m].
struct Reach {
  double upstream, downstream, top;
};

Reach reach(const Polygon& outline) {
  Reach result{outline[0].x, outline[0].x, outline[0].z};
  for (const Vec2 corner : outline) {
    result.upstream = std::min(result.upstream, corner.x);
    result.downstream = std::max(result.downstream, corner.x);
    result.top = std::max(result.top, corner.z);
  }
  return result;
}

/// One barrier clear of what stands upstream of it and inside the channel. `clear_from` is the x
/// where that ends. False when it is misplaced.
bool check_place(const CaseSpec& spec, std::size_t k, const Reach& barrier, double clear_from,
                 Findings& findings) {
  const solver::Scene& scene = spec.scene;
  const double foot = scene.barriers[k].foot_x;
  if (barrier.upstream <= clear_from) {
    const std::string other =
        k == 0 ? "the reservoir" : "barrier " + std::to_string(k) + " upstream of it";
    findings.add(place_pointer(spec, k),
                 "the barrier overlaps " + other +
                     ": it reaches upstream to x = " + rounded(barrier.upstream) + " m",
                 "a foot beyond x = " + rounded(clear_from + foot - barrier.upstream) + " m");
    return false;
  }
  if (barrier.downstream >= scene.domain_length) {
    findings.add(place_pointer(spec, k),
                 "the barrier stands beyond the channel's end: it reaches to x = " +
                     rounded(barrier.downstream) + " m",
                 "a foot before x = " + rounded(scene.domain_length + foot - barrier.downstream) +
                     " m, or a longer channel (/channel/length_m)");
    return false;
  }
  if (barrier.top >= scene.domain_height) {
    findings.add(barrier_pointer(k) + "/height_m",
                 "the barrier reaches " + rounded(barrier.top) + " m above the bed",
                 "below /channel/height_m, " + rounded(scene.domain_height) + " [m]");
    return false;
  }
  return true;
}

void check_barriers(const CaseSpec& spec, Findings& findings) {
  double clear_from = spec.scene.reservoir_length;
  for (std::size_t k = 0; k < spec.scene.barriers.size(); ++k) {
    if (!check_stem(spec, k, findings) || !check_deflector(spec, k, findings)) return;
    const Reach barrier = reach(solver::barrier_outline(spec.scene, spec.scene.barriers[k]));
    if (!check_place(spec, k, barrier, clear_from, findings)) return;
    clear_from = barrier.downstream;
  }
}

void check_solids(const solver::Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.solids.size(); ++i) {
    const Polygon& outline = scene.solids[i].vertices;
    const std::string pointer = child_pointer("/solids", i) + "/vertices_m";
    if (!is_simple(outline)) {
      findings.add(pointer, "its sides cross each other", "corners in order around the body");
    } else if (signed_area(outline) < 1e-12) {
      findings.add(pointer, "encloses no area", "at least three corners that are not on one line");
    } else if (overlap(outline, reservoir(scene))) {
      findings.add(pointer, "the body reaches into the reservoir",
                   "a body clear of the block, x from 0 to " + rounded(scene.reservoir_length) +
                       " m, z from 0 to " + rounded(scene.reservoir_height) + " m");
    } else {
      for (std::size_t k = 0; k < scene.barriers.size(); ++k) {
        if (!overlap(outline, solver::barrier_outline(scene, scene.barriers[k]))) continue;
        findings.add(pointer, "the body overlaps barrier " + std::to_string(k + 1),
                     "a body clear of the barriers");
      }
    }
  }
}

}  // namespace

void check_barrier_keys(const Json& json, Findings& findings) {
  if (!json.contains("barriers")) return;
  const Json& barriers = json.at("barriers");
  for (std::size_t k = 0; k < barriers.size(); ++k) {
    const std::string pointer = barrier_pointer(k);
    const bool has_foot = barriers[k].contains("foot_x_m");
    const bool has_spacing = barriers[k].contains("spacing_m");
    if (k == 0 && has_spacing) {
      findings.add(pointer + "/spacing_m", "the first barrier has no previous one",
                   "foot_x_m for the first barrier");
    } else if (has_foot && has_spacing) {
      findings.add(pointer + "/spacing_m", "stands beside foot_x_m, and only one of them can hold",
                   "either foot_x_m or spacing_m");
    } else if (k > 0 && !has_foot && !has_spacing) {
      findings.add(pointer + "/spacing_m", "is missing",
                   "a number above 0 up to 1000 [m], from the previous barrier's foot");
    }
    if (barriers[k].contains("stem_inclination") && barriers[k].contains("stem_lean_deg")) {
      findings.add(pointer + "/stem_lean_deg",
                   "stands beside stem_inclination, and only one of them can hold",
                   "either stem_inclination or stem_lean_deg");
    }
  }
}

void check_case_meaning(const CaseSpec& spec, Findings& findings) {
  check_reservoir(spec.scene, findings);
  check_run(spec.run, findings);
  check_resolution(spec, findings);
  check_sound_speed(spec, findings);
  check_barriers(spec, findings);
  check_solids(spec.scene, findings);
  check_approach(spec, findings);
}

}  // namespace parapet::designs
