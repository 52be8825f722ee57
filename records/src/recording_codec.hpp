/// How the numbers of a recording become bytes, and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace parapet::records {

/// Fields with a count per particle, in this order.
enum RecordedField : std::size_t {
  place_x,
  place_z,
  speed,
  pressure,
  viscosity,
  n_recorded_fields
};

/// Frames that are compressed together; the first of them stands for itself.
constexpr std::size_t frames_per_chunk = 16;

constexpr std::uint8_t flag_present = 1, flag_at_rest = 2;

/// Where a value of a chunk stands: [frame][field][particle].
constexpr std::size_t code_place(std::size_t particles, std::size_t frame, std::size_t field,
                                 std::size_t particle) {
  return (frame * n_recorded_fields + field) * particles + particle;
}

/// What a count is expected to be from those before it. Places go on as they went, other
/// quantities stay; the first frame of a chunk follows the particle before. Modulo 2^16.
inline std::uint16_t predicted(std::span<const std::uint16_t> codes, std::size_t particles,
                               std::size_t frame, std::size_t field, std::size_t particle) {
  const auto at = [&](std::size_t f, std::size_t i) {
    return static_cast<unsigned>(codes[code_place(particles, f, field, i)]);
  };
  if (frame == 0) return static_cast<std::uint16_t>(particle == 0 ? 0U : at(0, particle - 1));
  const unsigned last = at(frame - 1, particle);
  const bool moves = field == place_x || field == place_z;
  if (frame == 1 || !moves) return static_cast<std::uint16_t>(last);
  return static_cast<std::uint16_t>(2U * last - at(frame - 2, particle));
}

/// Small differences of either sign as small numbers: 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
constexpr std::uint16_t zigzag(std::uint16_t difference) {
  const auto value = static_cast<std::int16_t>(difference);
  return static_cast<std::uint16_t>((static_cast<unsigned>(value) << 1U) ^
                                    (value < 0 ? 0xFFFFU : 0U));
}

constexpr std::uint16_t unzigzag(std::uint16_t code) {
  return static_cast<std::uint16_t>((code >> 1U) ^ ((code & 1U) != 0 ? 0xFFFFU : 0U));
}

}  // namespace parapet::records
