#include "table3_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "barrier_runs.hpp"

namespace parapet::validation {
namespace {

struct Panel {
  const char* row;
  double time;  // [s]; 0: when the overflow lands
};

struct Figure {
  const char* file;
  const char* title;
  std::vector<Panel> panels;
  solver::Vec2 from, to;  // window [m]
};

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      {"landing.png",
       "The overflow lands (the paper's Fig. 7 and 8)",
       {{"H10-WD2", 0.0},
        {"H10-D0", 0.0},
        {"H10-D30", 0.0},
        {"H10-D45", 0.0},
        {"H10-D60", 0.0},
        {"H0-WD", 0.625}},
       {0.7, -0.02},
       {1.8, 0.35}},
      {"interaction_d45.png",
       "Flow and barrier, 45 deg (the paper's Fig. 12)",
       {{"H10-D45", 0.425},
        {"H10-D45", 0.475},
        {"H10-D45", 1.0},
        {"H10-D45", 1.05},
        {"H10-D45", 1.1},
        {"H10-D45", 1.5}},
       {0.5, -0.02},
       {1.6, 0.35}},
      {"pile_250.png",
       "A barrier of 250 mm (the paper's Fig. 14)",
       {{"H10-WD1", 3.45}},
       {0.4, -0.02},
       {1.5, 0.35}},
      {"piles_angles.png",
       "What the barriers hold, by angle (the paper's Fig. 15)",
       {{"H10-D0-H25", 1.0},
        {"H10-D0-H25", 1.075},
        {"H10-D30-H25", 1.025},
        {"H10-D30-H25", 1.25},
        {"H10-D45-H25", 1.05},
        {"H10-D45-H25", 1.35},
        {"H10-D60-H25", 1.075},
        {"H10-D60-H25", 1.45}},
       {0.5, -0.02},
       {1.95, 0.35}},
      {"piles_heights.png",
       "What the barriers hold, by height (the paper's Fig. 18)",
       {{"H10-WD-H18", 2.34}, {"H10-WD1-H25", 3.0}, {"H10-WD2-H25", 3.0}, {"H18-WD-H25", 3.0}},
       {0.5, -0.02},
       {1.95, 0.35}}};
  return all;
}

double time_of(const Panel& panel, const solver::Result& result) {
  return panel.time > 0.0 ? panel.time : metric(result, "impact_time_s");
}

}  // namespace

Frames::Frames(std::vector<double> times, const solver::Scene& scene)
    : wanted_(std::move(times)), walls_(outlines(scene)) {}

void Frames::take(const solver::Frame& frame) {
  Timed timed{frame.time, {}};
  timed.panel.x.assign(frame.x.begin(), frame.x.end());
  timed.panel.z.assign(frame.z.begin(), frame.z.end());
  for (std::size_t i = 0; i < frame.u.size(); ++i) {
    timed.panel.quantity.push_back(std::hypot(frame.u[i], frame.w[i]));
  }
  timed.panel.walls = walls_;
  const bool wanted = std::ranges::any_of(
      wanted_, [&](double time) { return std::abs(time - frame.time) <= 0.5 * interval + 1e-9; });
  if (wanted) kept_.push_back(timed);
  last_ = std::move(timed);
}

ParticlePanel Frames::at(double time) const {
  const Timed* best = &last_;
  for (const Timed& timed : kept_) {
    if (std::abs(timed.time - time) < std::abs(best->time - time)) best = &timed;
  }
  return best->panel;
}

std::vector<double> pictured_times(const std::string& row, const solver::Result& result) {
  std::vector<double> times;
  for (const Figure& figure : figures()) {
    for (const Panel& panel : figure.panels) {
      if (row == panel.row) times.push_back(time_of(panel, result));
    }
  }
  return times;
}

void draw_table3_flows(CaseRun& run, const std::vector<designs::SweepRow>& rows,
                       const std::vector<solver::Result>& results,
                       const std::vector<Frames>& frames) {
  for (const Figure& figure : figures()) {
    ParticlePicture picture;
    picture.title = figure.title;
    picture.quantity = "speed [m/s]";
    picture.high = 2.5;
    picture.spacing = 0.005;
    picture.window_from = figure.from;
    picture.window_to = figure.to;
    picture.columns = std::min<int>(2, static_cast<int>(figure.panels.size()));
    for (const Panel& panel : figure.panels) {
      const auto k = static_cast<std::size_t>(
          std::ranges::find_if(rows, [&](const auto& row) { return row.id == panel.row; }) -
          rows.begin());
      const double time = time_of(panel, results[k]);
      picture.panels.push_back(frames[k].at(time));
      picture.panels.back().title = fmt::format("{}, {:.4g} s", panel.row, time);
    }
    draw(run, figure.file, picture);
  }
}

}  // namespace parapet::validation
