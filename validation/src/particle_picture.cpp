#include "particle_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "parapet/reports/canvas.hpp"
#include "parapet/reports/color_map.hpp"
#include "parapet/reports/plot_axes.hpp"

namespace parapet::validation {

using reports::AlignX;
using reports::AlignY;
using reports::Canvas;
using reports::Color;
using reports::Pixel;
using reports::PixelBox;

namespace {

constexpr Color ink{0.13, 0.13, 0.15, 1.0};
constexpr Color wall_ink{0.36, 0.37, 0.40, 1.0};
constexpr double font = 14.0;  // [px]

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  double size() const { return high - low; }
};

struct Window {
  Range x, z;
};

Window shown(const ParticlePicture& p) {
  Window w;
  w.x.include(p.window_from.x);
  w.x.include(p.window_to.x);
  w.z.include(p.window_from.z);
  w.z.include(p.window_to.z);
  if (w.x.size() > 0.0 && w.z.size() > 0.0) return w;
  w = {};
  for (const ParticlePanel& panel : p.panels) {
    for (const double x : panel.x) w.x.include(x);
    for (const double z : panel.z) w.z.include(z);
  }
  const double margin = 0.03 * std::max(w.x.size(), w.z.size());
  w.x = {w.x.low - margin, w.x.high + margin};
  w.z = {w.z.low - margin, w.z.high + margin};
  return w;
}

struct View {
  Window window;
  PixelBox box;
  double scale() const { return box.width / window.x.size(); }
  Pixel at(double x, double z) const {
    return {box.left + (x - window.x.low) * scale(), box.bottom() - (z - window.z.low) * scale()};
  }
};

void draw_axes(Canvas& canvas, const View& view, bool left, bool bottom) {
  canvas.outline_box(view.box, {ink, 1.0, {}});
  const auto wanted = [](double pixels) { return std::max(2, static_cast<int>(pixels / 90.0)); };
  const auto& [x, z] = view.window;
  const reports::Ticks along = reports::nice_ticks(x.low, x.high, wanted(view.box.width));
  const reports::Ticks up = reports::nice_ticks(z.low, z.high, wanted(view.box.height));
  for (std::size_t k = 0; bottom && k < along.values.size(); ++k) {
    const double px = view.at(along.values[k], z.low).x;
    canvas.polyline({{px, view.box.bottom()}, {px, view.box.bottom() + 4.0}}, {ink, 1.0, {}});
    canvas.text({px, view.box.bottom() + 6.0}, along.labels[k],
                {0.9 * font, ink, false, AlignX::center, AlignY::top});
  }
  for (std::size_t k = 0; left && k < up.values.size(); ++k) {
    const double py = view.at(x.low, up.values[k]).y;
    canvas.polyline({{view.box.left - 4.0, py}, {view.box.left, py}}, {ink, 1.0, {}});
    canvas.text({view.box.left - 7.0, py}, up.labels[k],
                {0.9 * font, ink, false, AlignX::right, AlignY::middle});
  }
}

void draw_panel(Canvas& canvas, const ParticlePicture& p, const ParticlePanel& panel,
                const View& view, const Range& range) {
  canvas.clip(view.box);
  const double radius = std::max(0.6, 0.56 * p.spacing * view.scale());
  for (std::size_t k = 0; k < panel.x.size(); ++k) {
    const double share = (panel.quantity[k] - range.low) / range.size();
    canvas.disc(view.at(panel.x[k], panel.z[k]), radius, reports::viridis(share));
  }
  for (const auto* walls : {&p.walls, &panel.walls}) {
    for (const solver::Face& face : *walls) {
      canvas.polyline({view.at(face.a.x, face.a.z), view.at(face.b.x, face.b.z)},
                      {wall_ink, 2.5, {}});
    }
  }
  canvas.unclip();
  if (!panel.title.empty()) {
    canvas.text({view.box.left + 6.0, view.box.top + 0.8 * font}, panel.title, {font, ink, true});
  }
}

void draw_color_bar(Canvas& canvas, const PixelBox& bar, const Range& range,
                    const std::string& quantity) {
  constexpr int shades = 160;
  for (int k = shades - 1; k >= 0; --k) {
    const double height = bar.height * (k + 1) / shades;
    canvas.fill_box({bar.left, bar.bottom() - height, bar.width, height},
                    reports::viridis((k + 0.5) / shades));
  }
  canvas.outline_box(bar, {ink, 1.0, {}});
  const reports::Ticks ticks = reports::nice_ticks(range.low, range.high, 5);
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double y = bar.bottom() - bar.height * (ticks.values[k] - range.low) / range.size();
    canvas.polyline({{bar.right(), y}, {bar.right() + 4.0, y}}, {ink, 1.0, {}});
    canvas.text({bar.right() + 7.0, y}, ticks.labels[k], {0.9 * font, ink});
  }
  canvas.text({bar.right() + 4.6 * font, bar.top + 0.5 * bar.height}, quantity,
              {font, ink, false, AlignX::center, AlignY::middle, -std::numbers::pi / 2.0});
}

}  // namespace

ParticlePanel speed_panel(const solver::Flow& flow, std::string title) {
  const solver::Fluid& f = flow.fluid();
  ParticlePanel panel{std::move(title), {}, {}, {}, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) {
    panel.x.push_back(f.x[i]);
    panel.z.push_back(f.z[i]);
    panel.quantity.push_back(std::hypot(f.u[i], f.w[i]));
  }
  return panel;
}

ParticlePanel pressure_panel(const solver::Flow& flow, std::string title, double scale) {
  ParticlePanel panel = speed_panel(flow, std::move(title));
  for (std::size_t i = 0; i < panel.quantity.size(); ++i) {
    panel.quantity[i] = flow.fluid().pressure[i] / scale;
  }
  return panel;
}

void draw(CaseRun& run, std::string_view file_name, const ParticlePicture& p) {
  const Window window = shown(p);
  const int n = static_cast<int>(p.panels.size());
  const int columns = p.columns > 0 ? std::min(p.columns, n) : n,
            rows = (n + columns - 1) / columns;
  const double top = p.title.empty() ? 12.0 : 36.0, left = 58.0, right = 110.0, gap = 10.0;
  const double width = (p.width_px - left - right - (columns - 1) * gap) / columns;
  const double height = width * window.z.size() / window.x.size();
  const int page = static_cast<int>(std::ceil(top + rows * height + (rows - 1) * gap + 34.0));
  Range range{p.low, p.high};
  if (!(p.low < p.high)) {
    range = {};
    for (const ParticlePanel& panel : p.panels) {
      for (const double q : panel.quantity) range.include(q);
    }
    if (!(range.size() > 0.0)) range = {range.low, range.low + 1.0};
  }
  Canvas canvas(run.figure(file_name), p.width_px, std::max(page, 64));
  canvas.fill_box({0.0, 0.0, static_cast<double>(p.width_px), static_cast<double>(page)},
                  {1.0, 1.0, 1.0, 1.0});
  if (!p.title.empty()) canvas.text({left, 18.0}, p.title, {1.15 * font, ink, true});
  for (int k = 0; k < n; ++k) {
    const int row = k / columns, column = k % columns;
    const View view{window,
                    {left + column * (width + gap), top + row * (height + gap), width, height}};
    draw_panel(canvas, p, p.panels[static_cast<std::size_t>(k)], view, range);
    draw_axes(canvas, view, column == 0, row == rows - 1);
  }
  draw_color_bar(canvas, {p.width_px - right + 14.0, top, 14.0, rows * height + (rows - 1) * gap},
                 range, p.quantity);
  canvas.save();
}

}  // namespace parapet::validation
