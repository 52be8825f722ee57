#include "flow_outputs.hpp"

#include <algorithm>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/reports/flow_picture.hpp"
#include "parapet/reports/load_picture.hpp"

namespace parapet::cli {
namespace {

constexpr double default_frame_interval = 0.05;  // [s]

}  // namespace

std::vector<double> regular_times(double interval, double stop_time) {
  std::vector<double> times;
  for (double k = 0.0; k * interval <= stop_time; k += 1.0) times.push_back(k * interval);
  return times;
}

std::vector<double> merged_times(const std::vector<const std::vector<double>*>& lists) {
  std::vector<double> times;
  for (const std::vector<double>* list : lists) {
    times.insert(times.end(), list->begin(), list->end());
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

bool FlowOutputs::Clock::wants(const solver::Frame& frame) {
  if (frame.last) return true;
  if (next == times.size() || frame.time < times[next]) return false;
  ++next;
  return true;
}

FlowOutputs::FlowOutputs(const FlowWishes& wishes, const designs::CaseSpec& spec,
                         const std::filesystem::path& folder)
    : spec_(spec),
      folder_(folder),
      picture_(wishes.picture || !wishes.picture_times_s.empty()),
      moments_(wishes.picture_times_s) {
  const double in_spec = spec.run.frame_interval, stop_time = spec.run.stop_time;
  if (wishes.frames || wishes.frame_interval_s || in_spec > 0.0) {
    const double usual = in_spec > 0.0 ? in_spec : default_frame_interval;
    frame_clock_.times = regular_times(wishes.frame_interval_s.value_or(usual), stop_time);
    writer_.emplace(folder / "frames", spec.name, spec.scene, spec.run.gauges);
  }
  if (picture_) {
    picture_clock_.times = wishes.picture_times_s;
    std::ranges::sort(picture_clock_.times);
    if (picture_clock_.times.empty()) {
      picture_clock_.times = regular_times(spec.run.series_interval, stop_time);
    }
  }
  if (wishes.record || wishes.record_interval_s) {
    const double usual = records::recording_interval(spec.scene, stop_time);
    record_clock_.times = regular_times(wishes.record_interval_s.value_or(usual), stop_time);
    recording_.emplace(spec, spec.name);
  }
}

void FlowOutputs::ask(solver::RunOptions& run) const {
  run.frame_interval = 0.0;
  run.frame_times =
      merged_times({&frame_clock_.times, &picture_clock_.times, &record_clock_.times});
}

void FlowOutputs::offer(const solver::Frame& frame) {
  if (picture_ && picture_clock_.wants(frame)) moments_.offer(frame);
  if (writer_ && frame_clock_.wants(frame)) writer_->add(frame);
  if (recording_ && record_clock_.wants(frame)) recording_->add(frame);
}

void FlowOutputs::finish(const Session& session, const solver::Result& result) {
  if (writer_) {
    session.log->info("{} frames; open {} in ParaView", writer_->count(),
                      writer_->collection().string());
  }
  if (recording_) {
    const std::string file = records::simulation_recording;
    const std::size_t frames = recording_->count();
    records::write_file_atomically(folder_ / file, recording_->finish());
    session.log->info("recording of {} frames: {}", frames, (folder_ / file).string());
  }
  if (!picture_) return;
  for (const double time : moments_.not_reached()) {
    session.log->warn("no picture at {} s: the run ended before", time);
  }
  const auto snapshots = moments_.take(6);
  if (snapshots.empty()) return;
  const std::filesystem::path file = folder_ / "flow.png";
  reports::FlowPictureOptions picture;
  picture.title = spec_.name;
  reports::draw_flow(file, spec_.scene, spec_.numerics.spacing, snapshots, picture);
  session.log->info("picture: {}", file.string());
  if (!reports::acts_on_barriers(result)) return;
  reports::draw_load_profiles(folder_ / "pressure.png", spec_.name, result);
  session.log->info("picture: {}", (folder_ / "pressure.png").string());
}

}  // namespace parapet::cli
