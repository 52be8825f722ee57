// What the source paper says in words of dead zones, ramps, overflow and backflow (Huang et al.
// 2024).
#include <fmt/format.h>

#include <algorithm>

#include "table3_rows.hpp"

namespace parapet::validation {
namespace {

void add_reading(CaseRun& run, const std::string& key, const std::string& what, double value,
                 const char* unit) {
  run.add({.key = key, .what = what, .value = value, .unit = unit});
}

void add_dead_zones(CaseRun& run, const Rows& rows) {
  const auto area = [&](const char* id) { return rows(id, "barrier_1_dead_zone_area_m2"); };
  add_trend(run, "dead_zone_area", "dead zone's area at the end: 45 deg over bare",
            area("H10-D45") / area("H10-WD2"), "", 1.0, {},
            "grows markedly with a deflector (Sec. 3.1, Fig. 10)");
  add_trend(
      run, "dead_zone_onset", "45 deg: onset of the dead zone less the arrival",
      rows("H10-D45", "barrier_1_dead_zone_onset_time_s") -
          rows("H10-D45", "barrier_1_arrival_time_s"),
      "s", 0.0, 0.1,
      "starts to form when the flow meets the barrier (Sec. 3.1, Fig. 12); the 0.1 s are ours");
  for (const char* id : {"H10-D0-H25", "H10-D30-H25", "H10-D45-H25", "H10-D60-H25"}) {
    add_reading(run, fmt::format("{}_second_area", id),
                fmt::format("{}: area of the downstream barrier's dead zone at the end", id),
                1e4 * rows(id, "barrier_2_dead_zone_area_m2"), "cm2");
  }
  add_trend(run, "ramps_rise", "ramp at 1.05 s: smallest step from angle to angle",
            smallest_rise(rows, angles, "ramp_angle_deg"), "deg", 0.0, {},
            "larger angles give more pronounced ramp-like dead zones (Sec. 3.2, Fig. 15)");
  add_trend(run, "ramp_180", "ramp at the end: 180 mm upstream less 100 mm, 400 mm apart",
            rows("H18-WD-H25", "barrier_1_ramp_angle_deg") -
                rows("H10-WD2-H25", "barrier_1_ramp_angle_deg"),
            "deg", 0.0, {},
            "steeper as the height of the upstream barrier grows (Sec. 3.2, Fig. 18)");
}

void add_overflow(CaseRun& run, const Rows& rows) {
  const auto thickness = [&](const std::string& id) {
    return 1e3 * rows(id, "overflow_thickness_m");
  };
  const auto speed = [&](const std::string& id) { return rows(id, "overflow_speed_m_s"); };
  for (const std::string& id : angles) {
    add_reading(run, id + "_thickness", id + ": thickness of the overflow at the last edge",
                thickness(id), "mm");
    add_reading(run, id + "_speed", id + ": its speed there", speed(id), "m/s");
  }
  add_trend(
      run, "thick", "thickness of the overflow: 30 deg over 60 deg",
      thickness("H10-D30") / thickness("H10-D60"), "", 1.0, {},
      "below 45 deg the overflow is thick (Sec. 4)",
      "ours is the mean over all that passes the edge: it grows with the angle as the speed falls "
      "(rows above), and their product, the discharge, falls");
  add_trend(run, "fast", "speed of the overflow: 30 deg over 60 deg",
            speed("H10-D30") / speed("H10-D60"), "", 1.0, {},
            "below 45 deg the overflow is fast (Sec. 4)");
}

void add_backflow(CaseRun& run, const Rows& rows) {
  for (const char* id : {"H10-WD2-H25", "H10-WD1-H25"}) {
    add_reading(run, fmt::format("{}_backflow", id),
                fmt::format("{}: share that flows back between the barriers", id),
                rows(id, "barrier_2_backflow_share"), "");
    add_reading(run, fmt::format("{}_backflow_speed", id), fmt::format("{}: its largest speed", id),
                rows(id, "barrier_2_backflow_speed_m_s"), "m/s");
  }
  const auto ratio = [&](const char* key) {
    return rows("H10-WD2-H25", key) / rows("H10-WD1-H25", key);
  };
  add_trend(run, "backflow_share", "share that flows back: 400 mm apart over 700 mm",
            ratio("barrier_2_backflow_share"), "", 1.0, {},
            "a shorter distance sends a larger proportion back (Sec. 3.1, Fig. 13)");
  add_trend(run, "backflow_speed", "its largest speed: 400 mm apart over 700 mm",
            ratio("barrier_2_backflow_speed_m_s"), "", 1.0, {},
            "and with higher velocity (Sec. 3.1, Fig. 13)");
  add_trend(
      run, "backflow_angle", "share that flows back before the barrier: 60 deg over 0 deg",
      rows("H10-D60", "barrier_1_backflow_share") / rows("H10-D0", "barrier_1_backflow_share"), "",
      1.0, {}, "more obvious as the launch length falls (Sec. 4)");
}

// Overflow with a deflector over that of the bare barrier of the same height.
void add_reduction(CaseRun& run, const Rows& rows) {
  for (const std::string& id : angles) {
    add_trend(run, (id + "_reduction").c_str(), id + ": reduction factor of the overflow volume",
              rows(id, "overflow_volume_m3_per_m") / rows("H10-WD2", "overflow_volume_m3_per_m"),
              "", {}, 1.0,
              "deflectors let less pass than the bare barrier (Sec. 1 defines it, Sec. 4)");
  }
}

void add_heights(CaseRun& run, const Rows& rows) {
  const double ours = rows("H0-WD", "flow_depth_max_m");
  constexpr double papers = 0.042;  // [m]
  for (const double height : {0.1, 0.18, 0.25}) {
    add_reading(run, fmt::format("height_{:.0f}", 1e3 * height),
                fmt::format("B/h of {:.0f} mm with our flow depth; with the paper's {:.2f}",
                            1e3 * height, height / papers),
                height / ours, "");
  }
}

}  // namespace

void add_words(CaseRun& run, const Rows& rows) {
  add_dead_zones(run, rows);
  add_overflow(run, rows);
  add_backflow(run, rows);
  add_reduction(run, rows);
  add_heights(run, rows);
}

}  // namespace parapet::validation
