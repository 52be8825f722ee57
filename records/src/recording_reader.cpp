#include <cmath>
#include <stdexcept>

#include "parapet/records/deflate.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/records/whole_number.hpp"
#include "recording_codec.hpp"

namespace parapet::records {
namespace {

using designs::Json;

constexpr std::string_view magic = "PARAPET\n";
constexpr std::size_t most_particles = 20'000'000;
constexpr std::size_t head = magic.size() + 4;

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("is no recording: " + what);
}

std::size_t header_size(std::string_view bytes) {
  if (bytes.size() < head || !bytes.starts_with(magic)) refuse("it does not begin as one");
  std::size_t size = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    size |= std::size_t{static_cast<unsigned char>(bytes[magic.size() + k])} << (8 * k);
  }
  if (size > bytes.size() - head) refuse("it is cut off");
  return size;
}

/// What the codes of a chunk were before compression.
std::vector<std::uint16_t> codes_of(const std::vector<std::uint8_t>& bytes, std::size_t particles,
                                    std::size_t frames) {
  const std::size_t plane = frames * particles;
  std::vector<std::uint16_t> codes(n_recorded_fields * plane);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t field = 0; field < n_recorded_fields; ++field) {
      const std::size_t low = 2 * field * plane + frame * particles;
      for (std::size_t i = 0; i < particles; ++i) {
        const unsigned word = bytes[low + i] | unsigned{bytes[low + plane + i]} << 8U;
        codes[code_place(particles, frame, field, i)] =
            static_cast<std::uint16_t>(predicted(codes, particles, frame, field, i) +
                                       unsigned{unzigzag(static_cast<std::uint16_t>(word))});
      }
    }
  }
  return codes;
}

class Decoder {
 public:
  explicit Decoder(const Json& header) : particles_(header.at("particles").get<std::size_t>()) {
    const Json& steps = header.at("steps");
    length_ = steps.at("length_m").get<double>();
    origin_ = steps.at("origin_m").get<double>();
    speed_ = steps.at("speed_m_s").get<double>();
    pressure_ = steps.at("pressure_pa").get<double>();
    ratio_ = steps.at("viscosity_ratio").get<double>();
    least_ = steps.at("least_viscosity_pa_s").get<double>();
  }

  RecordedFrame frame(double time, const std::uint16_t* codes, const std::uint8_t* flags) const {
    RecordedFrame frame;
    frame.time = time;
    for (std::size_t i = 0; i < particles_; ++i) {
      if ((flags[i] & flag_present) == 0) continue;
      const auto code = [&](std::size_t field) { return double(codes[field * particles_ + i]); };
      frame.id.push_back(static_cast<std::int32_t>(i));
      frame.x.push_back(origin_ + length_ * code(place_x));
      frame.z.push_back(origin_ + length_ * code(place_z));
      frame.speed.push_back(speed_ * code(records::speed));
      frame.pressure.push_back(pressure_ * (code(records::pressure) - 32768.0));
      frame.viscosity.push_back(least_ * std::pow(ratio_, code(records::viscosity)));
      frame.at_rest.push_back((flags[i] & flag_at_rest) != 0 ? 1 : 0);
    }
    return frame;
  }

 private:
  std::size_t particles_;
  double length_ = 0.0, origin_ = 0.0, speed_ = 0.0, pressure_ = 0.0, ratio_ = 0.0, least_ = 0.0;
};

FlowRecording decoded(std::string_view bytes) {
  FlowRecording recording{.header = recording_header(bytes), .frames = {}};
  const auto particles = recording.header.at("particles").get<std::size_t>();
  const auto times = recording.header.at("times_s").get<std::vector<double>>();
  const auto chunk_bytes = recording.header.at("chunk_bytes").get<std::vector<std::size_t>>();
  if (particles > most_particles) refuse("it has more particles than a simulation may have");
  if (recording.header.at("frames_per_chunk") != frames_per_chunk) refuse("its chunks are unknown");
  if (chunk_bytes.size() != (times.size() + frames_per_chunk - 1) / frames_per_chunk) {
    refuse("times and chunks do not fit together");
  }
  const Decoder decoder(recording.header);
  std::string_view rest = bytes.substr(head + header_size(bytes));
  for (std::size_t chunk = 0; chunk < chunk_bytes.size(); ++chunk) {
    if (chunk_bytes[chunk] > rest.size()) refuse("it is cut off");
    const std::size_t first = chunk * frames_per_chunk;
    const std::size_t frames = std::min(frames_per_chunk, times.size() - first);
    const std::size_t plane = frames * particles;
    const auto raw =
        inflated(rest.substr(0, chunk_bytes[chunk]), (2 * n_recorded_fields + 1) * plane);
    rest.remove_prefix(chunk_bytes[chunk]);
    const auto codes = codes_of(raw, particles, frames);
    const std::uint8_t* const flags = raw.data() + 2 * n_recorded_fields * plane;
    for (std::size_t k = 0; k < frames; ++k) {
      recording.frames.push_back(decoder.frame(
          times[first + k], codes.data() + code_place(particles, k, 0, 0), flags + k * particles));
    }
  }
  if (!rest.empty()) refuse("something follows its end");
  return recording;
}

}  // namespace

Json recording_header(std::string_view bytes) {
  const std::size_t size = header_size(bytes);
  Json header = Json::parse(bytes.substr(head, size), nullptr, false);
  if (!header.is_object() || header.value("format", "") != "parapet-recording/1") {
    refuse("its header is not that of one");
  }
  return header;
}

FlowRecording read_recording(std::string_view bytes) {
  try {
    return decoded(bytes);
  } catch (const Json::exception& error) {
    refuse(error.what());
  }
}

}  // namespace parapet::records
