/// zlib's compressed format (RFC 1950): what browsers call "deflate".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace parapet::records {

/// The compressed bytes.
std::string deflated(std::span<const std::uint8_t> bytes);

/// The bytes again.
/// @throws std::runtime_error unless they are the stream of exactly `size` bytes
std::vector<std::uint8_t> inflated(std::string_view bytes, std::size_t size);

}  // namespace parapet::records
