#include "barrier_runs.hpp"

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

solver::Result simulated(const solver::Scene& scene, const solver::Numerics& numerics,
                         const CaseRun& run) {
  solver::Callbacks callbacks;
  callbacks.on_progress = [&](const solver::Progress&) {
    run.check_cancelled();
    return true;
  };
  solver::Result result = simulate(scene, numerics, {}, callbacks);
  if (result.status != solver::Status::ok) throw std::runtime_error(result.reason);
  return result;
}

double metric(const solver::Result& result, const std::string& key) {
  const solver::Metric* found = result.find_metric(key);
  return found && found->value ? *found->value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace parapet::validation
