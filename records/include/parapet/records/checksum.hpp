/// Checksums that tell a changed byte: of the lines of a log, and of whole files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "parapet/designs/case_spec.hpp"

namespace parapet::records {

/// CRC-32C (Castagnoli; RFC 3720, appendix B.4).
std::uint32_t crc32c(std::string_view bytes);

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// A JSON object on one line, without a line end, with the key "crc32c" added as the last one:
/// eight lower-case hexadecimal digits, the CRC-32C of all bytes of the line before the comma that
/// stands before "crc32c".
/// @param object not empty
std::string line_with_checksum(const designs::Json& object);

/// What the checksum of a line says.
enum class LineChecksum {
  right,
  wrong,
  none,  ///< the line does not end with one
};

/// Looks at a line without its line end.
LineChecksum check_line(std::string_view line);

}  // namespace parapet::records
