// Table 3 of the source paper (Huang et al. 2024): every number and every trend that its text
// states, each a row of the scorecard, agreeing or not.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "barrier_runs.hpp"
#include "cases.hpp"
#include "parapet/designs/study_spec.hpp"
#include "table3_pictures.hpp"
#include "table3_plots.hpp"
#include "table3_rows.hpp"

namespace parapet::validation {
namespace {

// How near a single printed value must be met, and why just that near.
struct Closeness {
  const char* metric;
  const char* name;
  const char* unit;
  double scale;     // from SI to the unit
  double relative;  // share of the value
  double absolute;  // in SI
  const char* reason;
};
constexpr Closeness closeness[] = {
    {"retention_efficiency", "retention", "", 1.0, 0.0, 0.02, "stated in words; scatter 0.01"},
    {"retention_efficiency_total", "retention of both barriers", "", 1.0, 0.0, 0.01,
     "stated in words; single droplets may pass"},
    {"launch_tip_x_m", "tip of the overflow at 1.05 s", "m", 1.0, 0.10, 0.0,
     "a tenth of what is printed as the launch length"},
    {"impact_time_s", "impact time", "s", 1.0, 0.0, 0.05,
     "time of the picture; the text has about 1.05 s for all"},
    {"launch_angle_deg", "launch angle", "deg", 1.0, 0.0, 10.0, "\"approximately\" in the text"},
    {"ramp_angle_deg", "slope of the ramp at 1.05 s", "deg", 1.0, 0.0, 10.0,
     "\"approximately\" in the text"},
    {"dead_zone_ratio", "D_F", "", 1.0, 0.0, 0.5, "read from a figure"},
    {"flow_depth_max_m", "largest flow depth", "mm", 1e3, 0.10, 0.0, "a tenth of what is printed"},
    {"flow_depth_max_time_s", "time of it", "s", 1.0, 0.0, 0.05, "time of the picture"},
};

const Closeness& closeness_of(const std::string& metric) {
  for (const Closeness& c : closeness) {
    if (metric == c.metric) return c;
  }
  throw std::logic_error("table3: no closeness for the published metric " + metric);
}

// Of the retention of two barriers: nothing else can carry material past the second.
constexpr const char* thrown_over =
    "what the sheet throws over the downstream barrier at its impact, one or two hundredths of the "
    "release; see noise for how far equal runs differ";

std::string why_missed(const std::string& row, const std::string& metric) {
  if (metric == "launch_angle_deg") {
    return "the paper does not say where and over which mass it is measured; here it is the first "
           "1 % of the mass to land, at the barrier's last edge. Not the scheme: as published it "
           "is outside as well (table3_as_published)";
  }
  if (metric == "impact_time_s") {
    return "not the scheme: as published the overflow lands earlier still (table3_as_published). "
           "The text has about 1.05 s for all scenarios, the captions of Fig. 8 have 1.025 to 1.1 "
           "s";
  }
  if (metric == "dead_zone_ratio") {
    return "the paper does not say below which speed it calls material at rest; the edge moves by "
           "centimetres with it (docs/metrics.md has ours)";
  }
  if (metric == "retention_efficiency" && row != "H10-WD2") return "see H10-WD2";
  if (metric == "retention_efficiency_total") return thrown_over;
  if (metric == "retention_efficiency" && row == "H10-WD2") {
    return "the paper says \"decreases by about 40 %\" in one place and \"intercepts about 40 %\" "
           "in another; ours is above by little more than its uncertainty (grid convergence), the "
           "paper's own scheme by more (table3_as_published)";
  }
  if (metric == "flow_depth_max_time_s") {
    return "the depth hardly changes around its largest value, so its time is not sharp";
  }
  if (metric == "flow_depth_max_m") {
    return "the set-up, not the scheme: as published it is as deep (table3_as_published), and 50 "
           "mm in "
           "an independent computation of the same equations";
  }
  return "";
}

void add_published(CaseRun& run, const designs::SweepRow& row, const solver::Result& result) {
  for (const auto& [key, entry] : row.published.items()) {
    const Closeness& c = closeness_of(key);
    const solver::Metric* found = result.find_metric(key);
    // the quick version's particles are too coarse for some readings
    if (!run.full() && found && found->absence == solver::Absence::too_coarse) continue;
    Measure m;
    m.key = fmt::format("{}_{}", row.id, key);
    m.what = fmt::format("{}: {}", row.id, c.name);
    m.value = c.scale * metric(result, key);
    m.unit = c.unit;
    if (entry.contains("value")) {
      const double value = entry.at("value").get<double>();
      const double off = std::max(c.relative * std::abs(value), c.absolute);
      m.lower = c.scale * (value - off);
      m.upper = c.scale * (value + off);
      m.reason = fmt::format("the paper has {} ({}); {}", value_text(c.scale * value, c.unit),
                             entry.at("source").get<std::string>(), c.reason);
    } else {
      if (entry.contains("lower")) m.lower = c.scale * entry.at("lower").get<double>();
      if (entry.contains("upper")) m.upper = c.scale * entry.at("upper").get<double>();
      m.reason = fmt::format("{}", entry.at("source").get<std::string>());
    }
    m.explanation = why_missed(row.id, key);
    m.fitted = entry.value("fitted", false);
    if (m.fitted) m.reason += "; a reading chosen afterwards";
    run.add(m);
  }
}

// What the paper's launch length may have been, each by its own definition, beside the tip.
void add_readings(CaseRun& run, const designs::SweepRow& row, const solver::Result& result) {
  constexpr struct {
    const char* key;
    const char* what;
    const char* unit;
  } readings[] = {
      {"launch_tip_landed", "whether that tip has landed (1) or flies (0)", ""},
      {"launch_farthest_x_m", "farthest single particle at 1.05 s", "m"},
      {"impact_x_m", "where the coherent overflow lands, from the back wall", "m"},
      {"launch_length_m", "the same from the barrier's foot", "m"},
      {"launch_angle_deg", "direction of the overflow at the last edge", "deg"},
  };
  for (const auto& reading : readings) {
    run.add({.key = fmt::format("{}_{}_reading", row.id, reading.key),
             .what = fmt::format("{}: {}", row.id, reading.what),
             .value = metric(result, reading.key),
             .unit = reading.unit});
  }
}

// Time after which the first barrier's retention stays within 0.02 of its end.
double stable_from(const solver::Result& result) {
  const auto& columns = result.series.columns;
  const auto at = static_cast<std::size_t>(
      std::find(columns.begin(), columns.end(), "barrier_1_retention_efficiency") -
      columns.begin());
  const auto& table = result.series.rows;
  std::size_t k = table.size();
  while (k > 0 && std::abs(table[k - 1][at] - table.back()[at]) <= 0.02) --k;
  return table[std::min(k, table.size() - 1)].front();
}

const std::vector<std::string> singles{"H10-WD2", "H10-D0", "H10-D30", "H10-D45", "H10-D60"};
void add_overflow_trends(CaseRun& run, const Rows& rows) {
  const auto launch = [&](const char* id) { return 1e3 * rows(id, "launch_length_m"); };
  add_trend(run, "launch_falls", "launch length: 45 deg less 0 deg",
            launch("H10-D45") - launch("H10-D0"), "mm", {}, 0.0,
            "falls as the angle grows from 0 to 45 deg (Sec. 3.1, Fig. 9a)");
  add_trend(run, "launch_flattens", "launch length: fall from 45 to 60 deg over that from 0 to 45",
            (launch("H10-D45") - launch("H10-D60")) / (launch("H10-D0") - launch("H10-D45")), "",
            {}, 0.5,
            "the effect is less pronounced beyond 45 deg (Sec. 3.1); that half is less is ours");
  add_trend(run, "launch_bare", "launch length: bare less 0 deg",
            launch("H10-WD2") - launch("H10-D0"), "mm", {}, 0.0,
            "bare is marginally shorter than orthogonal (Sec. 3.1)",
            "the difference is within the scatter of equal runs (noise)");
  add_trend(run, "angle_rises", "launch angle: 60 deg less 0 deg",
            rows("H10-D60", "launch_angle_deg") - rows("H10-D0", "launch_angle_deg"), "deg", 0.0,
            {}, "grows with the deflector's angle (Sec. 3.1, Fig. 9b)");
  add_trend(run, "dead_zone_rises", "D_F: smallest step from angle to angle",
            smallest_rise(rows, angles, "dead_zone_ratio"), "", 0.0, {},
            "positively correlated with the deflector's angle (Sec. 3.1, Fig. 10)",
            "its edge depends on the speed that is called rest; see H10-D45");
  add_trend(run, "dead_zone_bare", "dead zone's length: 45 deg over bare",
            rows("H10-D45", "dead_zone_length_m") / rows("H10-WD2", "dead_zone_length_m"), "", 1.0,
            {}, "grows markedly with a deflector (Sec. 3.1)");
}

void add_energy_trends(CaseRun& run, const Rows& rows) {
  const auto peak = [&](const std::string& id) { return rows(id, "kinetic_energy_peak_j_per_m"); };
  const auto dip = [&](const std::string& id) {
    return rows(id, "kinetic_energy_minimum_j_per_m") / peak(id);
  };
  const auto second = [&](const char* id) {
    return rows(id, "kinetic_energy_overflow_peak_j_per_m");
  };
  for (const char* id : {"H10-D30", "H10-D45", "H10-D60"}) {
    add_trend(run, fmt::format("{}_dip", id).c_str(),
              fmt::format("{}: least energy of phase 2 over the peak of phase 1", id), dip(id), "",
              {}, 0.1,
              "a period of zero energy with deflectors (Sec. 3.1, Fig. 11); that a tenth is zero "
              "is ours");
  }
  add_trend(run, "dip_bare", "bare: least energy of phase 2 over the peak of phase 1",
            dip("H10-WD2"), "", dip("H10-D45"), {},
            "without a deflector the energy rises at once (Sec. 3.1): above that of 45 deg",
            "the window's energy is small for an instant in both");
  for (const char* id : {"H10-WD2", "H10-D0", "H10-D45"}) {
    add_trend(
        run, fmt::format("{}_peak_time", id).c_str(),
        fmt::format("{}: time of the first energy peak less that of the arrival", id),
        rows(id, "kinetic_energy_peak_time_s") - rows(id, "barrier_1_arrival_time_s"), "s", -0.1,
        0.1,
        "phase 1 ends when the flow meets the barrier (Sec. 3.1, Fig. 11); the 0.1 s are ours");
  }
  add_trend(run, "energy_45_60", "second energy peak: 45 deg over 60 deg",
            second("H10-D45") / second("H10-D60"), "", 1.0, {},
            "45 deg dissipates less than 60 deg in the window (Sec. 3.1)",
            "the two differ by less than equal runs do (noise)");
  add_trend(run, "energy_45_30", "second energy peak: 45 deg over 30 deg",
            second("H10-D45") / second("H10-D30"), "", 1.0, {},
            "45 deg dissipates less than 30 deg in the window (Sec. 3.1)",
            "ours falls with the angle throughout: a thinner overflow carries less energy");
  add_trend(run, "energy_0_bare", "second energy peak: 0 deg over bare",
            second("H10-D0") / second("H10-WD2"), "", 0.5, 2.0,
            "orthogonal dissipates like bare (Sec. 3.1); the factor of 2 is ours");
  add_trend(run, "energy_180", "dual: least energy of phase 2 over its peak, 180 mm upstream",
            dip("H18-WD-H25"), "", {}, 0.1,
            "a zone of zero energy with 180 mm (Sec. 3.1, Fig. 13); that a tenth is zero is ours");
}

void add_retention_trends(CaseRun& run, const Rows& rows) {
  add_trend(run, "retention_rises", "retention: smallest step from angle to angle",
            smallest_rise(rows, angles, "retention_efficiency"), "", 0.0, {},
            "larger angles retain more (Sec. 3.2, Fig. 17)");
  add_trend(run, "retention_deflector", "retention: 0 deg less bare",
            rows("H10-D0", "retention_efficiency") - rows("H10-WD2", "retention_efficiency"), "",
            0.0, {}, "deflectors intercept more than bare barriers (Sec. 4)");
  for (const std::string& id : angles) {
    add_trend(run, (id + "_stable").c_str(), id + ": retention stays within 0.02 of its end from",
              stable_from(rows.result(id)), "s", {}, 1.6,
              "stabilises from about 1.5 s (Sec. 3.2); 1.6 s and 0.02 are ours");
  }
  const double full = rows("H10-WD1", "retention_efficiency");
  add_trend(run, "loss_180", "retention: 250 mm single less 180 mm upstream",
            full - rows("H18-WD-H25", "retention_efficiency"), "", 0.05, 0.15,
            "180 mm cuts the volume retained by about a tenth (Sec. 4)");
  add_trend(run, "loss_100", "retention: 250 mm less 100 mm",
            full - rows("H10-WD2", "retention_efficiency"), "", 0.35, 0.45,
            "100 mm cuts it by about 40 % (Sec. 4)", "see H10-WD2");
  add_trend(run, "retention_180", "retention: 180 mm upstream",
            rows("H18-WD-H25", "retention_efficiency"), "", 0.9, {},
            "over 90 % (Sec. 3.2, Fig. 19)", "see the grid convergence");
  add_trend(run, "rapid_interception",
            "arrival at the downstream barrier: 0 deg less the earliest of the other angles",
            rows("H10-D0-H25", "barrier_2_arrival_time_s") -
                std::min({rows("H10-D30-H25", "barrier_2_arrival_time_s"),
                          rows("H10-D45-H25", "barrier_2_arrival_time_s"),
                          rows("H10-D60-H25", "barrier_2_arrival_time_s")}),
            "s", {}, 0.0,
            "rapid interception by the downstream barrier behind an orthogonal deflector "
            "(Sec. 3.2)");
  add_trend(run, "momentum_0",
            "design force on the downstream barrier: 0 deg over the largest of the other angles",
            rows("H10-D0-H25", "barrier_2_design_force_n_per_m") /
                std::max({rows("H10-D30-H25", "barrier_2_design_force_n_per_m"),
                          rows("H10-D45-H25", "barrier_2_design_force_n_per_m"),
                          rows("H10-D60-H25", "barrier_2_design_force_n_per_m")}),
            "", 1.0, {}, "the highest momentum behind an orthogonal deflector (Sec. 3.2)");
  for (const char* id : {"H10-WD1-H25", "H10-WD-H18", "H10-WD2-H25", "H18-WD-H25"}) {
    add_trend(run, fmt::format("{}_total", id).c_str(),
              fmt::format("{}: retention of both barriers", id),
              rows(id, "retention_efficiency_total"), "", 0.99, {},
              "our limit: the paper prints complete interception for the four deflector cases only",
              thrown_over);
  }
  add_trend(
      run, "spacing", "retention of both: 400 mm apart less 700 mm apart",
      rows("H10-WD2-H25", "retention_efficiency_total") -
          rows("H10-WD1-H25", "retention_efficiency_total"),
      "", -0.01, {},
      "300 mm less distance still retains the highest volume (Sec. 3.2); the hundredth is ours",
      thrown_over);
}

}  // namespace

void table3(CaseRun& run) {
  designs::SweepSpec sweep = designs::parse_sweep(
      designs::parse_json(designs::embedded_spec("table3"), "table3"), "table3");
  if (!run.full()) {
    std::erase_if(sweep.rows, [](const designs::SweepRow& row) {
      return row.id != "H0-WD" && row.id != "H10-WD1" && row.id != "H10-D60";
    });
  }
  std::vector<solver::Result> results(sweep.rows.size());
  std::vector<Frames> frames(sweep.rows.size());
  run.side_by_side(
      sweep.rows.size(),
      [&](std::size_t k) {
        const designs::CaseSpec& spec = sweep.rows[k].spec;
        solver::Numerics numerics = spec.numerics;
        if (!run.full()) numerics.spacing = 0.0125;
        // metrics as `parapet table3` reads them; the pictures go on until all is at rest
        results[k] = simulated(spec.scene, numerics, spec.run, run);
        if (!run.full()) return;
        frames[k] = Frames(pictured_times(sweep.rows[k].id, results[k]), spec.scene);
        simulated(spec.scene, numerics, run, Frames::interval,
                  [&](const solver::Frame& frame) { frames[k].take(frame); });
      },
      std::vector<double>(sweep.rows.size(), run.full() ? 20.0 : 1.5));
  for (std::size_t k = 0; k < sweep.rows.size(); ++k) {
    add_published(run, sweep.rows[k], results[k]);
    const auto& single = std::ranges::find(singles, sweep.rows[k].id);
    if (run.full() && single != singles.end()) add_readings(run, sweep.rows[k], results[k]);
  }
  if (!run.full()) return;
  const Rows rows(sweep.rows, results);
  add_overflow_trends(run, rows);
  add_energy_trends(run, rows);
  add_retention_trends(run, rows);
  add_words(run, rows);
  draw_table3(run, sweep.rows, results);
  draw_table3_flows(run, sweep.rows, results, frames);
}

}  // namespace parapet::validation
