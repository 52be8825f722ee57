#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "parapet/records/deflate.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/scene_json.hpp"
#include "recording_codec.hpp"

namespace parapet::records {
namespace {

using designs::Json;

constexpr double most_count = std::numeric_limits<std::uint16_t>::max();
constexpr double zero_pressure = 32768.0;  // count of it: pressures may be negative

std::uint16_t count_of(double value) {
  if (!(value > 0.0)) return 0;  // and what is not a number
  return static_cast<std::uint16_t>(std::lround(std::min(value, most_count)));
}

/// The next of 1, 2, 5 times a power of ten.
double rounded_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= value * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

RecordingSteps recording_steps(const solver::Scene& scene, double spacing) {
  RecordingSteps steps;
  const double fall = std::sqrt(2.0 * scene.gravity * scene.reservoir_height);
  steps.origin = -16.0 * spacing;
  const double extent = std::max(scene.domain_length, scene.domain_height) + 32.0 * spacing;
  steps.length = std::max(spacing / 8.0, extent / most_count);
  steps.speed = fall / 200.0;
  steps.pressure = scene.material.density * scene.gravity * scene.reservoir_height / 200.0;
  steps.viscosity_ratio = std::exp2(0.125);
  steps.least_viscosity = 1e-3;
  steps.rest_speed = 0.01 * fall;
  return steps;
}

double recording_interval(const solver::Scene& scene, double stop_time) {
  const double natural = std::sqrt(scene.reservoir_height / scene.gravity) / 7.2;
  return rounded_up(std::max(natural, stop_time / 300.0));
}

RecordingWriter::RecordingWriter(const designs::CaseSpec& spec, const std::string& name)
    : steps_(recording_steps(spec.scene, spec.numerics.spacing)) {
  header_ = {{"format", "parapet-recording/1"},
             {"name", name},
             {"case_hash", case_hash(spec)},
             {"spacing_m", spec.numerics.spacing},
             {"steps",
              {{"length_m", steps_.length},
               {"origin_m", steps_.origin},
               {"speed_m_s", steps_.speed},
               {"pressure_pa", steps_.pressure},
               {"viscosity_ratio", steps_.viscosity_ratio},
               {"least_viscosity_pa_s", steps_.least_viscosity},
               {"rest_speed_m_s", steps_.rest_speed}}},
             {"scene", scene_json(spec.scene)},
             {"frames_per_chunk", frames_per_chunk},
             {"chunk_bytes", Json::array()}};
}

void RecordingWriter::add(const solver::Frame& frame) {
  const std::size_t n = frame.id.size();
  for (const auto& one : {frame.x, frame.z, frame.u, frame.w, frame.pressure, frame.viscosity}) {
    if (one.size() != n) throw std::invalid_argument("a frame's arrays must have one length");
  }
  if (!times_.empty() && frame.time <= times_.back()) return;
  if (times_.empty()) {
    for (const std::int32_t id : frame.id) {
      particles_ = std::max(particles_, static_cast<std::size_t>(id) + 1);
    }
    latest_.assign(n_recorded_fields * particles_, 0);
  }
  const std::size_t size = n_recorded_fields * particles_;
  codes_.insert(codes_.end(), latest_.begin(), latest_.end());
  flags_.resize(flags_.size() + particles_, 0);
  std::uint16_t* const codes = codes_.data() + in_chunk_ * size;
  std::uint8_t* const flags = flags_.data() + in_chunk_ * particles_;
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(frame.id[k]);
    if (times_.empty() && k == 0) reach_ = {frame.x[k], frame.z[k], frame.x[k], frame.z[k]};
    reach_ = {std::min(reach_[0], frame.x[k]), std::min(reach_[1], frame.z[k]),
              std::max(reach_[2], frame.x[k]), std::max(reach_[3], frame.z[k])};
    if (i >= particles_)
      throw std::invalid_argument("a frame has a particle that was not released");
    const double v = std::hypot(frame.u[k], frame.w[k]);
    const double eta = frame.viscosity[k] / steps_.least_viscosity;
    codes[place_x * particles_ + i] = count_of((frame.x[k] - steps_.origin) / steps_.length);
    codes[place_z * particles_ + i] = count_of((frame.z[k] - steps_.origin) / steps_.length);
    codes[speed * particles_ + i] = count_of(v / steps_.speed);
    codes[pressure * particles_ + i] =
        count_of(frame.pressure[k] / steps_.pressure + zero_pressure);
    codes[viscosity * particles_ + i] =
        eta > 1.0 ? count_of(std::log(eta) / std::log(steps_.viscosity_ratio)) : std::uint16_t{0};
    flags[i] = static_cast<std::uint8_t>(flag_present | (v < steps_.rest_speed ? flag_at_rest : 0));
  }
  std::copy(codes, codes + size, latest_.begin());
  times_.push_back(frame.time);
  if (++in_chunk_ == frames_per_chunk) compress_chunk();
}

// The low bytes of a field, then its high ones, all frames of the chunk; at last the flags.
void RecordingWriter::compress_chunk() {
  if (in_chunk_ == 0) return;
  const std::size_t plane = in_chunk_ * particles_;
  std::vector<std::uint8_t> bytes((2 * n_recorded_fields + 1) * plane);
  for (std::size_t field = 0; field < n_recorded_fields; ++field) {
    std::uint8_t* const low = bytes.data() + 2 * field * plane;
    for (std::size_t frame = 0; frame < in_chunk_; ++frame) {
      for (std::size_t i = 0; i < particles_; ++i) {
        const unsigned code = codes_[code_place(particles_, frame, field, i)];
        const unsigned expected = predicted(codes_, particles_, frame, field, i);
        const std::uint16_t word = zigzag(static_cast<std::uint16_t>(code - expected));
        low[frame * particles_ + i] = static_cast<std::uint8_t>(word & 0xFFU);
        low[plane + frame * particles_ + i] = static_cast<std::uint8_t>(word >> 8U);
      }
    }
  }
  std::copy(flags_.begin(), flags_.end(),
            bytes.begin() + static_cast<std::ptrdiff_t>(2 * n_recorded_fields * plane));
  const std::string chunk = deflated(bytes);
  header_["chunk_bytes"].push_back(chunk.size());
  data_ += chunk;
  in_chunk_ = 0;
  codes_.clear();
  flags_.clear();
}

std::string RecordingWriter::finish() {
  compress_chunk();
  header_["particles"] = particles_;
  header_["reach_m"] = reach_;
  header_["times_s"] = times_;
  const std::string header = header_.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string bytes = "PARAPET\n";
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((header.size() >> shift) & 0xFFU);
  }
  return bytes + header + data_;
}

}  // namespace parapet::records
