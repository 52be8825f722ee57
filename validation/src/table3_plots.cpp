#include "table3_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

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

const ParticlePanel& nearest(const std::vector<TimedPanel>& panels, double time) {
  const TimedPanel* best = &panels.front();
  for (const TimedPanel& p : panels) {
    if (std::abs(p.time - time) < std::abs(best->time - time)) best = &p;
  }
  return best->panel;
}

void draw_panels(CaseRun& run, const char* file, const char* title,
                 std::vector<ParticlePanel> panels, solver::Vec2 from, solver::Vec2 to) {
  ParticlePicture picture;
  picture.title = title;
  picture.quantity = "speed [m/s]";
  picture.high = 2.5;
  picture.spacing = 0.005;
  picture.window_from = from;
  picture.window_to = to;
  picture.columns = 2;
  picture.panels = std::move(panels);
  draw(run, file, picture);
}

// Against the deflector's angle, with what the paper states.
void draw_launch(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results) {
  reports::LinePlot plot;
  plot.title = "How far the overflow reaches at 1.05 s";
  plot.x_label = "deflector angle [deg]";
  plot.y_label = "x of its tip, from the back wall [m]";
  reports::PlotSeries ours{"simulated", {}, {}, reports::SeriesStyle::line_and_markers, 0};
  for (const double angle : {0.0, 30.0, 45.0, 60.0}) {
    ours.x.push_back(angle);
    ours.y.push_back(
        metric(results[index_of(rows, fmt::format("H10-D{:.0f}", angle))], "launch_tip_x_m"));
  }
  const double without = metric(results[index_of(rows, "H10-WD2")], "launch_tip_x_m");
  plot.series = {
      ours,
      {"Huang et al. 2024", {0.0, 45.0}, {1.845, 1.273}, reports::SeriesStyle::markers, 1},
      {"bare, simulated", {0.0, 60.0}, {without, without}, reports::SeriesStyle::dashed, 0},
      {"bare, Huang et al. 2024", {0.0, 60.0}, {1.715, 1.715}, reports::SeriesStyle::dashed, 1}};
  plot.width_px = 800;
  plot.height_px = 460;
  draw_line_plot(run.figure("launch.png"), plot);
}

}  // namespace

TimedPanel timed_panel(const solver::Frame& frame, const solver::Scene& scene) {
  TimedPanel timed{frame.time, {}};
  timed.panel.x.assign(frame.x.begin(), frame.x.end());
  timed.panel.z.assign(frame.z.begin(), frame.z.end());
  for (std::size_t i = 0; i < frame.u.size(); ++i) {
    timed.panel.quantity.push_back(std::hypot(frame.u[i], frame.w[i]));
  }
  timed.panel.walls = outlines(scene);
  return timed;
}

void draw_table3(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                 const std::vector<solver::Result>& results,
                 const std::vector<std::vector<TimedPanel>>& panels) {
  draw_launch(run, rows, results);
  draw_series(run, "retention.png", "Retention of the upstream barrier (the paper's Fig. 16)",
              "retention efficiency [-]", singles, "barrier_1_retention_efficiency", 2.0, rows,
              results);
  draw_series(run, "retention_dual.png", "Retention of the upstream barrier (the paper's Fig. 19)",
              "retention efficiency [-]", duals, "barrier_1_retention_efficiency", 3.0, rows,
              results);
  draw_series(run, "energy.png", "Kinetic energy at the barrier (the paper's Fig. 11)",
              "energy in x = 1.05 to 1.15 m [J/m]", singles, "window_kinetic_energy_j_per_m", 2.0,
              rows, results);
  std::vector<ParticlePanel> landing;
  for (const std::string& id : singles) {
    const std::size_t k = index_of(rows, id);
    const double time = metric(results[k], "impact_time_s");
    landing.push_back(nearest(panels[k], time));
    landing.back().title = fmt::format("{}, {:.2f} s", id, time);
  }
  landing.push_back(nearest(panels[index_of(rows, "H0-WD")], 0.625));
  landing.back().title = "open channel, 0.625 s";
  draw_panels(run, "landing.png", "The overflow lands (the paper's Fig. 7 and 8)",
              std::move(landing), {0.7, -0.02}, {1.8, 0.35});
  std::vector<ParticlePanel> piles;
  for (const char* id : {"H10-D0-H25", "H10-D45-H25", "H10-WD2-H25", "H18-WD-H25"}) {
    piles.push_back(nearest(panels[index_of(rows, id)], 3.0));
    piles.back().title = fmt::format("{}, 3 s or settled", id);
  }
  draw_panels(run, "piles.png", "What the barriers hold (the paper's Fig. 15 and 18)",
              std::move(piles), {0.5, -0.02}, {1.9, 0.35});
}

}  // namespace parapet::validation
