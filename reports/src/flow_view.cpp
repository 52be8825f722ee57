#include "flow_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "parapet/reports/color_map.hpp"
#include "parapet/reports/plot_axes.hpp"

namespace parapet::reports {
namespace {

using solver::Vec2;

constexpr double back_wall_thickness = 0.03;  // drawn only; the solver's wall has none [m]
constexpr double far = 100.0;                 // beyond any picture [m]
constexpr Color ground_color{0.90, 0.88, 0.85, 1.0};
constexpr Color ground_edge{0.45, 0.42, 0.38, 1.0};
constexpr Color solid_color{0.36, 0.37, 0.40, 1.0};
constexpr Color solid_edge{0.15, 0.15, 0.17, 1.0};
constexpr Color faint_ink{0.42, 0.39, 0.36, 1.0};

void draw_solid(Canvas& canvas, const FlowView& view, const std::vector<Vec2>& outline,
                double pen_width) {
  std::vector<Pixel> points;
  for (const Vec2& corner : outline) points.push_back(view.at(corner));
  canvas.fill_polygon(points, solid_color);
  canvas.outline_polygon(points, {solid_edge, pen_width, {}});
}

std::vector<Vec2> back_wall(const solver::Scene& scene) {
  const double top = 1.15 * scene.reservoir_height;
  return {{-back_wall_thickness, 0.0}, {0.0, 0.0}, {0.0, top}, {-back_wall_thickness, top}};
}

void draw_ground(Canvas& canvas, const FlowView& view, double pen_width) {
  canvas.fill_polygon(
      {view.at({-far, 0.0}), view.at({far, 0.0}), view.at({far, -far}), view.at({-far, -far})},
      ground_color);
  canvas.polyline({view.at({-far, 0.0}), view.at({far, 0.0})}, {ground_edge, 1.5 * pen_width, {}});
}

/// Distances along the bed, written into the ground beside short ticks.
void draw_bed_labels(Canvas& canvas, const FlowView& view, double font) {
  const Pixel start = view.at({0.0, 0.0});
  const Pixel end = view.at({1.0, 0.0});
  const double angle = std::atan2(end.y - start.y, end.x - start.x);
  const double tick = 0.4 * font / view.scale();
  const TextStyle style{0.8 * font, faint_ink, false, AlignX::center, AlignY::top, angle};
  const Ticks ticks = nice_ticks(view.bed.from, view.bed.to, 5);
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double x = ticks.values[k];
    const Pixel foot = view.at({x, -2.2 * tick});
    // A label that the panel's edge would cut is left out.
    const double half = 2.2 * font;
    if (foot.x - half < view.box.left || foot.x + half > view.box.right() ||
        foot.y + half > view.box.bottom()) {
      continue;
    }
    canvas.polyline({view.at({x, 0.0}), view.at({x, -tick})}, {ground_edge, 0.07 * font, {}});
    canvas.text(view.at({x, -1.8 * tick}), fmt::format("x = {} m", ticks.labels[k]), style);
  }
}

}  // namespace

Turn::Turn(const solver::Scene& scene, PictureAxes axes) {
  if (axes == PictureAxes::channel) return;
  cosine_ = std::cos(scene.slope);
  sine_ = std::sin(scene.slope);
  const double foot = scene.barriers.empty() ? 0.0 : scene.barriers.front().foot_x;
  datum_ = -foot * sine_;
}

Vec2 Turn::operator()(Vec2 channel) const {
  return {channel.x * cosine_ + channel.z * sine_,
          channel.z * cosine_ - channel.x * sine_ - datum_};
}

BedRange bed_range(const solver::Scene& scene, const std::vector<FlowSnapshot>& snapshots,
                   const FlowPictureOptions& options) {
  double reach = scene.reservoir_length;
  for (const FlowSnapshot& snapshot : snapshots) {
    for (const double x : snapshot.x) {
      if (std::isfinite(x)) reach = std::max(reach, x);
    }
  }
  for (const solver::Barrier& barrier : scene.barriers) {
    reach = std::max(reach, barrier.foot_x + barrier.thickness + 0.1);
  }
  reach = std::min(reach, scene.domain_length);
  const BedRange range{options.x_from.value_or(-2.0 * back_wall_thickness),
                       options.x_to.value_or(reach + 0.04 * (reach + 0.1))};
  if (!(range.from < range.to)) {
    throw std::invalid_argument(
        fmt::format("the stretch of bed to draw, {} to {} m, is empty; allowed: x_from below x_to",
                    range.from, range.to));
  }
  return range;
}

Region visible_region(const solver::Scene& scene, const Turn& turn, const BedRange& bed,
                      const std::vector<FlowSnapshot>& snapshots) {
  constexpr double none = std::numeric_limits<double>::infinity();
  Region region{none, -none, none, -none};
  const auto include = [&](Vec2 channel) {
    if (!(channel.x >= bed.from && channel.x <= bed.to && std::isfinite(channel.z))) return;
    const Vec2 turned = turn(channel);
    region.left = std::min(region.left, turned.x);
    region.right = std::max(region.right, turned.x);
    region.bottom = std::min(region.bottom, turned.z);
    region.top = std::max(region.top, turned.z);
  };
  include({bed.from, 0.0});
  include({bed.to, 0.0});
  for (const Vec2& corner : back_wall(scene)) include(corner);
  for (const solver::Barrier& barrier : scene.barriers) {
    for (const Vec2& corner : solver::barrier_outline(scene, barrier)) include(corner);
  }
  for (const solver::SolidPolygon& solid : scene.solids) {
    for (const Vec2& corner : solid.vertices) include(corner);
  }
  for (const FlowSnapshot& snapshot : snapshots) {
    for (std::size_t k = 0; k < snapshot.x.size(); ++k) include({snapshot.x[k], snapshot.z[k]});
  }
  const double margin = 0.025 * region.width();
  region.top += margin;
  region.right += 0.4 * margin;
  region.bottom -= 1.6 * margin;
  return region;
}

Pixel FlowView::page(Vec2 turned) const {
  return {box.left + (turned.x - region.left) * scale(),
          box.bottom() - (turned.z - region.bottom) * scale()};
}

void draw_scene(Canvas& canvas, const FlowView& view, double font, bool bed_labels) {
  const double pen_width = std::max(0.8, 0.06 * font);
  draw_ground(canvas, view, pen_width);
  if (bed_labels) draw_bed_labels(canvas, view, font);
  draw_solid(canvas, view, back_wall(*view.scene), pen_width);
  for (const solver::SolidPolygon& solid : view.scene->solids) {
    draw_solid(canvas, view, solid.vertices, pen_width);
  }
  for (const solver::Barrier& barrier : view.scene->barriers) {
    draw_solid(canvas, view, solver::barrier_outline(*view.scene, barrier), pen_width);
  }
}

void draw_particles(Canvas& canvas, const FlowView& view, const FlowSnapshot& snapshot,
                    double spacing, double speed_limit) {
  // A little more than dx closes the gaps between the discs of a regular lattice.
  const double radius = std::max(0.6, 0.58 * spacing * view.scale());
  for (std::size_t k = 0; k < snapshot.x.size(); ++k) {
    const Pixel center = view.at({snapshot.x[k], snapshot.z[k]});
    if (!std::isfinite(center.x) || !std::isfinite(center.y)) continue;
    canvas.disc(center, radius, viridis(snapshot.speed[k] / speed_limit));
  }
}

}  // namespace parapet::reports
