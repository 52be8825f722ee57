#include "table3_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "barrier_runs.hpp"
#include "parapet/reports/line_plot.hpp"

namespace parapet::validation {
namespace {

const std::vector<std::string> singles{"H10-WD2", "H10-D0", "H10-D30", "H10-D45", "H10-D60"};
const std::vector<std::string> duals{"H10-WD1-H25", "H10-WD-H18", "H10-WD2-H25", "H18-WD-H25"};

std::size_t index_of(const std::vector<designs::SweepRow>& rows, const std::string& id) {
  return static_cast<std::size_t>(
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.id == id; }) -
      rows.begin());
}

reports::PlotSeries series_of(const solver::Result& result, const std::string& column,
                              const std::string& label) {
  const auto& columns = result.series.columns;
  const auto at =
      static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
  reports::PlotSeries series{label, {}, {}, reports::SeriesStyle::line, {}};
  for (const auto& row : result.series.rows) {
    series.x.push_back(row.front());
    series.y.push_back(row[at]);
  }
  return series;
}

void draw_series(CaseRun& run, const char* file, const char* title, const char* y_label,
                 const std::vector<std::string>& ids, const char* column, double end,
                 const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results) {
  reports::LinePlot plot;
  plot.title = title;
  plot.x_label = "time [s]";
  plot.y_label = y_label;
  for (const std::string& id : ids) {
    plot.series.push_back(series_of(results[index_of(rows, id)], column, id));
  }
  plot.x_limits = {0.3, end};
  plot.width_px = 800;
  plot.height_px = 460;
  draw_line_plot(run.figure(file), plot);
}

// A metric against the deflector's angle.
reports::PlotSeries by_angle(const std::vector<designs::SweepRow>& rows,
                             const std::vector<solver::Result>& results, const char* key) {
  reports::PlotSeries ours{"simulated", {}, {}, reports::SeriesStyle::line_and_markers, 0};
  for (const double angle : {0.0, 30.0, 45.0, 60.0}) {
    ours.x.push_back(angle);
    ours.y.push_back(metric(results[index_of(rows, fmt::format("H10-D{:.0f}", angle))], key));
  }
  return ours;
}

void draw_by_angle(CaseRun& run, const char* file, const char* title, const char* y_label,
                   std::vector<reports::PlotSeries> series) {
  reports::LinePlot plot;
  plot.title = title;
  plot.x_label = "deflector angle [deg]";
  plot.y_label = y_label;
  plot.series = std::move(series);
  plot.width_px = 800;
  plot.height_px = 460;
  draw_line_plot(run.figure(file), plot);
}

// With what the paper prints; its curves are not to be had.
void draw_angles(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results) {
  using reports::SeriesStyle;
  const double without = metric(results[index_of(rows, "H10-WD2")], "launch_tip_x_m");
  draw_by_angle(run, "launch.png", "How far the overflow reaches at 1.05 s (the paper's Fig. 9a)",
                "x of its tip, from the back wall [m]",
                {by_angle(rows, results, "launch_tip_x_m"),
                 {"Huang et al. 2024", {0.0, 45.0}, {1.845, 1.273}, SeriesStyle::markers, 1},
                 {"bare, simulated", {0.0, 60.0}, {without, without}, SeriesStyle::dashed, 0},
                 {"bare, Huang et al. 2024", {0.0, 60.0}, {1.715, 1.715}, SeriesStyle::dashed, 1}});
  reports::PlotSeries ramp = by_angle(rows, results, "ramp_angle_deg");
  ramp.label = "slope of the ramp at 1.05 s";
  ramp.color = 2;
  draw_by_angle(run, "launch_angle.png", "Direction of the overflow (the paper's Fig. 9b)",
                "launch angle [deg]",
                {by_angle(rows, results, "launch_angle_deg"),
                 std::move(ramp),
                 {"Huang et al. 2024, \"approximately\"",
                  {0.0, 60.0},
                  {20.0, 35.0},
                  SeriesStyle::markers,
                  1}});
  draw_by_angle(run, "dead_zone.png", "Length of the dead zone (the paper's Fig. 10)",
                "over the deflector's length, D_F [-]",
                {by_angle(rows, results, "dead_zone_ratio"),
                 {"Huang et al. 2024: above 3.5 beyond 30 deg",
                  {30.0, 60.0},
                  {3.5, 3.5},
                  SeriesStyle::dashed,
                  1}});
  draw_by_angle(run, "retention_angle.png", "Retention by angle (the paper's Fig. 17)",
                "retention efficiency [-]",
                {by_angle(rows, results, "retention_efficiency"),
                 {"Huang et al. 2024: above 0.8 from 45 deg",
                  {45.0, 60.0},
                  {0.8, 0.8},
                  SeriesStyle::dashed,
                  1}});
}

}  // namespace

void draw_table3(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results) {
  draw_angles(run, rows, results);
  draw_series(run, "retention.png", "Retention of the upstream barrier (the paper's Fig. 16)",
              "retention efficiency [-]", singles, "barrier_1_retention_efficiency", 2.0, rows,
              results);
  draw_series(run, "retention_dual.png", "Retention of the upstream barrier (the paper's Fig. 19)",
              "retention efficiency [-]", duals, "barrier_1_retention_efficiency", 3.0, rows,
              results);
  draw_series(run, "energy.png", "Kinetic energy at the barrier (the paper's Fig. 11)",
              "energy in x = 1.05 to 1.15 m [J/m]", singles, "window_kinetic_energy_j_per_m", 2.0,
              rows, results);
  draw_series(run, "energy_dual.png", "Kinetic energy, two barriers (the paper's Fig. 13)",
              "energy in x = 1.05 to 1.15 m [J/m]", duals, "window_kinetic_energy_j_per_m", 2.5,
              rows, results);
}

}  // namespace parapet::validation
