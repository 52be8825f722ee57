#include "parapet/solver/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "frame_clock.hpp"
#include "gauges/recorder.hpp"
#include "parapet/flow/channel.hpp"
#include "parapet/flow/stage_timer.hpp"
#include "shared_start.hpp"

namespace parapet::solver {
namespace {

void require_sound_input(const Scene& scene, const Numerics& numerics, const RunOptions& options) {
  std::string text;
  for (const auto& errors : {scene_errors(scene), numerics_errors(numerics), run_errors(options),
                             gauge_errors(options.gauges)}) {
    for (const std::string& error : errors) text += (text.empty() ? "" : "; ") + error;
  }
  constexpr double most = 1.5e7;  // slots of the neighbour rows are numbered with 32 bits
  const double dx = numerics.spacing;
  const double particles = scene.reservoir_length * scene.reservoir_height / (dx * dx);
  if (text.empty() && !(particles <= most && scene.domain_length / dx <= most)) {
    text =
        "particle spacing is " + std::to_string(dx) + " m; allowed: at most 15 million particles";
  }
  if (!text.empty()) throw std::invalid_argument(text);
}

Result finish(const Flow& flow, Recorder& recorder, StopReason stop_reason, std::string reason) {
  const StageScope scope(flow.setup().timer, Stage::gauges);
  Result result;
  result.stop_reason = stop_reason;
  result.reason = std::move(reason);
  switch (stop_reason) {
    case StopReason::end_time:
    case StopReason::metrics_final:
    case StopReason::settled:
    case StopReason::drained:
      result.status = Status::ok;
      break;
    case StopReason::cancelled:
      result.status = Status::cancelled;
      break;
    default:
      result.status = Status::failed;
  }
  result.stop_time = flow.time();
  result.metrics = recorder.metrics(flow, stop_reason);
  result.quality = recorder.quality(flow);
  result.loads = recorder.load_profiles(flow);
  result.warnings = warnings_of(
      result.quality, recorder.unfinished(flow, stop_reason) && result.status == Status::ok,
      flow.time());
  result.series = recorder.take_series();
  result.statistics = flow.statistics();
  result.statistics.max_particles_inside_walls = recorder.max_particles_inside_walls();
  if (result.statistics.steps > 0) {
    result.statistics.mean_time_step = flow.time() / static_cast<double>(result.statistics.steps);
  }
  MassBalance& mass = result.mass;
  const Fluid& f = flow.fluid();
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.n); ++i) mass.in_domain += f.mass[i];
  mass.released = flow.released_mass();
  mass.left_domain = flow.left_mass();
  mass.particles_left = static_cast<std::int64_t>(flow.departures().size());
  mass.particles_released = f.n + mass.particles_left;
  return result;
}

struct Ending {
  StopReason stop_reason;
  std::string reason;
};

Ending run(Flow& flow, Recorder& recorder, SharedStart& start, const RunOptions& options,
           const Callbacks& callbacks) {
  const auto whole = [](double time, double interval) {
    return static_cast<std::int64_t>(std::llround(time / interval));
  };
  const std::int64_t samples =
      std::max<std::int64_t>(1, whole(options.stop_time, options.series_interval));
  FrameClock frames(options, callbacks);
  StageTimer* timer = flow.setup().timer;
  const auto gauge = [&](const auto& action) {
    const StageScope scope(timer, Stage::gauges);
    return action();
  };
  const std::int64_t begun = start.resume(flow, recorder, samples);
  if (begun == 0) {
    gauge([&] { recorder.sample(flow); });
    start.sampled(flow, recorder);
    frames.begin(flow);
  }
  for (std::int64_t sample = std::max<std::int64_t>(1, begun); sample <= samples; ++sample) {
    const double target = sample == samples ? options.stop_time
                                            : static_cast<double>(sample) * options.series_interval;
    while (target - flow.time() > 1e-9 * options.series_interval) {
      frames.before_step(flow, target);
      if (auto failure = flow.step(target - flow.time())) {
        return {failure->stop_reason,
                failure->reason + " at t = " + std::to_string(flow.time()) + " s"};
      }
      gauge([&] { recorder.after_step(flow); });
      start.stepped(flow);
      frames.after_step(flow);
      if (flow.fluid().n == 0) {
        gauge([&] { recorder.sample(flow); });
        frames.end(flow);
        return {StopReason::drained, ""};
      }
    }
    gauge([&] { recorder.sample(flow); });
    start.sampled(flow, recorder);
    if (callbacks.on_progress &&
        !callbacks.on_progress({flow.time(), options.stop_time, flow.statistics().steps})) {
      return {StopReason::cancelled, "cancelled"};
    }
    if (const auto end = gauge([&] { return recorder.ended(flow); })) {
      frames.end(flow);
      return {*end, ""};
    }
  }
  frames.end(flow);
  return {StopReason::end_time, ""};
}

}  // namespace

RunOptions usual_run_options(const Scene& scene) {
  const RunOptions flume;
  const EventUnits unit = event_units(Scene{}, flume.gauges),
                   own = event_units(scene, flume.gauges);
  const double longer = own.time / unit.time;
  RunOptions options;
  options.stop_time *= longer;
  options.series_interval *= longer;
  options.settled.window *= longer;
  return options;
}

Result simulate(const Scene& scene, const Numerics& numerics, const RunOptions& options,
                const Callbacks& callbacks, StartStates* starts) {
  require_sound_input(scene, numerics, options);
  const auto start = std::chrono::steady_clock::now();
  StageTimer timer;
  FlowSetup setup = channel_setup(scene, numerics, options.threads);
  if (options.profile) setup.timer = &timer;
  Flow flow(std::move(setup));
  Recorder recorder(scene, flow, options);
  // frames and profiles are of the whole run
  const bool whole = options.profile || (frames_wanted(options) && callbacks.on_frame);
  SharedStart shared(whole ? nullptr : starts, scene, numerics, options);
  Ending ending = run(flow, recorder, shared, options, callbacks);
  Result result = finish(flow, recorder, ending.stop_reason, std::move(ending.reason));
  result.statistics.wall_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.profile) {
    result.profile = timer.profile();
    recorder.add_to(*result.profile);
  }
  return result;
}

}  // namespace parapet::solver
