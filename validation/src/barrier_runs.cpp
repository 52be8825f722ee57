#include "barrier_runs.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace parapet::validation {

solver::Scene scene_of(const SingleBarrier& single) {
  solver::Scene scene;
  solver::Barrier barrier;
  barrier.height = single.height;
  if (single.angle_deg != bare) {
    barrier.deflector = solver::Deflector{single.angle_deg * std::numbers::pi / 180.0, 0.065};
  }
  scene.barriers = {barrier};
  return scene;
}

std::vector<solver::Face> outlines(const solver::Scene& scene) {
  std::vector<solver::Face> lines{solver::make_face({0.0, 0.0}, {scene.domain_length, 0.0}, 0, -1)};
  for (const solver::Barrier& barrier : scene.barriers) {
    const std::vector<solver::Vec2> outline = barrier_outline(scene, barrier);
    for (std::size_t k = 1; k < outline.size(); ++k) {
      lines.push_back(solver::make_face(outline[k - 1], outline[k], 0, -1));
    }
  }
  return lines;
}

solver::Result simulated(const solver::Scene& scene, const solver::Numerics& numerics,
                         const CaseRun& run, double frame_interval,
                         const std::function<void(const solver::Frame&)>& on_frame) {
  solver::RunOptions options;
  options.frame_interval = frame_interval;
  options.until_rest = frame_interval > 0.0;  // pictures show what the barriers hold at last
  return simulated(scene, numerics, options, run, on_frame);
}

solver::Result simulated(const solver::Scene& scene, const solver::Numerics& numerics,
                         const solver::RunOptions& options, const CaseRun& run,
                         const std::function<void(const solver::Frame&)>& on_frame) {
  solver::Callbacks callbacks;
  callbacks.on_frame = on_frame;
  callbacks.on_progress = [&](const solver::Progress&) {
    run.check_cancelled();
    return true;
  };
  solver::Result result = simulate(scene, numerics, options, callbacks);
  if (result.status != solver::Status::ok) throw std::runtime_error(result.reason);
  return result;
}

double metric(const solver::Result& result, const std::string& key) {
  const solver::Metric* found = result.find_metric(key);
  return found && found->value ? *found->value : std::numeric_limits<double>::quiet_NaN();
}

std::optional<Spread> spread(std::span<const solver::Result> results, const JudgedMetric& judged) {
  std::vector<double> values;
  double sum = 0.0, square = 0.0;
  for (const solver::Result& result : results) {
    const double value = judged.scale * metric(result, judged.key);
    if (!std::isfinite(value)) continue;
    values.push_back(value);
    sum += value;
  }
  const auto n = static_cast<double>(values.size());
  if (n < 2.0) return std::nullopt;
  for (const double value : values) square += (value - sum / n) * (value - sum / n);
  return Spread{sum / n, std::sqrt(square / (n - 1.0)), values.size()};
}

}  // namespace parapet::validation
