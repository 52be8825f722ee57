#include "parapet/reports/flow_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "flow_view.hpp"
#include "line_colors.hpp"
#include "parapet/reports/color_map.hpp"
#include "parapet/reports/plot_axes.hpp"

namespace parapet::reports {
namespace {

constexpr Color paper{1.0, 1.0, 1.0, 0.85};

/// Where everything lies on the page [px].
struct Layout {
  int width = 0, height = 0;
  int columns = 1, rows = 1;
  double font = 14.0;
  double top = 0.0;  ///< of the first row
  double panel_width = 0.0, panel_height = 0.0;
  double left = 0.0, gap = 0.0;
  PixelBox color_bar;

  PixelBox panel(int index) const {
    const int row = index / columns, column = index % columns;
    return {left + column * (panel_width + gap), top + row * (panel_height + gap), panel_width,
            panel_height};
  }
  double right() const { return left + columns * panel_width + (columns - 1) * gap; }
  double bottom() const { return top + rows * panel_height + (rows - 1) * gap; }
};

int choose_columns(int asked, int panels, double aspect) {
  if (asked > 0) return std::min(asked, panels);
  if (aspect > 2.6) return 1;  // long and flat: one below the other
  if (panels <= 3) return panels;
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(panels)) - 1e-9));
}

int wanted_y_ticks(double height, double font) {
  return std::max(2, static_cast<int>(height / (3.5 * font)));
}

/// Characters of the longest label of the y axis.
std::size_t longest_y_label(const Region& region, double height, double font) {
  std::size_t longest = 0;
  const Ticks ticks = nice_ticks(region.bottom, region.top, wanted_y_ticks(height, font));
  for (const std::string& label : ticks.labels) {
    const auto characters = std::ranges::count_if(  // bytes that do not continue a character
        label, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    longest = std::max(longest, static_cast<std::size_t>(characters));
  }
  return longest;
}

Layout plan(const Region& region, int panels, const FlowPictureOptions& options) {
  Layout layout;
  layout.width = options.width_px;
  layout.columns = choose_columns(options.columns, panels, region.width() / region.height());
  layout.rows = (panels + layout.columns - 1) / layout.columns;
  layout.font = std::clamp(options.width_px / 80.0, 9.0, 30.0);
  const double font = layout.font;
  layout.gap = 0.9 * font;
  layout.top = options.title.empty() ? 0.9 * font : 2.9 * font;
  const double right_margin = 6.2 * font;
  layout.left = 4.4 * font;
  for (int pass = 0; pass < 2; ++pass) {  // the labels' width depends on the panel's height
    const double room = layout.width - layout.left - right_margin;
    layout.panel_width = (room - (layout.columns - 1) * layout.gap) / layout.columns;
    layout.panel_height = layout.panel_width * region.height() / region.width();
    if (pass > 0) break;
    const std::size_t longest = longest_y_label(region, layout.panel_height, font);
    layout.left = (2.2 + 0.58 * static_cast<double>(longest)) * font;
  }
  layout.height = static_cast<int>(std::ceil(layout.bottom() + 3.7 * font));
  layout.color_bar = {layout.right() + 1.2 * font, layout.top, font, layout.bottom() - layout.top};
  return layout;
}

/// Given, or so that one particle in two hundred is faster, rounded up.
double speed_limit(const std::vector<FlowSnapshot>& snapshots, const FlowPictureOptions& options) {
  if (options.speed_limit > 0.0) return options.speed_limit;
  double limit = 0.0;
  for (const FlowSnapshot& snapshot : snapshots) {
    std::vector<double> speeds;
    for (const double speed : snapshot.speed) {
      if (std::isfinite(speed)) speeds.push_back(speed);
    }
    if (speeds.empty()) continue;
    const auto place = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() * 199 / 200);
    std::nth_element(speeds.begin(), place, speeds.end());
    limit = std::max(limit, *place);
  }
  return limit > 1e-6 ? round_up(limit) : 1.0;
}

double fastest(const std::vector<FlowSnapshot>& snapshots) {
  double speed = 0.0;
  for (const FlowSnapshot& snapshot : snapshots) {
    for (const double v : snapshot.speed) {
      if (std::isfinite(v)) speed = std::max(speed, v);
    }
  }
  return speed;
}

void draw_color_bar(Canvas& canvas, const Layout& layout, double limit, bool open_end) {
  PixelBox bar = layout.color_bar;
  const double tip = 0.9 * layout.font;
  if (open_end) {  // faster particles exist: the bar ends in an arrow
    const std::vector<Pixel> arrow{{bar.left, bar.top + tip},
                                   {bar.left + 0.5 * bar.width, bar.top},
                                   {bar.right(), bar.top + tip}};
    canvas.fill_polygon(arrow, viridis(1.0));
    canvas.outline_polygon(arrow, {frame_color, 0.06 * layout.font, {}});
    bar.top += tip;
    bar.height -= tip;
  }
  constexpr int shades = 200;
  for (int k = shades - 1; k >= 0; --k) {  // each down to the foot, so that no seam shows
    const double height = bar.height * (k + 1) / shades;
    canvas.fill_box({bar.left, bar.bottom() - height, bar.width, height},
                    viridis((k + 0.5) / shades));
  }
  const Pen pen{frame_color, 0.06 * layout.font, {}};
  canvas.outline_box(bar, pen);
  const Ticks ticks = nice_ticks(0.0, limit, 5);
  const TextStyle style{0.9 * layout.font, ink};
  double label_width = 0.0;
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double y = bar.bottom() - bar.height * ticks.values[k] / limit;
    canvas.polyline({{bar.right(), y}, {bar.right() + 0.3 * layout.font, y}}, pen);
    canvas.text({bar.right() + 0.5 * layout.font, y}, ticks.labels[k], style);
    label_width = std::max(label_width, canvas.text_width(ticks.labels[k], style));
  }
  canvas.text({bar.right() + 1.5 * layout.font + label_width, bar.top + 0.5 * bar.height},
              "speed [m/s]",
              {layout.font, ink, false, AlignX::center, AlignY::middle, -std::numbers::pi / 2.0});
}

struct TickedSides {
  bool left = false, bottom = false;
};

void draw_panel_axes(Canvas& canvas, const Layout& layout, const FlowView& view,
                     TickedSides labelled) {
  const double font = layout.font;
  const Pen pen{frame_color, 0.06 * font, {}};
  canvas.outline_box(view.box, pen);
  const int wanted_x = std::max(2, static_cast<int>(view.box.width / (6.0 * font)));
  const Ticks x = nice_ticks(view.region.left, view.region.right, wanted_x);
  const TextStyle x_style{0.9 * font, ink, false, AlignX::center, AlignY::top, 0.0};
  for (std::size_t k = 0; k < x.values.size(); ++k) {
    const Pixel at = view.page({x.values[k], view.region.bottom});
    canvas.polyline({at, {at.x, at.y + 0.3 * font}}, pen);
    if (labelled.bottom) canvas.text({at.x, at.y + 0.6 * font}, x.labels[k], x_style);
  }
  const Ticks y =
      nice_ticks(view.region.bottom, view.region.top, wanted_y_ticks(view.box.height, font));
  const TextStyle y_style{0.9 * font, ink, false, AlignX::right, AlignY::middle, 0.0};
  for (std::size_t k = 0; k < y.values.size(); ++k) {
    const Pixel at = view.page({view.region.left, y.values[k]});
    canvas.polyline({at, {at.x - 0.3 * font, at.y}}, pen);
    if (labelled.left) canvas.text({at.x - 0.5 * font, at.y}, y.labels[k], y_style);
  }
}

/// Decimals with which every time shows to a millisecond.
int time_decimals(const std::vector<FlowSnapshot>& snapshots) {
  const bool hundredths = std::ranges::all_of(snapshots, [](const FlowSnapshot& snapshot) {
    return std::abs(100.0 * snapshot.time - std::round(100.0 * snapshot.time)) < 0.05;
  });
  return hundredths ? 2 : 3;
}

void draw_time(Canvas& canvas, const Layout& layout, const PixelBox& box,
               const std::string& label) {
  const TextStyle style{layout.font, ink, true, AlignX::right, AlignY::top, 0.0};
  const double pad = 0.5 * layout.font;
  const double width = canvas.text_width(label, style);
  canvas.fill_box({box.right() - width - 2.0 * pad, box.top + 0.3 * pad, width + 1.7 * pad,
                   layout.font + 1.2 * pad},
                  paper);
  canvas.text({box.right() - pad, box.top + 1.2 * pad}, label, style);
}

void draw_labels(Canvas& canvas, const Layout& layout, const FlowPictureOptions& options) {
  const bool world = options.axes == PictureAxes::world;
  const double font = layout.font;
  const double middle_x = 0.5 * (layout.left + layout.right());
  canvas.text({middle_x, layout.height - 0.6 * font},
              world ? "horizontal distance [m]" : "x along the bed [m]",
              {font, ink, false, AlignX::center, AlignY::bottom, 0.0});
  canvas.text({0.9 * font, 0.5 * (layout.top + layout.bottom())}, world ? "height [m]" : "z [m]",
              {font, ink, false, AlignX::center, AlignY::middle, -std::numbers::pi / 2.0});
  if (options.title.empty()) return;
  TextStyle style{1.25 * font, ink, true, AlignX::left, AlignY::middle, 0.0};
  const double room = layout.width - layout.left - font;
  const double width = canvas.text_width(options.title, style);
  if (width > room) style.size *= room / width;
  canvas.text({layout.left, 1.5 * font}, options.title, style);
}

void check(const std::vector<FlowSnapshot>& snapshots) {
  if (snapshots.empty()) throw std::invalid_argument("a flow picture needs at least one snapshot");
  for (const FlowSnapshot& snapshot : snapshots) {
    if (snapshot.z.size() != snapshot.x.size() || snapshot.speed.size() != snapshot.x.size()) {
      throw std::invalid_argument(
          fmt::format("the snapshot at {} s has arrays of unequal length", snapshot.time));
    }
  }
}

}  // namespace

FlowSnapshot take_snapshot(const solver::Frame& frame) {
  FlowSnapshot snapshot;
  snapshot.time = frame.time;
  snapshot.x.assign(frame.x.begin(), frame.x.end());
  snapshot.z.assign(frame.z.begin(), frame.z.end());
  snapshot.speed.resize(frame.u.size());
  for (std::size_t k = 0; k < frame.u.size(); ++k) {
    snapshot.speed[k] = std::hypot(frame.u[k], frame.w[k]);
  }
  return snapshot;
}

void draw_flow(const std::filesystem::path& path, const solver::Scene& scene, double spacing,
               const std::vector<FlowSnapshot>& snapshots, const FlowPictureOptions& options) {
  check(snapshots);
  const Turn turn(scene, options.axes);
  const BedRange bed = bed_range(scene, snapshots, options);
  const Region region = visible_region(scene, turn, bed, snapshots);
  const int panels = static_cast<int>(snapshots.size());
  const Layout layout = plan(region, panels, options);
  const double limit = speed_limit(snapshots, options);
  const int decimals = time_decimals(snapshots);

  Canvas canvas(path, layout.width, layout.height);
  for (int k = 0; k < panels; ++k) {
    const FlowSnapshot& snapshot = snapshots[static_cast<std::size_t>(k)];
    const FlowView view{&scene, turn, bed, region, layout.panel(k)};
    canvas.clip(view.box);
    draw_scene(canvas, view, layout.font, options.axes == PictureAxes::world);
    draw_particles(canvas, view, snapshot, spacing, limit);
    canvas.unclip();
    draw_panel_axes(canvas, layout, view, {k % layout.columns == 0, k + layout.columns >= panels});
    draw_time(canvas, layout, view.box, fmt::format("t = {:.{}f} s", snapshot.time, decimals));
  }
  draw_color_bar(canvas, layout, limit, fastest(snapshots) > 1.001 * limit);
  draw_labels(canvas, layout, options);
  canvas.save();
}

}  // namespace parapet::reports
