/// What `simulate` keeps of the flow beside its numbers: ParaView frames, a picture, a recording.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "parapet/designs/case_spec.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/reports/vtk_frames.hpp"
#include "parapet/solver/simulation.hpp"
#include "picture_moments.hpp"
#include "session.hpp"

namespace parapet::cli {

/// What is asked for.
struct FlowWishes {
  bool frames = false;
  std::optional<double> frame_interval_s;
  bool picture = false;
  std::vector<double> picture_times_s;
  bool record = false;
  std::optional<double> record_interval_s;
};

/// Times k interval from 0 to the stop time [s].
std::vector<double> regular_times(double interval, double stop_time);

/// Several ascending lists as one, each time once [s].
std::vector<double> merged_times(const std::vector<const std::vector<double>*>& lists);

/// Takes the frames of one run, each output at its own times.
class FlowOutputs {
 public:
  /// `spec` must outlive it.
  FlowOutputs(const FlowWishes& wishes, const designs::CaseSpec& spec,
              const std::filesystem::path& folder);

  /// Asks the solver for every time at which an output wants a frame.
  void ask(solver::RunOptions& run) const;

  /// Whether anything is wanted.
  bool any() const { return writer_ || recording_ || picture_; }

  /// For Callbacks::on_frame.
  void offer(const solver::Frame& frame);

  /// Writes the recording and draws the pictures; says what was written.
  void finish(const Session& session, const solver::Result& result);

 private:
  /// Whether an output with these times wants a frame; the last state is wanted by all.
  struct Clock {
    std::vector<double> times;  // [s]
    std::size_t next = 0;
    bool wants(const solver::Frame& frame);
  };

  const designs::CaseSpec& spec_;
  std::filesystem::path folder_;
  bool picture_;
  PictureMoments moments_;
  std::optional<reports::FrameWriter> writer_;
  std::optional<records::RecordingWriter> recording_;
  Clock frame_clock_, picture_clock_, record_clock_;
};

}  // namespace parapet::cli
