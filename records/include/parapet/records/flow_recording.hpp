/// A flow to look at again: places, speed, pressure, viscosity and rest of every particle, rounded
/// to what an eye can tell, in a tenth of the bytes. docs/recordings.md describes the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "parapet/designs/case_spec.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::records {

/// What one count of each quantity stands for.
struct RecordingSteps {
  double length = 0.0;           ///< [m]: an eighth of the particle spacing
  double speed = 0.0;            ///< [m/s]: sqrt(2 g H0)/200, H0 the height of the released block
  double pressure = 0.0;         ///< [Pa]: rho_0 g H0/200
  double viscosity_ratio = 0.0;  ///< factor from one count to the next: 2^(1/8)
  double least_viscosity = 0.0;  ///< of count 0 [Pa s]
  double rest_speed = 0.0;       ///< a particle below it is at rest: 1 % of sqrt(2 g H0) [m/s]
  double origin = 0.0;           ///< channel x and z of count 0 [m]
};

/// For a case.
RecordingSteps recording_steps(const solver::Scene& scene, double spacing);

/// Interval between the frames of a recording [s]: at least sqrt(H0/g)/7, at most 300 frames until
/// the stop time, rounded up to 1, 2 or 5 times a power of ten; 0.02 s for the source's flume.
double recording_interval(const solver::Scene& scene, double stop_time);

/// Makes a recording from frames as they come.
class RecordingWriter {
 public:
  /// @param name of the case
  RecordingWriter(const designs::CaseSpec& spec, const std::string& name);

  /// Takes a frame; its time must be later than that of the one before, else it is passed over.
  /// @throws std::invalid_argument for an id out of 0 .. n_released - 1, or arrays of unequal
  /// length
  void add(const solver::Frame& frame);

  /// Number of frames taken.
  std::size_t count() const { return times_.size(); }

  /// The bytes of the file; nothing may be added afterwards.
  std::string finish();

 private:
  void compress_chunk();

  designs::Json header_;
  RecordingSteps steps_;
  std::size_t particles_ = 0;      // at release; known with the first frame
  std::vector<double> times_;      // of all frames [s]
  std::array<double, 4> reach_{};  // least x and z, greatest x and z of any particle [m]
  std::size_t in_chunk_ = 0;
  std::vector<std::uint16_t> codes_;   // [frame in chunk][field][particle]
  std::vector<std::uint8_t> flags_;    // [frame in chunk][particle]
  std::vector<std::uint16_t> latest_;  // [field][particle], of the frame before
  std::string data_;
};

/// One frame as it is read back.
struct RecordedFrame {
  double time = 0.0;                  ///< [s]
  std::vector<std::int32_t> id;       ///< of the particles that are still there, ascending
  std::vector<double> x, z;           ///< [m]
  std::vector<double> speed;          ///< [m/s]
  std::vector<double> pressure;       ///< [Pa]
  std::vector<double> viscosity;      ///< [Pa s]
  std::vector<std::uint8_t> at_rest;  ///< 1: slower than RecordingSteps::rest_speed
};

/// A recording read back.
struct FlowRecording {
  designs::Json header;  ///< format "parapet-recording/1"
  std::vector<RecordedFrame> frames;
};

/// @throws std::runtime_error saying what is wrong with the bytes
FlowRecording read_recording(std::string_view bytes);

/// The header alone, without looking at the frames; throws the same.
designs::Json recording_header(std::string_view bytes);

}  // namespace parapet::records
