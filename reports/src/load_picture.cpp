#include "parapet/reports/load_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parapet/reports/line_plot.hpp"

namespace parapet::reports {

bool acts_on_barriers(const solver::Result& result) {
  return std::ranges::any_of(
      result.loads, [](const solver::LoadProfile& profile) { return profile.window_end >= 0.0; });
}

void draw_load_profiles(const std::filesystem::path& path, const std::string& name,
                        const solver::Result& result) {
  LinePlot plot;
  plot.title = name + ": pressure while the design load acts";
  plot.x_label = "pressure [kPa]";
  plot.y_label = "from the foot of the stem, or the crest [m]";
  double least = 0.0, most = 0.0;  // zero belongs to a distribution of pressure
  for (const solver::LoadProfile& profile : result.loads) {
    if (profile.window_end < 0.0) continue;
    for (const double pressure : profile.pressure) {
      least = std::min(least, 1e-3 * pressure);
      most = std::max(most, 1e-3 * pressure);
    }
    PlotSeries series;
    series.label = fmt::format("{} {}, {:.3g} to {:.3g} s: {:.3g} N/m",
                               profile.deflector ? "deflector" : "stem", profile.barrier,
                               profile.window_end - profile.window, profile.window_end,
                               profile.normal_force());
    if (profile.deflector) series.style = SeriesStyle::dashed;
    series.color = profile.barrier - 1;
    for (std::size_t k = 0; k < profile.pressure.size(); ++k) {
      for (const std::size_t end : {k, k + 1}) {
        series.x.push_back(1e-3 * profile.pressure[k]);
        series.y.push_back(profile.edge[end]);
      }
    }
    plot.series.push_back(std::move(series));
  }
  const double margin = 0.05 * (most - least);
  if (margin > 0.0) plot.x_limits = {least < 0.0 ? least - margin : 0.0, most + margin};
  plot.width_px = 800;
  plot.height_px = 520;
  draw_line_plot(path, plot);
}

}  // namespace parapet::reports
